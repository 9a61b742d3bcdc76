"""Each call ends soon; all of them together do not.

earns: add total
says: did not finish
"""

import time


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        time.sleep(0.05)
        self.count += by

    def __add__(self, other):
        return Counter(self.count + other.count)
