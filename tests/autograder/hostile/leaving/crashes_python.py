"""Reads an address that is not there.

earns: add counter
"""

import ctypes


def total_of(f, n):
    ctypes.string_at(0)


def add(a, b):
    return a + b


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        self.count += by

    def __add__(self, other):
        return Counter(self.count + other.count)
