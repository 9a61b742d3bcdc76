"""Prints the lines by which verdicts are reported, and ends.

earns: nothing
"""

import os
import sys

TEXT = "@VERDICTS@"

print(TEXT, flush=True)
print(TEXT, file=sys.stderr, flush=True)
os._exit(0)
