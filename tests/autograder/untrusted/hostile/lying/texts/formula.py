"""Raises messages that a spreadsheet would take for a formula.

earns: nothing
"""


def add(a, b):
    raise ValueError("=cmd|' /C calc'!A0")


class Counter:
    def __init__(self, count):
        raise ValueError("@SUM(1+1)*cmd|' /C calc'!A0")


def total_of(f, n):
    raise type("=HYPERLINK(1)", (Exception,), {})("+1+1" + chr(9) + "=1+1")
