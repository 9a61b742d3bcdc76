"""Returns a string of a hundred million letters.

earns: nothing
"""


class Long:
    def __mul__(self, other):
        return "x" * 100_000_000


def add(a, b):
    return "x" * 100_000_000


class Counter:
    def __init__(self, count):
        self.count = "y" * 100_000_000

    def step(self, by):
        pass

    def __add__(self, other):
        return self
