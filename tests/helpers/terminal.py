"""A pseudo-terminal that runs a command, to test what a student sees there."""

from __future__ import annotations

import os
import re
import select
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

fcntl = pytest.importorskip("fcntl", reason="there are no pseudo-terminals here")
pty = pytest.importorskip("pty")
termios = pytest.importorskip("termios")

HEIGHT, WIDTH = 24, 80
CLEARED = "\f"  # marks the points at which the screen was cleared
PATIENCE = 60.0  # seconds, enough for a busy machine
KEYS = "q quit"  # the end of every screen


def small(root: Path) -> Path:
    return root / "chapters/ch90_small/small.py"


def save(root: Path, text: str) -> None:
    small(root).write_text(text, encoding="utf-8")


def command(root: Path, *words: str) -> tuple[list[str], dict[str, str]]:
    environment = os.environ | {"PYTHONPATH": str(root), "TERM": "xterm"}
    for name in ("COLUMNS", "LINES"):
        environment.pop(name, None)
    return [sys.executable, "-m", "autograder", *words], environment


class Terminal:
    def __init__(self, root: Path, *words: str) -> None:
        self.ours, self.its = pty.openpty()
        self.before = termios.tcgetattr(self.its)
        fcntl.ioctl(self.its, termios.TIOCSWINSZ, struct.pack("HHHH", HEIGHT, WIDTH, 0, 0))
        arguments, environment = command(root, *words)
        self.process = subprocess.Popen(
            arguments, cwd=root, env=environment, stdin=self.its, stdout=self.its, stderr=self.its
        )
        self.output = b""
        self.read = 0  # number of characters up to the last words that were waited for

    @property
    def text(self) -> str:
        """All text that has been shown, without colors and other escape sequences."""
        shown = self.output.decode("utf-8", errors="replace")
        shown = shown.replace("\x1b[2J", CLEARED).replace("\r\n", "\n")
        return re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", shown)

    @property
    def screen(self) -> list[str]:
        """The lines that are on the screen now, which are those since it was last cleared."""
        return self.text[self.text.rindex(CLEARED) + 1 :].splitlines()

    def wait_for(self, *words: str) -> None:
        """Wait until these words appear in this order, after the words of the previous call."""
        deadline = time.monotonic() + PATIENCE
        for word in words:
            while word not in self.text[self.read :]:
                assert time.monotonic() < deadline, f"{word!r} is not in {self.text[self.read :]}"
                if select.select([self.ours], [], [], 1.0)[0]:
                    self.output += os.read(self.ours, 4096)
            self.read = self.text.index(word, self.read) + len(word)

    def press(self, key: str) -> None:
        os.write(self.ours, key.encode())

    def status(self) -> int:
        return self.process.wait(PATIENCE)

    def close(self) -> None:
        self.process.kill()
        self.process.wait()
        os.close(self.ours)
        os.close(self.its)


def opened(root: Path, *words: str) -> Iterator[Terminal]:
    """Run a command in a terminal, by default watch, for a fixture."""
    terminal = Terminal(root, *(words or ("watch",)))
    yield terminal
    terminal.close()
