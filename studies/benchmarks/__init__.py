"""The measurements of make bench, one subject per module, each with a function ``lines``."""
