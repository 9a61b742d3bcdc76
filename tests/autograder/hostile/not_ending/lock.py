"""Waits for a lock that it holds itself.

earns: counter total
says: did not finish
"""

import threading


def add(a, b):
    lock = threading.Lock()
    lock.acquire()
    lock.acquire()


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
