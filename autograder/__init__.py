"""Check, grade and hand out the chapters of the companion."""
