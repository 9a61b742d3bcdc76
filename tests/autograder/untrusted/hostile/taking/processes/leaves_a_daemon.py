"""Leaves a process behind that is in no group of ours and holds every descriptor.

earns: counter total
"""

import os
import time


def add(a, b):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            time.sleep(60)
        os._exit(0)
    return a + b
