"""Ends the process at once while it is imported.

earns: nothing
"""

import os

os._exit(0)
