"""Leaves threads behind that never end; the answers are right.

earns: all
"""

import threading
import time


def idle():
    while True:
        time.sleep(0.01)


def add(a, b):
    try:
        for _ in range(20):
            threading.Thread(target=idle).start()
    except BaseException:
        pass
    return a + b


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
