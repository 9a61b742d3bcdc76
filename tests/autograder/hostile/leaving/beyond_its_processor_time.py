"""Ignores the signal of the limit of processor time, and goes on.

earns: nothing
"""

import signal

signal.signal(signal.SIGXCPU, signal.SIG_IGN)


def add(a, b):
    while True:
        pass


class Counter:
    def __init__(self, count):
        self.count = None

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    return None
