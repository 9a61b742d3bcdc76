"""The tuned engine ends in the same states as the clear one, up to ch08_mass_aggregate."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.commands import TUNED, find_engine

WORLDS = Path(__file__).with_name("worlds.py")
# The clear engine adds a h and f h / m to a velocity one after the other, and the tuned one adds
# (a + f / m) h. Each step therefore rounds differently by about 1e-16. Springs, impacts and 60
# steps enlarge that: in twenty worlds of each kind, the largest relative difference was 1.4e-14.
SAME = 1e-12


def states(engine: str, seed: int) -> dict[str, list[list[float]]]:
    """Return the states of the particles of each random world, run in a process of their own."""
    folders = [str(folder) for folder in find_engine(engine)]
    command = [sys.executable, str(WORLDS), str(seed), *folders]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    found: dict[str, list[list[float]]] = json.loads(done.stdout)
    return found


@pytest.mark.parametrize("seed", range(1, 9))
def test_random_worlds_end_in_the_same_state(seed: int) -> None:
    clear, tuned = states("solutions", seed), states(TUNED, seed)
    assert clear.keys() == tuned.keys()
    for name in clear:
        pairs = [
            pair
            for rows in zip(clear[name], tuned[name], strict=True)
            for pair in zip(*rows, strict=True)
        ]
        assert len(pairs) > 50
        assert all(math.isfinite(number) for pair in pairs for number in pair), name
        largest = max(abs(a) for a, _ in pairs)
        assert max(abs(a - b) for a, b in pairs) <= SAME * largest, name
