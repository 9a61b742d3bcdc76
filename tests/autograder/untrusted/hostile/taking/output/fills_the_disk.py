"""Writes 100 MB wherever it may; the point needs one place.

earns: counter total
"""

import os
import tempfile


def add(a, b):
    for folder in (".", tempfile.tempdir or "/tmp", "/var/tmp", "/dev/shm", "@HOME@", "@OUT@"):
        try:
            with open(os.path.join(folder, "hostile-filler"), "wb") as file:
                for _ in range(100):
                    file.write(b"x" * (1 << 20))
            return a + b
        except OSError:
            pass
