"""Run the simulation with a fixed time step at any frame rate, by accumulating the elapsed time.

Frames do not all take the same time. One frame may take 5 ms, and the next one half a second
because the disk is busy. A time step of half a second could let bodies pass through each other, or
make the simulation explode. A fixed time step prevents this, and also gives the same results on
every machine. Arguments of the wrong type raise TypeError.
"""

from __future__ import annotations

from collections.abc import Callable

from ch02_vectors.arguments import positive

SHARE = 1e-9  # of a step: if less than this is missing, only rounding has made the step late


class FixedStep:
    """Calls a step function with a fixed duration, as often as needed to keep up with real time.

    ``step`` can be any function that takes a duration in s, such as ``ParticleWorld.step``.
    ``left`` is the time in s that has passed but has not been simulated yet. It is always shorter
    than one step and, apart from rounding errors, never negative.

    ``max_steps`` limits the number of steps in one call to ``advance``, and None means no limit.
    Without a limit, a machine that is too slow for the simulation would fall further and further
    behind. ``dropped`` is the total time in s that was skipped because of the limit.

    Raises:
        ValueError: if the duration is not positive and finite, or ``max_steps`` is less than 1.
        TypeError: if ``step`` is not callable, or ``max_steps`` is not a whole number or None.
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
        """Simulate ``elapsed`` seconds in steps of fixed duration, and return the number of steps.

        Time that is too short for a whole step stays in ``left`` until the next call. Because of
        rounding errors, ``left`` can be slightly shorter than a step even though a step is due. So
        take the step if at most the fraction ``SHARE`` of its duration is missing. This way, sixty
        frames of 1/60 s give exactly sixty steps of 1/60 s.

        If more than ``max_steps`` steps are due, skip the steps beyond the limit by moving their
        time from ``left`` to ``dropped``.

        If a step raises an exception, let it propagate. Leave the time of that step in ``left``, so
        that the next call retries the step.

        Raises:
            ValueError: if ``elapsed`` is negative or not finite. In that case nothing changes.
        """
        raise NotImplementedError("Exercise B8.3: A fixed time step")
