"""Raises a group of many errors, nested deeply.

earns: counter total
"""


def add(a, b):
    error = ValueError("inside")
    for _ in range(500):
        error = ExceptionGroup("group", [error, TypeError("beside")])
    raise error


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        self.count += by

    def __add__(self, other):
        return Counter(self.count + other.count)


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(i) for i in range(n))
