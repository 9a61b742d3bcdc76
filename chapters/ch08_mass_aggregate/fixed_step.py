"""Time steps of a fixed length, however long the pictures take to draw: a loop with an accumulator.

One picture may take 5 ms and the next half a second, for example while the disk is busy. With time
steps of those lengths, bodies would pass through each other or the simulation would explode. A
fixed time step prevents this, and it gives the same run on every machine. Arguments of the wrong
type raise TypeError.
"""

from __future__ import annotations

from collections.abc import Callable

from ch02_vectors.arguments import positive

SHARE = 1e-9  # of a step: if less than this is missing, only rounding has made the step late


class FixedStep:
    """Calls a step function with a fixed duration, as often as the elapsed time requires.

    ``step`` is any function of a duration in s, such as ParticleWorld.step. ``left`` is the time in
    s that has passed but has not been simulated yet. It is less than one step, and never negative
    except for rounding.

    A machine that is too slow for its own steps would fall further and further behind.
    ``max_steps`` limits the steps of one call of advance, and ``dropped`` is the total time in s
    that was skipped because of it. None means no limit.

    Raises:
        ValueError: if the duration is not positive and finite, or max_steps is less than 1.
        TypeError: if step is not callable, or max_steps is not a whole number or None.
    """

    def __init__(
        self, step: Callable[[float], object], duration: float, max_steps: int | None = None
    ) -> None:
        if not callable(step):
            raise TypeError(f"step must be callable, got {step!r}")
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
        """Let ``elapsed`` seconds pass: make the steps that are due, and return how many were made.

        Time that is too short for a step is kept in left for the next call. If only SHARE of a step
        or less is missing, the step is due, so that sixty frames of 1/60 s make exactly sixty
        steps. If more than max_steps are due, the steps beyond the limit are not made. Their time
        is subtracted from left and added to dropped.

        If a step raises an exception, it is passed on. The time of that step has not been
        subtracted from left, so the next call makes it again.

        Raises:
            ValueError: if elapsed is negative or not finite. Nothing has changed then.
        """
        raise NotImplementedError("Exercise B8.3: A fixed time step")
