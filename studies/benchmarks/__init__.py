"""The measurements of make bench. Each module is about one subject and has a function ``lines``."""
