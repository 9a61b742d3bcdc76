"""Becomes another program that reports verdicts in its name.

earns: nothing
"""

import os
import sys

TEXT = "@VERDICTS@"

try:
    os.execv(
        sys.executable,
        [sys.executable, "-c", f"import os; [os.write(f, {TEXT.encode()!r}) for f in (1, 2)]"],
    )
except OSError:
    pass
