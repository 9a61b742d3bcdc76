"""Simulate chapter 8's rope bridge and tilting platform for ten minutes, and check their energy.

Both scenes run at 30, 60 and 120 steps per second. A run passes if its energy is always finite and
never above its initial value. In the last minute, the energy must not vary by more than 0.1 %.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Callable
from functools import partial

from rich.progress import track

from scenes.engine import use_engine

RATES = (30, 60, 120)  # Hz
MINUTES = 10
MOST = 0.001  # fraction by which the energy may vary over the last minute


def main(arguments: list[str]) -> int:
    """Simulate both scenes at every step rate. Return 1 if any run failed, and 0 otherwise."""
    parser = argparse.ArgumentParser(prog="python -m studies soak", description=__doc__)
    parser.add_argument("--engine", default="solutions", help="the folder to run")
    options = parser.parse_args(arguments)
    use_engine(parser, options.engine)
    from ch08_mass_aggregate.bridge import Bridge
    from ch08_mass_aggregate.tilting_platform import TiltingPlatform
    from ch08_mass_aggregate.world import mechanical_energy

    failed = 0
    for kind in (Bridge, TiltingPlatform):
        for rate in RATES:
            scene = kind()
            energy = partial(mechanical_energy, scene.world.particles)
            name = f"{kind.__name__} at {rate} Hz"
            well, told = soak(name, scene.step, energy, rate, MINUTES)
            verdict = "passed" if well else "FAILED"
            print(f"{name}, {MINUTES} minutes: {verdict}, {told}", flush=True)
            failed += not well
    print(f"{failed} of {2 * len(RATES)} runs failed")
    return 1 if failed else 0


def soak(
    name: str, step: Callable[[float], object], energy: Callable[[], float], rate: int, minutes: int
) -> tuple[bool, str]:
    """Simulate a scene at ``rate`` Hz. Return whether it passed, and a sentence for the report."""
    start = energy()
    last: list[float] = []
    for _ in track(range(minutes), name, transient=True, disable=not sys.stdout.isatty()):
        last.clear()
        for frame in range(60 * rate):
            step(1.0 / rate)
            last.append(energy())
            if not math.isfinite(last[-1]):
                return False, f"its energy is {last[-1]} in frame {frame}"
        if max(last) > start:
            return False, f"its energy rises from {start:.6g} J to {max(last):.6g} J"
    change = (max(last) - min(last)) / abs(last[-1])
    return change <= MOST, f"its energy varies by {100 * change:.2g} % over the last minute"
