"""Writes verdicts to every descriptor, and ends.

earns: nothing
"""

import os

TEXT = "@VERDICTS@"

for file in range(256):
    try:
        os.write(file, TEXT.encode())
    except OSError:
        pass
os._exit(0)
