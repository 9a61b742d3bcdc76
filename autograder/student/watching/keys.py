"""Read single keys from the terminal, so that students need not press Enter after each one."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress

SPECIAL = re.compile(r"\x1b(\[[\d;]*[A-Za-z~]|O[A-Za-z])?")  # sent by arrow keys and the like
END = "\x04"  # Ctrl-D, which also means the end of the input


def available() -> bool:
    """Return True if the program can react to single keys, which requires a terminal."""
    return sys.stdin is not None and sys.stdin.isatty()


@contextmanager
def single_keys() -> Iterator[None]:
    """Make the terminal pass on each key at once and without echo, until the context ends."""
    if not available() or sys.platform == "win32":
        yield
        return
    import termios
    import tty

    before = termios.tcgetattr(sys.stdin)
    tty.setcbreak(sys.stdin)
    try:
        yield
    finally:
        with suppress(termios.error):  # the terminal has gone away
            termios.tcsetattr(sys.stdin, termios.TCSADRAIN, before)


def pressed() -> str:
    """Return the keys pressed since the last call, without arrows, and END after the end."""
    keys = ""
    if sys.platform == "win32":
        import msvcrt

        while msvcrt.kbhit():
            key = msvcrt.getwch()
            if key in "\0\xe0":  # a special key sends a second character
                msvcrt.getwch()
            else:
                keys += key
        return keys
    import select

    while select.select([sys.stdin], [], [], 0)[0]:
        try:
            read = os.read(sys.stdin.fileno(), 100).decode(errors="ignore")
        except OSError:
            read = ""
        if not read:
            return keys + END
        keys += SPECIAL.sub("", read)
    return keys
