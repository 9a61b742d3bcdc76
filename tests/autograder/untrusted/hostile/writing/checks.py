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
