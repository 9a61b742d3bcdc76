"""Aborts the process, which would leave a core file.

earns: add total
"""

import os


class Counter:
    def __init__(self, count):
        os.abort()


def add(a, b):
    return a + b


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(i) for i in range(n))
