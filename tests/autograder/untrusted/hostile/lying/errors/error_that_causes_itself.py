"""Raises exceptions that cause one another, with notes without end.

earns: counter total
"""


def add(a, b):
    first, second = ValueError("first"), ValueError("second")
    first.__cause__, second.__cause__ = second, first
    first.__context__, second.__context__ = second, first
    first.__notes__ = ["note"] * 1_000_000
    raise first
