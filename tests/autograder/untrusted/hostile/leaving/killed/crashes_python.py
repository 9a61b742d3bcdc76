"""Reads an address that is not there.

earns: add counter
"""

import ctypes


def total_of(f, n):
    ctypes.string_at(0)
