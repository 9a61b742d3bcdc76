"""Sleeps, and uses no processor time at all.

earns: counter total
says: did not finish
"""

import time


def add(a, b):
    time.sleep(1_000_000)
