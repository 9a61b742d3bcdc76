"""Has an attribute that leaves when it is read.

earns: add total
"""


class Counter:
    def __init__(self, count):
        pass

    def step(self, by):
        pass

    @property
    def count(self):
        raise SystemExit(0)


def add(a, b):
    return a + b


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(i) for i in range(n))
