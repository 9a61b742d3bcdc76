"""Give a worker more time if the machine was busy with other work.

The time limit of a check is in real time, so that code which only waits is ended too. But on a busy
machine a worker may get only a small part of this time, and then right code would be too slow.
"""

from __future__ import annotations

import os
from pathlib import Path

ENOUGH = 0.5  # fraction of the time limit that a worker must have had on a processor


class Patience:
    """The additional time that a worker may get once.

    ``process`` is the number of its process. It is 0 if the processor time that the process has
    used is unknown, as it is in a bubblewrap sandbox, where processes have other numbers.
    ``seconds`` is the time limit.
    """

    def __init__(self, process: int, seconds: float) -> None:
        self.process = process
        self.seconds = seconds

    def more(self) -> float:
        """Return the additional time in seconds, which is 0 at every later call."""
        used = processor_time(self.process)
        self.process = 0
        return self.seconds - used if used < ENOUGH * self.seconds else 0.0


def processor_time(process: int) -> float:
    """Return the processor time that a process has used in seconds, and inf if it is unknown."""
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace")
        user, system = text.rpartition(")")[2].split()[11:13]  # its name may contain anything
        return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")
    except (OSError, ValueError):
        return float("inf")
