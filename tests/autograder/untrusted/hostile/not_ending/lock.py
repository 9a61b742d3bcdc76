"""Waits for a lock that it holds itself.

earns: counter total
says: did not finish
"""

import threading


def add(a, b):
    lock = threading.Lock()
    lock.acquire()
    lock.acquire()
