"""Counters loop when they are destroyed.

earns: add total
says: did not finish
"""


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        self.count += by

    def __add__(self, other):
        return Counter(self.count + other.count)

    def __del__(self):
        while True:
            pass
