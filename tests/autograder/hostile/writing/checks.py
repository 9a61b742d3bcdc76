"""Replaces the checks by some that pass.

earns: nothing
"""

CHECKS = """
import pytest


@pytest.mark.parametrize("number", [1, 2, 3])
def test_nothing(number, request):
    request.node.add_marker(pytest.mark.exercise(f"B90.{number}"))
"""

for path in ("@ROOT@/tests/ch90_sums/test_sums.py", "@ROOT@/tests/shared/expect.py"):
    try:
        with open(path, "w") as file:
            file.write(CHECKS)
    except OSError:
        pass


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
