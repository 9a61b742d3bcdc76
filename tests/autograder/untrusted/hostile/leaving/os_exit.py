"""Ends the process at once with the status of success, from a method.

earns: add total
"""

import os


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        os._exit(0)

    def __add__(self, other):
        return Counter(self.count + other.count)
