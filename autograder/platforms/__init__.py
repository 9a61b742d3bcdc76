"""Work with the platforms of instructors: Gradescope, GitHub Classroom, Canvas and Moodle."""
