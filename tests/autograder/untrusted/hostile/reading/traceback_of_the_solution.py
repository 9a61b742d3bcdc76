"""Raises an exception whose traceback claims lines of the solution and of the checks.

earns: nothing
"""


def raising(path, line):
    source = chr(10) * (line - 1) + "raise ValueError('look at this line')"
    exec(compile(source, path, "exec"), {})


def add(a, b):
    raising("@ROOT@/solutions/ch90_sums/sums.py", int("@LINE@"))


class Counter:
    def __init__(self, count):
        raising("@ROOT@/tests/ch90_sums/test_sums.py", int("@CHECKLINE@"))


def total_of(f, n):
    raising("@HOME@/secret.txt", 1)
