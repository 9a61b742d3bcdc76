"""Run the checks of a chapter on a student's code, and explain to the student what went wrong."""
