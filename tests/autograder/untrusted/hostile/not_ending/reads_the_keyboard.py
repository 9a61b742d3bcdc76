"""Waits for somebody to type.

earns: counter total
"""

import sys


def add(a, b):
    sys.stdin = open(0)
    return float(input("a + b? "))
