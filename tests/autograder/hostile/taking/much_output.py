"""Prints a lot on the way to the right answers.

earns: all
"""


def add(a, b):
    for line in range(2000):
        print("a and b are", a, b, "in line", line)
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
