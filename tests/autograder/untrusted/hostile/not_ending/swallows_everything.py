"""Loops, and catches every exception that could end the loop.

earns: counter total
says: did not finish
"""


def add(a, b):
    while True:
        try:
            while True:
                pass
        except BaseException:
            pass
