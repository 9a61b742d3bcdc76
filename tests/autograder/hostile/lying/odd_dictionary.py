"""Returns dictionaries with odd keys and words that could be mistaken for messages.

earns: nothing
"""

RIGHT = {
    1: 2,
    None: 3,
    ("a", 1): 4,
    "event": "verdict",
    "status": "passed",
    "object": 0,
    "raised": {},
}


def add(a, b):
    return RIGHT


class Counter:
    def __init__(self, count):
        self.count = RIGHT

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    return RIGHT
