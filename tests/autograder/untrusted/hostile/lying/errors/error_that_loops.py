"""Raises an exception whose message is never done.

earns: counter total
"""


class Wrong(Exception):
    def __str__(self):
        while True:
            pass

    __repr__ = __str__


def add(a, b):
    raise Wrong
