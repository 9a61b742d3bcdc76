"""Sends a line that never ends.

earns: counter total
"""

import os


def add(a, b):
    files = set(range(3, 64))
    while True:
        for file in sorted(files):
            try:
                os.write(file, b"[" * 65536)
            except BlockingIOError:
                pass
            except OSError:
                files.discard(file)
