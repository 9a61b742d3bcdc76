"""Spoils another student's work and result; its own answers are right.

earns: all
"""

for path in (
    "@CLASS@/controls-plain/ch90_sums/sums.py",
    "@OUT@/results/controls-plain.json",
    "@CLASS@/controls-other_style/ch90_sums/sums.py",
):
    try:
        with open(path, "w") as file:
            file.write("spoiled")
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
