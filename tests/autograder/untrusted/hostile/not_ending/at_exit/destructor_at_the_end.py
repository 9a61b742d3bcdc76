"""Has an object that loops when it is destroyed at the end; the answers are right.

earns: all
"""


class Loops:
    def __del__(self):
        while True:
            pass


KEPT = Loops()
