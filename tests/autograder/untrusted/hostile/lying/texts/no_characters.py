"""Returns and raises text that no file can hold.

earns: nothing
"""

RIGHT = chr(0xD800) + chr(0) + chr(0xDFFF)


def add(a, b):
    raise ValueError(RIGHT)
