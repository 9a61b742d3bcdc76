"""Is imported with a syntax error that claims to be in the solution.

earns: nothing
"""

raise SyntaxError(
    "look at this line", ("@ROOT@/solutions/ch90_sums/sums.py", int("@LINE@"), 1, None)
)


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
