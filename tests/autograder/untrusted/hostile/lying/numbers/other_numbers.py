"""Returns exact numbers of other types, which are not plain floats.

earns: nothing
"""

from decimal import Decimal
from fractions import Fraction


def add(a, b):
    return Fraction(a) + Fraction(b)


class Counter:
    def __init__(self, count):
        self.count = Decimal(count)

    def step(self, by):
        self.count += Decimal(by)

    def __add__(self, other):
        return Counter(self.count + other.count)


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return complex(sum(f(i) for i in range(n)))
