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
