"""Find the submissions of a class, inspect them without trusting them, and copy what is graded."""
