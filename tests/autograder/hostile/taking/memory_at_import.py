"""Takes all memory while it is imported.

earns: nothing
"""

PIECES = [bytearray(b"x") * (1 << 20) for _ in range(1000)]


def add(a, b):
    return None


class Counter:
    def __init__(self, count):
        self.count = None

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    return None
