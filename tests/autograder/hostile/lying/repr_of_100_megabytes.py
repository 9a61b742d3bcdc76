"""Returns an object with a text of a hundred megabytes.

earns: nothing
"""


class Wrong:
    def __repr__(self):
        return "x" * 100_000_000

    __str__ = __repr__


RIGHT = Wrong()


def add(a, b):
    return RIGHT


class Counter:
    def __init__(self, count):
        self.count = RIGHT

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    return RIGHT
