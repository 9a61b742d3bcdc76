"""Is never done with being imported.

earns: nothing
says: did not finish
"""

import itertools

for number in itertools.count():
    pass


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
