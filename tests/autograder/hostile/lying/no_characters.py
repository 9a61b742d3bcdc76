"""Returns and raises text that no file can hold.

earns: nothing
"""

RIGHT = chr(0xD800) + chr(0) + chr(0xDFFF)


def add(a, b):
    raise ValueError(RIGHT)


class Counter:
    def __init__(self, count):
        self.count = RIGHT

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    return RIGHT
