"""Run the checks on a student's own machine, under the same restrictions as in the grader."""
