"""Frames of one length, however long the pictures take: a fixed step with an accumulator.

A picture takes now 5 ms, now half a second, while a disc turns. Steps of those lengths would fall
through each other, or explode; the same step each time does not, and gives the same run on every
machine.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from ch02_vectors.arguments import not_negative, positive

SHARE = 1e-9  # of a step: what lacks so little of one is due, and only rounding makes it late


class FixedStep:
    """Makes a step of always the same duration as often as the time that has passed asks for."""

    def __init__(
        self, step: Callable[[float], object], duration: float, max_steps: int | None = None
    ) -> None:
        if not callable(step):
            raise TypeError(f"step must be something to call, got {step!r}")
        if max_steps is not None:
            if not isinstance(max_steps, int) or isinstance(max_steps, bool):
                raise TypeError(f"max_steps must be a whole number or None, got {max_steps!r}")
            if max_steps < 1:
                raise ValueError(f"max_steps must be 1 or more, got {max_steps!r}")
        self.step = step
        self.duration = positive("duration", duration)
        self.max_steps = max_steps
        self.left = 0.0
        self.dropped = 0.0

    def advance(self, elapsed: float) -> int:
        total = self.left + not_negative("elapsed", elapsed)
        self.left = total
        enough = self.duration * (1.0 - SHARE)
        made = 0
        while self.left >= enough:
            if made == self.max_steps:
                rest = math.fmod(self.left, self.duration)
                if rest >= enough:
                    rest -= self.duration  # but for rounding that is one more step
                self.dropped += self.left - rest
                self.left = rest
                break
            self.step(self.duration)
            made += 1
            # From the total, and not from what was left: a million small errors would add up.
            self.left = total - made * self.duration
        return made
