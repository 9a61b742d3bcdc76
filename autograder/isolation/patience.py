"""Give a worker more time if the machine was busy with something else.

The time limit of a check is in real time, because code that does nothing but wait must end as well.
On a busy machine, however, a worker may get only a small part of this time, and then correct code
would seem too slow.
"""

from __future__ import annotations

import os
from pathlib import Path

ENOUGH = 0.5  # a worker that had this part of the time limit on a processor gets no more


class Patience:
    """The extra time that a worker may get, but only once.

    ``process`` is the number of the worker's process, and ``seconds`` is the time limit. In a
    bubblewrap sandbox, processes have other numbers than outside, so we cannot find out how much
    processor time the worker has used. ``process`` is then 0.
    """

    def __init__(self, process: int, seconds: float) -> None:
        self.process = process
        self.seconds = seconds

    def more(self) -> float:
        """Return how many more seconds the worker gets. From the second call on, this is 0."""
        used = processor_time(self.process)
        self.process = 0
        return self.seconds - used if used < ENOUGH * self.seconds else 0.0


def processor_time(process: int) -> float:
    """Return how many seconds of processor time a process has used, or inf if that is unknown."""
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace")
        user, system = text.rpartition(")")[2].split()[11:13]  # its name may contain anything
        return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")
    except (OSError, ValueError):
        return float("inf")
