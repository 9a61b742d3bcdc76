"""Exchange submissions and grades with Gradescope, GitHub Classroom, Canvas and Moodle."""
