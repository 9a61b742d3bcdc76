"""Calls the given function from two threads at once.

earns: add counter
"""

import threading


def total_of(f, n):
    threads = [threading.Thread(target=f, args=(i,), daemon=True) for i in range(50)]
    for thread in threads:
        thread.start()
    return f(0)
