"""Write the results of grading: a page for each student, a gradebook, and files for Gradescope."""
