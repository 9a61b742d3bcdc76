"""Leaves files that every later Python of this user would run.

earns: all
"""

import os
import sys

SITE = f"@HOME@/.local/lib/python{sys.version_info[0]}.{sys.version_info[1]}/site-packages"
try:
    os.makedirs(SITE, exist_ok=True)
    for path in (
        f"{SITE}/usercustomize.py",
        f"{SITE}/hostile.pth",
        "@HOME@/.bashrc",
        "@ROOT@/tests/conftest.py",
    ):
        with open(path, "a") as file:
            file.write("# hostile" + chr(10))
except OSError:
    pass
