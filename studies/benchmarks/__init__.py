"""The measurements of make bench: one module per subject, each with a function ``lines``."""
