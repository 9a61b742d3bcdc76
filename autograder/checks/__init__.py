"""Run a chapter's checks on a student's code, and explain to the student what went wrong."""
