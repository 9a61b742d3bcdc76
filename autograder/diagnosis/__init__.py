"""Find the mistake behind a failed check, in the student's code or in an earlier chapter."""
