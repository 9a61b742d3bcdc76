"""Raises an exception with a message of a hundred megabytes.

earns: counter total
"""


def add(a, b):
    raise ValueError("x" * 100_000_000)


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
