"""The measurements of make bench. Each module covers one subject and has a function ``lines``."""
