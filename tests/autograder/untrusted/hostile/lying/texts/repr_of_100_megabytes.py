"""Returns an object with a text of a hundred megabytes.

earns: nothing
"""


class Wrong:
    def __repr__(self):
        return "x" * 100_000_000

    __str__ = __repr__


RIGHT = Wrong()
