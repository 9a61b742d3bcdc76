"""Find the submissions of a class, and copy the files to be graded without trusting any of them."""
