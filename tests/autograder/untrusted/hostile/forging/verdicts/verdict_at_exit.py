"""Changes the status with which the process ends.

earns: nothing
"""

import atexit
import os

atexit.register(lambda: os._exit(0))
