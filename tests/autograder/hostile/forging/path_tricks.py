"""Changes where later imports are looked for.

earns: nothing
"""

import os
import sys

sys.path[:0] = [os.path.dirname(__file__), "/tmp", "@CLASS@"]
sys.path_hooks.insert(0, lambda path: None)
sys.path_importer_cache.clear()
sys.dont_write_bytecode = False
try:
    os.chdir("/")
except OSError:
    pass


def add(a, b):
    return None


class Counter:
    def __init__(self, count):
        self.count = None

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    return None
