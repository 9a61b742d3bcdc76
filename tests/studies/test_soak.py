"""The long runs of the bridge and the platform report what is wrong with an energy."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from studies.soak import soak

FRAMES = 2 * 60 * 5  # two minutes at 5 frames a second


def told(energy_after: Callable[[int], float]) -> tuple[bool, str]:
    """Return the verdict and the description of a scene whose energy is given for every frame."""
    frames = 0

    def step(duration: float) -> None:
        nonlocal frames
        assert duration == 0.2
        frames += 1

    well, what = soak("a scene", step, lambda: energy_after(frames), 5, 2)
    assert frames == FRAMES or not well
    return well, what


def test_what_comes_to_rest_is_well() -> None:
    well, what = told(lambda frame: 100.0 + 10.0 * 0.9**frame)
    assert well
    assert what.endswith("e-13 % over the last minute")  # 10 * 0.9^301 is 1.7e-13 % of 100
    well, what = told(lambda frame: 100.0 - 0.09 * (frame % 2))
    assert well
    assert what == "its energy varies by 0.09 % over the last minute"


@pytest.mark.parametrize(
    ("energy", "wanted"),
    [
        (lambda frame: math.nan if frame == 7 else 1.0, "its energy is nan in frame 6"),
        (lambda frame: math.inf if frame == 7 else 1.0, "its energy is inf in frame 6"),
        (lambda frame: 2.0 if frame == 7 else 1.0, "its energy rises from 1 J to 2 J"),
        (
            lambda frame: 100.0 - 0.11 * (frame % 2),
            "its energy varies by 0.11 % over the last minute",
        ),
    ],
)
def test_what_is_wrong_is_said(energy: Callable[[int], float], wanted: str) -> None:
    assert told(energy) == (False, wanted)
