"""Calls the function that it was given for ever, whatever it raises.

earns: add counter
"""


def total_of(f, n):
    while True:
        try:
            f(0)
        except BaseException:
            pass
