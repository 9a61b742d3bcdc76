"""Raises an exception with a hundred thousand lines.

earns: counter total
"""


def add(a, b):
    raise ValueError((chr(10) + "got       the right answer") * 100_000)
