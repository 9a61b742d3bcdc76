"""Pretends that the instructor pressed Ctrl-C, while it is imported.

earns: nothing
"""

raise KeyboardInterrupt


def add(a, b):
    return None


class Counter:
    def __init__(self, count):
        self.count = None

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    return None
