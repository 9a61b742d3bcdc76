"""Hands an object to the given function that calls the function again.

earns: add counter
"""


def total_of(f, n):
    class Pong:
        def __mul__(self, other):
            return f(self)

        __rmul__ = __add__ = __radd__ = __mul__

    return f(Pong())
