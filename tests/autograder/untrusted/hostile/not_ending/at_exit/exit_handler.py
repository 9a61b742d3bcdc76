"""Has a handler that loops when Python ends; the answers are right.

earns: all
"""

import atexit


@atexit.register
def loop():
    while True:
        pass
