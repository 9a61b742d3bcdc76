"""Run the checks in the student's own Python, with only what the grader allows."""
