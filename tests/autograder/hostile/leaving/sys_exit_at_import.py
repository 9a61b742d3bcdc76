"""Leaves by sys.exit while it is imported.

earns: nothing
says: SystemExit
"""

import sys

sys.exit(0)


def add(a, b):
    return None


class Counter:
    def __init__(self, count):
        self.count = None

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    return None
