"""A regular expression that takes for ever to fail.

earns: add total
says: did not finish
"""

import re


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        re.match(r"(a+)+$", "a" * 60 + "b")
        self.count += by
