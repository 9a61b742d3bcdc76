"""Pretends that the instructor pressed Ctrl-C.

earns: counter total
"""


def add(a, b):
    raise KeyboardInterrupt
