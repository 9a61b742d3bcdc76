"""Grading where instructors are: Gradescope and GitHub Classroom."""
