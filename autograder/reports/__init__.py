"""The output of grading: results, feedback, the gradebook, and files for Gradescope."""
