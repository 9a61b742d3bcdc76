"""Prints behind the end of what is read, so that another check may tell it.

earns: nothing
"""

import os

for file in range(3):
    try:
        os.lseek(file, 4_000, 0)
        os.write(file, b"left for the next check to be told as its own")
    except OSError:
        pass
