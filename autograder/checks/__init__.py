"""Run the graded checks, and explain what went wrong."""
