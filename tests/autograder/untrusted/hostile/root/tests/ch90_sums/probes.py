"""What must run beside the student's code: a loop."""

from __future__ import annotations

from ch90_sums.sums import Counter


def after_steps(start: float, by: float, times: int) -> float:
    """Step a counter so many times and return its count."""
    counter = Counter(start)
    for _ in range(times):
        counter.step(by)
    return counter.count
