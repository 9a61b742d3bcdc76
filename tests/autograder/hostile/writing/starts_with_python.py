"""Leaves files that every later Python of this user would run.

earns: all
"""

import os
import sys

SITE = f"@HOME@/.local/lib/python{sys.version_info[0]}.{sys.version_info[1]}/site-packages"
try:
    os.makedirs(SITE, exist_ok=True)
    for path in (
        f"{SITE}/usercustomize.py",
        f"{SITE}/hostile.pth",
        "@HOME@/.bashrc",
        "@ROOT@/tests/conftest.py",
    ):
        with open(path, "a") as file:
            file.write("# hostile" + chr(10))
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
