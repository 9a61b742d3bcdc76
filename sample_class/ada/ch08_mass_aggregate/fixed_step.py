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
    """Makes a step of always the same duration as often as the time that has passed asks for.

    ``step`` is what is called with the duration in s, such as ParticleWorld.step. ``left`` is the
    time in s that has passed and is not simulated yet: less than a step, and no less than 0 but for
    rounding. With ``max_steps`` there are at most so many steps in one call of advance, since a
    machine that is too slow would fall behind more and more; ``dropped`` is the time in s that this
    has cost so far. None means no limit.

    Raises ValueError where the duration is not positive and finite, or max_steps is below 1, and
    TypeError where step cannot be called, or max_steps is no whole number.
    """

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
        """Let ``elapsed`` s pass: make the steps that are due, and return how many they were.

        What is left of a step waits for the next call. What lacks less than SHARE of a step counts
        as a whole one: sixty frames of 1/60 s are sixty steps. Where more than max_steps are due,
        the others are not made, and their time is added to dropped; less than a step is still left.

        Raises ValueError where elapsed is negative or not finite; nothing has passed then. What a
        step raises comes out; that step, and those that were to follow, are still due.
        """
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
