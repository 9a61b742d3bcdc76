"""Sets an alarm that ends the process a little later, and does no work.

earns: nothing
"""

import signal

signal.setitimer(signal.ITIMER_REAL, 0.001, 0.001)
while True:
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
