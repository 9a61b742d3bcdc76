"""Run the simulation with a fixed time step at any frame rate, by accumulating the elapsed time.

A long time step could let bodies pass through each other, or make the simulation explode. A fixed
step prevents this, and gives the same results on every machine.
"""

from __future__ import annotations

from collections.abc import Callable

from ch02_vectors.arguments import not_negative, positive, whole

SHARE = 1e-9  # of a step: if less than this is missing, only rounding has made the step late


class FixedStep:
    """Calls a step function with a fixed duration, as often as needed to keep up with real time.

    ``step`` can be any function of a duration in s, such as ``ParticleWorld.step``. ``left`` is the
    time in s that has passed but has not been simulated yet, which is less than one step.
    ``max_steps`` limits the steps in one call to ``advance``, and None means no limit. ``dropped``
    is the total time in s that was skipped because of the limit. The constructor raises ValueError
    or TypeError for invalid arguments.
    """

    def __init__(
        self, step: Callable[[float], object], duration: float, max_steps: int | None = None
    ) -> None:
        if not callable(step):
            raise TypeError(f"step must be callable, got {step!r}")
        self.step = step
        self.duration = positive("duration", duration)
        self.max_steps = None if max_steps is None else whole("max_steps", max_steps)
        self.left = 0.0
        self.dropped = 0.0

    def advance(self, elapsed: float) -> int:
        """Simulate ``elapsed`` seconds in steps of fixed duration, and return the number of steps.

        - Time that is too short for a whole step stays in ``left`` until the next call.
        - Take a step even if at most the fraction ``SHARE`` of its duration is missing because of
          rounding. So sixty frames of 1/60 s give exactly sixty steps of 1/60 s.
        - If more than ``max_steps`` steps are due, skip the steps beyond the limit by moving their
          time from ``left`` to ``dropped``.
        - If a step raises an exception, let it propagate. Leave the time of that step in ``left``,
          so that the next call retries the step.

        Raises ValueError, and changes nothing, if ``elapsed`` is negative or not finite.
        """
        self.left += not_negative("elapsed", elapsed)
        steps = 0
        while self.left >= self.duration * (1.0 - SHARE):
            if steps == self.max_steps:
                late = (self.left + SHARE * self.duration) // self.duration * self.duration
                self.dropped += late
                self.left -= late
                break
            self.step(self.duration)
            self.left -= self.duration
            steps += 1
        return steps
