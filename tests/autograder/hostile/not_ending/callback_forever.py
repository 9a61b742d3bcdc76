"""Calls the function that it was given for ever, whatever it raises.

earns: add counter
"""


def total_of(f, n):
    while True:
        try:
            f(0)
        except BaseException:
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
