"""Give students the reference solution after the deadline, to compare it with their own code."""
