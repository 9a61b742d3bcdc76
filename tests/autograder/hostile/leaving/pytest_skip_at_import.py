"""Asks pytest to skip all its checks, while it is imported.

earns: nothing
"""

import sys

sys.path.append("@SITE@")
import pytest

pytest.skip("not today", allow_module_level=True)


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
