"""Explain why a check failed: the mistake in the student's code, or in an earlier chapter."""
