"""Reads its own file and its probes, which it may.

earns: all
"""

import pathlib


def add(a, b):
    for path in (pathlib.Path(__file__), pathlib.Path(__file__).with_name("probes.py")):
        try:
            path.read_text()
        except OSError:
            pass
    return a + b


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
