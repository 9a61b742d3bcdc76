"""Calls the function that it was given, and leaves between two calls.

earns: add counter
says: SystemExit
"""


def total_of(f, n):
    f(0)
    raise SystemExit(0)
