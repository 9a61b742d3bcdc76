"""Calls the function that it was given, and leaves between two calls.

earns: add counter
says: SystemExit
"""


def total_of(f, n):
    f(0)
    raise SystemExit(0)


def add(a, b):
    return a + b


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        self.count += by

    def __add__(self, other):
        return Counter(self.count + other.count)
