"""Puts 200 MB where no limit of the address space counts it; the point needs it.

earns: counter total
"""

import os


def add(a, b):
    for place in ("memfd", "/dev/shm/hostile-shared"):
        try:
            if place == "memfd":
                file = os.memfd_create("hostile")
            else:
                file = os.open(place, os.O_CREAT | os.O_RDWR)
            for _ in range(200):
                os.write(file, b"x" * (1 << 20))
            return a + b
        except (OSError, AttributeError):
            pass
