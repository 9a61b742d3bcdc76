"""Has an attribute that is another number each time.

earns: add total
"""


class Counter:
    def __init__(self, count):
        self.counts = iter([count] * 3)

    def step(self, by):
        pass

    def __add__(self, other):
        return self

    @property
    def count(self):
        return next(self.counts, 0.0)
