"""Run a command and kill it at a chosen moment, to test that it can be started again.

As a script, this file is the command, and kills itself after one of its changes to a folder.
"""

from __future__ import annotations

import atexit
import json
import os
import runpy
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from typing import Any

ROOT = Path(__file__).parents[2]
KILLED = (-signal.SIGKILL, -signal.SIGALRM)
LONGEST_DELAY = 0.2  # s
MARK = "COMPANION_KILLED"  # variable that is set in every process that a command starts


@dataclass
class Victim:
    """A command that writes into a folder, and is killed repeatedly while it does."""

    command: list[str]  # -m and a module, or a script, and its arguments
    folder: Path
    rng: Random
    steps: int = 0
    kills: int = 0
    said: str = ""
    mark: str = field(default_factory=lambda: os.urandom(8).hex())

    def run_whole(self) -> None:
        """Run the command to its end. The first time, count its steps."""
        count = self.folder.parent / "steps.txt"
        status = self._run(0, 0.0, count)
        assert status == 0, self.said
        self.steps = self.steps or int(count.read_text(encoding="utf-8"))

    def kill_once(self) -> bool:
        """Start the command, kill it at a random moment, and return whether it still ran."""
        step = self.rng.randint(1, self.steps)
        delay = self.rng.choice([0.0, 0.0, 1e-5, 1e-4, self.rng.uniform(0.0, LONGEST_DELAY)])
        status = self._run(step, delay, Path(os.devnull))
        where = f"at step {step} of {self.steps} and {delay} s"
        assert "Traceback" not in self.said, f"{where}: {self.said}"
        assert status in (0, *KILLED), f"{where}: status {status}, {self.said}"
        assert survivors(self.mark) == [], where
        self.kills += status in KILLED
        return status in KILLED

    def _run(self, step: int, delay: float, count: Path) -> int:
        how = json.dumps({"folder": str(self.folder.resolve()), "step": step, "delay": delay})
        done = subprocess.run(
            [sys.executable, __file__, how, str(count), *self.command],
            cwd=ROOT,
            env=os.environ | {MARK: self.mark},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            timeout=300.0,
            check=False,
        )
        self.said = done.stdout
        return done.returncode


def survivors(mark: str, patience: float = 5.0) -> list[str]:
    """Wait for the processes with this mark in their environment, and return those that remain."""
    deadline = time.monotonic() + patience
    while True:
        left = []
        for process in Path("/proc").glob("[0-9]*"):
            try:
                if mark.encode() in (process / "environ").read_bytes():
                    left.append((process / "cmdline").read_bytes().decode(errors="replace"))
            except OSError:  # it has just ended
                continue
        if not left or time.monotonic() > deadline:
            return left
        time.sleep(0.01)


def half_written(folder: Path) -> list[str]:
    """Return the incomplete files in a folder. Hidden files and temporary files do not count."""
    return [
        str(path)
        for path in folder.rglob("*")
        if path.is_file()
        and path.suffix not in (".tmp", ".part")
        and not any(part.startswith(".") for part in path.relative_to(folder).parts)
        and not _is_whole(path)
    ]


def _is_whole(path: Path) -> bool:
    content = path.read_bytes()
    if path.suffix == ".json":
        try:
            json.loads(content)
        except ValueError:
            return False
    if path.suffix == ".html":
        return content.rstrip().endswith(b"</html>")
    return content.endswith(b"\n") if path.suffix == ".csv" else bool(content)


def _main(how: dict[str, Any], count: str, command: list[str]) -> None:
    inside, steps = how["folder"], 0

    def hook(event: str, arguments: tuple[Any, ...]) -> None:
        nonlocal steps
        if not _is_step(event, arguments, inside):
            return
        steps += 1
        if steps == how["step"]:
            if how["delay"]:
                signal.setitimer(signal.ITIMER_REAL, how["delay"])  # nothing handles its signal
            else:
                os.kill(os.getpid(), signal.SIGKILL)

    atexit.register(lambda: Path(count).write_text(str(steps), encoding="utf-8"))
    sys.path[0] = str(ROOT)
    sys.addaudithook(hook)
    if command[0] == "-m":
        sys.argv = command[1:]
        runpy.run_module(command[1], run_name="__main__", alter_sys=True)
    else:
        sys.argv = command
        runpy.run_path(command[0], run_name="__main__")


def _is_step(event: str, arguments: tuple[Any, ...], inside: str) -> bool:
    """Return whether an audit event is about a change to something in a folder."""
    if event == "open":
        if not arguments[2] & (os.O_WRONLY | os.O_RDWR | os.O_CREAT):
            return False
    elif event not in ("os.rename", "os.remove", "os.rmdir", "os.mkdir"):
        return False
    if event != "open" and arguments[-1] != -1:
        return True  # shutil removes files relative to their folder
    return isinstance(arguments[0], (str, bytes)) and os.fsdecode(arguments[0]).startswith(inside)


if __name__ == "__main__":
    _main(json.loads(sys.argv[1]), sys.argv[2], sys.argv[3:])
