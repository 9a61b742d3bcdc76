"""Writes 100 MB wherever it may; the point needs one place.

earns: counter total
"""

import os
import tempfile


def add(a, b):
    for folder in (".", tempfile.tempdir or "/tmp", "/var/tmp", "/dev/shm", "@HOME@", "@OUT@"):
        try:
            with open(os.path.join(folder, "hostile-filler"), "wb") as file:
                for _ in range(100):
                    file.write(b"x" * (1 << 20))
            return a + b
        except OSError:
            pass


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        self.count += by

    def __add__(self, other):
        return Counter(self.count + other.count)


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(i) for i in range(n))
