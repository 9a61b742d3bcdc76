"""Writes a stack of its own, with escapes that are no characters, and hangs.

earns: nothing
says: did not finish
"""

import os
import stat

TEXT = 'File "/ch90_sums/\\Uffffffff\\ud800.py", line 3 in \\Uffffffff\n'


def forge_a_stack():
    for file in range(3, 64):
        try:
            if stat.S_ISREG(os.fstat(file).st_mode):  # and not the wire
                os.write(file, TEXT.encode(errors="surrogatepass"))
        except OSError:
            pass
    while True:
        pass


def add(a, b):
    forge_a_stack()
