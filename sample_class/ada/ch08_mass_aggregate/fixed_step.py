"""Ada's clock."""

import math

from ch02_vectors.arguments import not_negative, positive

SHARE = 1e-9


class FixedStep:
    def __init__(self, step, duration, max_steps=None):
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

    def advance(self, elapsed):
        self.left += not_negative("elapsed", elapsed)
        made = 0
        while self._is_due(self.left) and made != self.max_steps:
            self.step(self.duration)
            self.left -= self.duration
            made += 1
        if self._is_due(self.left):  # too slow
            rest = math.fmod(self.left, self.duration)
            if self._is_due(rest):
                rest -= self.duration
            self.dropped += self.left - rest
            self.left = rest
        return made

    def _is_due(self, time):
        return self.duration - time <= SHARE * self.duration
