"""Makes links to the solution in every place it may write to, and reads those.

earns: counter total
"""

import os


def add(a, b):
    for folder in (os.path.dirname(__file__), ".", "/tmp", "/dev/shm"):
        for link in (os.symlink, os.link):
            place = os.path.join(folder, f"hostile-{link.__name__}")
            try:
                link("@ROOT@/solutions/ch90_sums/sums.py", place)
                raise ValueError(open(place).read().replace(chr(10), " "))
            except OSError:
                pass
