"""A regular expression that takes for ever to fail.

earns: add total
says: did not finish
"""

import re


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        re.match(r"(a+)+$", "a" * 60 + "b")
        self.count += by


def add(a, b):
    return a + b


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(i) for i in range(n))
