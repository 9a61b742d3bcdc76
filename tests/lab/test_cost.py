"""The time per frame that the lab shows is right or absent, however coarse the clock is."""

from __future__ import annotations

import math
import statistics

import pytest

from lab import cost

# The steps of clocks in s: CPython's, Chromium's, and that of Firefox and WebKit.
FINE, ROUNDED, COARSE = 1e-7, 1e-4, 1e-3
BETWEEN = 1.0 / 60.0  # s; frames that start in this rhythm meet a tick of 1 ms at three phases only
SIGMA = 0.2  # relative, of a sum of 25 ticks: such counts scatter by their root


class Clock:
    """A clock that is rounded down as in WebKit, or at random as in Firefox. Reading takes time."""

    def __init__(self, step: float, *, jitter: bool) -> None:
        self.step, self.jitter, self.now = step, jitter, 100.0  # s
        self.reading = min(5e-6, step)  # s

    def __call__(self) -> float:
        self.now += self.reading
        ticks, part = divmod(self.now / self.step, 1.0)
        is_up = self.jitter and part > (int(ticks) * 2_654_435_761 % 2**32) / 2**32
        return (ticks + is_up) * self.step


def shown(
    monkeypatch: pytest.MonkeyPatch, clock: Clock, takes: float, seconds: float, seed: int = 1
) -> list[float | None]:
    """Return what the lab shows after each frame, in s, if each frame takes ``takes`` s."""
    monkeypatch.setattr(cost, "clock", clock)
    cost.tick.cache_clear()
    measured, found = cost.Cost(), []
    measured.random.seed(seed)

    def frame() -> None:
        clock.now += takes

    begin = clock.now
    for number in range(round(60 * seconds)):
        clock.now = max(clock.now, begin + number * BETWEEN)
        measured.measure(frame)
        known = measured.known()
        found.append(known if known is None else 1e-6 * known)
    cost.tick.cache_clear()
    return found


@pytest.mark.parametrize("jitter", [False, True], ids=["rounded down", "rounded at random"])
@pytest.mark.parametrize("takes", [30e-6, 300e-6, 3e-3])
@pytest.mark.parametrize("step", [FINE, ROUNDED, COARSE])
def test_the_cost_is_right_or_absent(
    monkeypatch: pytest.MonkeyPatch, step: float, takes: float, *, jitter: bool
) -> None:
    """Each value is right to four standard deviations of an inverse, and so is the mean."""
    last = []
    for seed in range(6):
        found = shown(monkeypatch, Clock(step, jitter=jitter), takes, 20.0, seed)
        # It needs 60 frames, and 25 ticks of the clock in the mean.
        assert step == COARSE or found[round(60 * (1.1 if step == FINE else 2.0))] is not None
        values = [value for value in found if value is not None]
        if values:  # now and then 20 s are too short for the coarse clock
            assert takes / (1.0 + 4.0 * SIGMA) < min(values)
            assert max(values) < takes / (1.0 - 2.5 * SIGMA)
            last.append(values[-1])
    assert len(last) >= 5
    assert statistics.mean(last) == pytest.approx(takes, rel=4.0 * SIGMA / math.sqrt(6.0))


def test_what_the_clock_cannot_resolve_stays_unknown(monkeypatch: pytest.MonkeyPatch) -> None:
    found = shown(monkeypatch, Clock(COARSE, jitter=False), 2e-6, 30.0)
    assert set(found) == {None}


def test_a_pause_of_the_computer_does_not_stay(monkeypatch: pytest.MonkeyPatch) -> None:
    """One frame is interrupted for 0.3 s, so the mean over all 600 frames would be 530 us."""
    clock = Clock(FINE, jitter=False)
    measured = cost.Cost()
    monkeypatch.setattr(cost, "clock", clock)
    cost.tick.cache_clear()
    for number in range(600):

        def frame(takes: float = 0.3 if number == 100 else 30e-6) -> None:
            clock.now += takes

        measured.measure(frame)
    cost.tick.cache_clear()
    assert measured.known() == pytest.approx(30.0, rel=0.1)
