"""Hands an object to the given function that calls the function again.

earns: add counter
"""


def total_of(f, n):
    class Pong:
        def __mul__(self, other):
            return f(self)

        __rmul__ = __add__ = __radd__ = __mul__

    return f(Pong())


def add(a, b):
    return a + b


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        self.count += by

    def __add__(self, other):
        return Counter(self.count + other.count)
