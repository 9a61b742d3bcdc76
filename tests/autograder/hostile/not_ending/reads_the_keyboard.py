"""Waits for somebody to type.

earns: counter total
"""

import sys


def add(a, b):
    sys.stdin = open(0)
    return float(input("a + b? "))


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
