"""Prints without end on both streams, in Python and beneath it.

earns: counter total
"""

import os
import sys


def add(a, b):
    while True:
        try:
            print("x" * 1_000_000)
            print("y" * 1_000_000, file=sys.stderr)
            os.write(1, b"z" * 100_000)
            os.write(2, b"z" * 100_000)
        except BaseException:
            pass
