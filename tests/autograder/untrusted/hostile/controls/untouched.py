"""A stub that nobody has worked on.

earns: nothing
says: not written yet
"""


def add(a, b):
    raise NotImplementedError("Exercise B90.1: Add two numbers")


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        raise NotImplementedError("Exercise B90.2: A counter")

    def __add__(self, other):
        raise NotImplementedError("Exercise B90.2: A counter")


def total_of(f, n):
    raise NotImplementedError("Exercise B90.3: The total of a function")
