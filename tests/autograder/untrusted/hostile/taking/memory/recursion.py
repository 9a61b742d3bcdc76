"""Calls itself without end, after lifting the limit on that.

earns: counter total
"""

import sys

sys.setrecursionlimit(2**31 - 1)


def add(a, b):
    return add(a, b) + 1
