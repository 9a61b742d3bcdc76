"""Release the reference after the deadline, next to each student's own passing solutions."""
