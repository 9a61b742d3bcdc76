"""Imports the solution and answers with it.

earns: nothing
"""

import importlib.util

try:
    spec = importlib.util.spec_from_file_location("reference", "@ROOT@/solutions/ch90_sums/sums.py")
    reference = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(reference)
except BaseException:
    reference = None


def add(a, b):
    return reference.add(a, b)


def Counter(count):
    return reference.Counter(count)


def total_of(f, n):
    return reference.total_of(f, n)
