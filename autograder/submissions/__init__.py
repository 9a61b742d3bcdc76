"""Find the submissions of a class, and copy the files to be graded. No submission is trusted."""
