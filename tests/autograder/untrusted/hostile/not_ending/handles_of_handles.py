"""Every answer is an object with one more attribute to ask for, and no number.

earns: add total
"""


class Endless:
    def __getattr__(self, name):
        return Endless()

    def __call__(self, *args):
        return Endless()

    def __iter__(self):
        while True:
            yield Endless()

    def __len__(self):
        return 1 << 60


class Counter:
    def __init__(self, count):
        self.count = Endless()

    def step(self, by):
        pass

    def __add__(self, other):
        return Endless()
