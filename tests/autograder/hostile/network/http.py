"""Fetches a page; the point needs it.

earns: counter total
"""

import urllib.request


def add(a, b):
    try:
        urllib.request.urlopen("http://127.0.0.1:@TCP@/hostile", timeout=0.5).read()
    except ValueError:
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
