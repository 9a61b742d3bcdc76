"""Trebuchets and their throws, told as numbers, for the checks.

The autograder runs it beside the student, so nothing in here is secret, and nothing decides.
"""

from __future__ import annotations

from collections.abc import Sequence

from ch02_vectors.vector import Vector3
from ch08_mass_aggregate import trebuchet
from ch08_mass_aggregate.probes import Components, xyz
from ch08_mass_aggregate.scene_probes import rods


def beam(numbers: Sequence[float]) -> tuple[list[tuple[int, int, float]], list[Components]]:
    """Return the rods of a trebuchet's beam, and where pivot, counterweight and tip are."""
    made = trebuchet.Trebuchet(trebuchet.Design(*numbers))
    particles = [made.pivot, made.weight, made.tip]
    return rods(made.beam(), particles), [xyz(particle.position) for particle in particles]


def throw(numbers: Sequence[float], instead: str = "") -> tuple[float, float, int, bool, int]:
    """Throw; return range and share, how many times STEP it took, and whether it flies.

    And how many contacts the student's resolver says that it has resolved, if it does.

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


def my_design() -> tuple[float, ...] | str:
    """Return the numbers of the student's design, or words for another object."""
    design = trebuchet.my_design()
    if not isinstance(design, trebuchet.Design):
        return f"{design!r}, which is a {type(design).__name__}"
    numbers = (design.counterweight, design.short_arm, design.long_arm, design.sling)
    return (*numbers, design.release_angle)
