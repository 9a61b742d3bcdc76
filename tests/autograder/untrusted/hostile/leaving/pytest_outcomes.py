"""Raises pytest's own skip, expected failure and end of the run.

earns: nothing
"""

import sys

sys.path.append("@SITE@")
try:
    import pytest
except BaseException:
    pytest = None


def add(a, b):
    pytest.skip("no need to check this")


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        pytest.xfail("known to fail")


def total_of(f, n):
    pytest.exit("all is well", returncode=0)
