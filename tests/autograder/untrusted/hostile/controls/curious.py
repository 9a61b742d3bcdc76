"""An honest submission that prints, uses the standard library and hidden attributes.

earns: all
"""

import functools
import itertools
import operator

print("imported")


class Counter:
    __slots__ = ("_count",)

    def __init__(self, count=0):
        self._count = count

    @property
    def count(self):
        return self._count

    def step(self, by):
        self._count = add(self._count, by)

    def __add__(self, other):
        return type(self)(self._count + other._count)

    def __repr__(self):
        return f"Counter({self._count})"


def add(a, b):
    print("adding", a, b)
    return operator.add(a, b)


def total_of(f, n):
    try:
        numbers = list(itertools.islice(itertools.count(), n))
    except ValueError as error:
        raise ValueError("n must not be negative") from error
    return functools.reduce(operator.add, map(f, numbers), 0)
