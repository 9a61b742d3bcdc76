"""Leaves threads behind that never end; the answers are right.

earns: all
"""

import threading
import time


def idle():
    while True:
        time.sleep(0.01)


def add(a, b):
    try:
        for _ in range(20):
            threading.Thread(target=idle).start()
    except BaseException:
        pass
    return a + b
