"""Running checks, and putting what went wrong into words."""
