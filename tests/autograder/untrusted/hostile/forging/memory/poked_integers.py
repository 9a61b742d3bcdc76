"""Overwrites small integers, so that its process counts wrongly.

earns: counter total
"""

import ctypes


def add(a, b):
    for number in range(2, 60):
        ctypes.c_uint32.from_address(id(number) + 24).value = 1
