"""Starts other programs in every way that Python has; the point needs one.

earns: counter total
"""

import os
import subprocess


def add(a, b):
    for start in (
        lambda: subprocess.check_call(["/bin/true"]),
        lambda: os.posix_spawn("/bin/true", ["true"], {}),
        lambda: 1 / (os.system("true") == 0),
        lambda: os.popen("echo yes").read()[2],
    ):
        try:
            start()
            return a + b
        except BaseException:
            pass
