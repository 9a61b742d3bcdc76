"""Raises an exception whose message is no text.

earns: counter total
"""


class Wrong(Exception):
    def __str__(self):
        return 42


def add(a, b):
    raise Wrong
