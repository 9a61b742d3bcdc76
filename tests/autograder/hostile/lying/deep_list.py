"""Returns a list that is nested a hundred thousand deep.

earns: nothing
"""

RIGHT = []
for _ in range(100_000):
    RIGHT = [RIGHT]


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
