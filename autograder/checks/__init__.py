"""Run a chapter's checks on a student's code, and collect their verdicts."""
