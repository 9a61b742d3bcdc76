"""Single keys from the terminal, without Enter: termios, or msvcrt on Windows."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress

SPECIAL = re.compile(r"\x1b(\[[\d;]*[A-Za-z~]|O[A-Za-z])?")  # what arrows and the like send
END = "\x04"  # Ctrl-D, and what stands for the end of the input


def are_there() -> bool:
    """Say whether somebody can press keys: whether the input is a terminal."""
    return sys.stdin is not None and sys.stdin.isatty()


@contextmanager
def single_keys() -> Iterator[None]:
    """Make every key count at once, unseen; the terminal is as before at the end."""
    if not are_there() or sys.platform == "win32":
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
    """Return the keys pressed since the last call, without waiting; special keys are left out.

    Where the terminal has gone away, that is END. There must have been one.
    """
    keys = ""
    if sys.platform == "win32":
        import msvcrt

        while msvcrt.kbhit():
            key = msvcrt.getwch()
            if key in "\0\xe0":  # a special key sends a second one
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
