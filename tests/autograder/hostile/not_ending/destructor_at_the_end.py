"""Has an object that loops when it is destroyed at the end; the answers are right.

earns: all
"""


class Loops:
    def __del__(self):
        while True:
            pass


KEPT = Loops()


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
