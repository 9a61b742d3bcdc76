"""Release the reference after the deadline, so that students can compare it with their code."""
