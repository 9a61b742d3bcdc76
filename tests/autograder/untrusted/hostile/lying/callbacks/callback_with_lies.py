"""Calls the given function with numbers that claim to be others, in the wrong order.

earns: add counter
"""


class Sly(int):
    __eq__ = lambda self, other: True
    __ne__ = lambda self, other: False
    __hash__ = int.__hash__


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(Sly(i)) for i in reversed(range(n)))
