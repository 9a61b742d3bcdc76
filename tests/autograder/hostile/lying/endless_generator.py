"""Returns a generator that never ends.

earns: nothing
"""

import itertools

RIGHT = itertools.count()


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
