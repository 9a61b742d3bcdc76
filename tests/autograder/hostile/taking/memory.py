"""Takes memory in pieces, as much as there is; earns the point only with 1 GB.

earns: counter total
"""


def add(a, b):
    pieces = []
    for _ in range(1000):
        pieces.append(bytearray(b"x") * (1 << 20))
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
