"""Give a student's code more time if it was slow only because the machine was busy.

The time limit of a check is in real time, because code that only waits must be stopped too. On a
busy machine, however, even correct code would then sometimes seem too slow.
"""

from __future__ import annotations

import os
from pathlib import Path

ENOUGH = 0.5  # a worker that had this part of the time limit on a processor gets no more


def extra_time(process: int, seconds: float) -> float:
    """Return how many more seconds a process gets after a time limit of ``seconds``.

    They are the part of the limit in which it had no processor, if that is more than half. A worker
    inside bubblewrap gets none, because its process ID is unknown, and ``process`` is 0.
    """
    used = processor_time(process)
    return seconds - used if used < ENOUGH * seconds else 0.0


def processor_time(process: int) -> float:
    """Return the processor time that a process has used, in seconds, or inf if it is unknown."""
    try:
        text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace")
        user, system = text.rpartition(")")[2].split()[11:13]  # its name may contain anything
        return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")
    except (OSError, ValueError):
        return float("inf")
