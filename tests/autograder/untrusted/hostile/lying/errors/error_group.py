"""Raises a group of many errors, nested deeply.

earns: counter total
"""


def add(a, b):
    error = ValueError("inside")
    for _ in range(500):
        error = ExceptionGroup("group", [error, TypeError("beside")])
    raise error
