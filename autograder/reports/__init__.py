"""What a graded class leaves: results, feedback, the gradebook, and files for Gradescope."""
