"""Ignores the signal of the limit of processor time, and goes on.

earns: nothing
"""

import signal

signal.signal(signal.SIGXCPU, signal.SIG_IGN)


def add(a, b):
    while True:
        pass
