"""Tries to leave a process behind; the answers are right.

earns: all
"""

import os
import time

try:
    if os.fork() == 0:
        os.setsid()
        time.sleep(60)
        os._exit(0)
except OSError:
    pass
