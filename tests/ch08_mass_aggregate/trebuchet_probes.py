"""Throws of trebuchets, told as numbers; the autograder runs it beside the student."""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3
from ch08_mass_aggregate import trebuchet


def throw(numbers: Sequence[float], instead: str = "") -> tuple[float, float, int, bool, int]:
    """Return range and share, how many times STEP it took, whether it flies, contacts resolved.

    Instead of the physics a frame may do "nothing", or nothing after the "first" hundred frames. Or
    it may put the projectile on the "ground", or let go of it, "up" or "down", at a place and a
    speed that are given, the counterweight 4 m lower.
    """
    made = trebuchet.Trebuchet(trebuchet.Design(*numbers))
    times: list[float] = []
    resolved = 0
    step = made.world.step

    def counted(duration: float) -> None:
        nonlocal resolved
        times.append(duration)
        if not instead or (instead == "first" and len(times) <= 100):
            step(duration)
            resolved += getattr(made.world.resolver, "iterations_used", 0)
        if instead == "ground":
            made.projectile.position.y = 0.0
        if instead not in ("up", "down"):
            return
        made.weight.position.y -= 4.0
        made.projectile.position = Vector3(2.0, 8.0)
        made.projectile.velocity = Vector3(30.0, 10.0 if instead == "up" else -10.0)

    made.world.step = counted  # type: ignore[method-assign]
    thrown = made.throw()
    frames = round(sum(times) / trebuchet.STEP)
    return thrown.range, thrown.share, frames, bool(made.flies), resolved
