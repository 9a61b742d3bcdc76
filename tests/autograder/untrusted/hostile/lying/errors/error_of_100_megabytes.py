"""Raises an exception with a message of a hundred megabytes.

earns: counter total
"""


def add(a, b):
    raise ValueError("x" * 100_000_000)
