"""Release the reference solution after the deadline, for students to compare with their code."""
