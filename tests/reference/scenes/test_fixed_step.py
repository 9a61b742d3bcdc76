"""Fixed steps lose no time, whatever the frames are."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from ch08_mass_aggregate.fixed_step import FixedStep


@given(
    frames=st.lists(st.floats(0.0, 2.0), max_size=40),
    duration=st.floats(0.01, 0.5),
    most=st.one_of(st.none(), st.integers(1, 8)),
)
def test_no_time_is_lost(frames: list[float], duration: float, most: int | None) -> None:
    made: list[float] = []
    clock, steps = FixedStep(made.append, duration, most), 0
    for frame in frames:
        count = clock.advance(frame)
        steps += count
        assert most is None or count <= most
        # Less than a step is left. A step that is early by 1e-9 of itself is owed as much.
        assert -1.1e-9 * duration <= clock.left < duration
    assert made == [duration] * steps
    elapsed = sum(Fraction(frame) for frame in frames)
    known = steps * Fraction(duration) + Fraction(clock.left) + Fraction(clock.dropped)
    # At most 80 s in 8000 steps, each with a rounding of 2 s, which is 2^-53 of that.
    assert abs(float(known - elapsed)) <= 8000 * 2.0 * 2.0**-53
    if most is None:
        assert clock.dropped == 0.0
