"""Has a metaclass that claims every object, or loops.

earns: add total
"""


class Meta(type):
    def __instancecheck__(cls, thing):
        return True

    def __subclasscheck__(cls, thing):
        return True

    def __eq__(cls, other):
        return True

    def __hash__(cls):
        return hash(float)

    def __call__(cls, *args):
        while True:
            pass


class Counter(metaclass=Meta):
    pass


def add(a, b):
    return a + b


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(i) for i in range(n))
