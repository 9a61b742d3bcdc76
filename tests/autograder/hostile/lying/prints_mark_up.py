"""Prints script, mark-up and control characters before it fails.

earns: counter total
"""


def add(a, b):
    print("<script>alert(1)</script><img src=x onerror=alert(1)>", chr(27) + "[2J", chr(0))


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
