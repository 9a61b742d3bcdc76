"""Find submissions, inspect them without trusting them, and copy what is graded."""
