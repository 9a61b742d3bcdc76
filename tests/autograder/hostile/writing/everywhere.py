"""Leaves a file wherever files are often allowed; its own answers are right.

earns: all
"""

import os
import tempfile

for folder in (
    "/tmp",
    "/var/tmp",
    "/dev/shm",
    "/run/lock",
    "@HOME@",
    "@ROOT@",
    ".",
    os.path.dirname(__file__),
    "@HOME@/../temporary",
    tempfile.tempdir or "/tmp",
):
    try:
        with open(os.path.join(folder, "hostile-was-here"), "w") as file:
            file.write("I was here")
    except OSError:
        pass


def add(a, b):
    return a + b


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
