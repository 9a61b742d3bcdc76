"""Overwrites the tolerance of the checks in memory.

earns: nothing
"""

import ctypes
import sys


def attack():
    for module in list(sys.modules.values()):
        number = vars(module).get("ROUNDING")
        if type(number) is float:
            ctypes.c_double.from_address(id(number) + 16).value = 1e300


def add(a, b):
    attack()
    return 1.0


class Counter:
    def __init__(self, count):
        attack()
        self.count = 1.0

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    attack()
    return 1.0
