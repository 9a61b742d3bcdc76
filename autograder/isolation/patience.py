"""Give a student's code more time if it was slow only because the machine was busy.

The time limit of a check is in real time, because code that only waits must be stopped too. On a
busy machine, however, other processes may use the processor for most of that time. Without extra
time, even correct code would then seem too slow.
"""

from __future__ import annotations

import os
from pathlib import Path

ENOUGH = 0.5  # a worker that had this part of the time limit on a processor gets no more


class Patience:
    """Extra time for a student's code on a busy machine, granted at most once per check.

    ``process`` is the process ID of the worker that runs the code, and ``seconds`` is the time
    limit. If the worker runs inside bubblewrap, its process ID is unknown and ``process`` is 0.
    Without the process ID we cannot measure processor time, so the worker gets no extra time.
    """

    def __init__(self, process: int, seconds: float) -> None:
        self.process = process
        self.seconds = seconds

    def more(self) -> float:
        """Compute how many extra seconds the worker process gets to finish a check.

        If the worker's processor time is less than half of the time limit, the worker gets the
        unused part. Otherwise, or if it has already had extra time, the result is 0.
        """
        used = processor_time(self.process)
        self.process = 0
        return self.seconds - used if used < ENOUGH * self.seconds else 0.0


def processor_time(process: int) -> float:
    """Return the processor time that a process has used, in seconds, or inf if it is unknown."""
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace")
        user, system = text.rpartition(")")[2].split()[11:13]  # its name may contain anything
        return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")
    except (OSError, ValueError):
        return float("inf")
