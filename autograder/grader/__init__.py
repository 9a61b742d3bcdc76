"""Grade the submissions of a class, on one machine or on a cluster."""
