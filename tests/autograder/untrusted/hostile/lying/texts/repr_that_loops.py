"""Returns an object whose text is never done.

earns: nothing
"""


class Wrong:
    def __repr__(self):
        while True:
            pass

    __str__ = __format__ = __repr__


RIGHT = Wrong()
