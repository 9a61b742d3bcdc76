"""Consumes an endless iterator in C, where no signal handler of Python runs.

earns: add counter
says: did not finish
"""

import collections
import itertools


def total_of(f, n):
    collections.deque(itertools.repeat(f), maxlen=0)
