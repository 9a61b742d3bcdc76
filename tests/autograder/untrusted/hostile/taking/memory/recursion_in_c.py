"""Overflows the stack of C.

earns: add total
"""

import sys

sys.setrecursionlimit(2**31 - 1)


class Counter:
    def __init__(self, count):
        self.count = count

    def __repr__(self):
        return repr([self])

    def step(self, by):
        repr(self)
