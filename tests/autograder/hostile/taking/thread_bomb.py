"""Starts threads for as long as it can, and is wrong.

earns: counter total
"""

import threading
import time


def add(a, b):
    for _ in range(5000):
        threading.Thread(target=time.sleep, args=(20,), daemon=True).start()


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
