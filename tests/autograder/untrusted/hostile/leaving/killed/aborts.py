"""Aborts the process, which would leave a core file.

earns: add total
"""

import os


class Counter:
    def __init__(self, count):
        os.abort()
