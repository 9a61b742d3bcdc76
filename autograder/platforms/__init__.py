"""Exchange files with Gradescope, GitHub Classroom, Canvas and Moodle."""
