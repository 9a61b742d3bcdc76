"""Leaves a file wherever files are often allowed; its own answers are right.

earns: all
"""

import os
import tempfile

for folder in (
    "/tmp",
    "/var/tmp",
    "/dev/shm",
    "/run/lock",
    "@HOME@",
    "@ROOT@",
    ".",
    os.path.dirname(__file__),
    "@HOME@/../temporary",
    tempfile.tempdir or "/tmp",
):
    try:
        with open(os.path.join(folder, "hostile-was-here"), "w") as file:
            file.write("I was here")
    except OSError:
        pass
