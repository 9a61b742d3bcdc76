"""Tries to report home while it is imported; the answers are right.

earns: all
"""

try:
    import socket

    with socket.create_connection(("127.0.0.1", int("@TCP@")), timeout=0.2) as server:
        server.sendall(b"hostile tcp")
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
