"""Returns an integer of millions of digits, which takes long to print.

earns: nothing
"""

RIGHT = 1 << 30_000_000


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
