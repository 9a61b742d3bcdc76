"""The force accumulator, build task B5.1."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from draw import components
from expect import (
    UNCHANGED,
    about,
    blame,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    expect_vector,
    scoped,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)
# The sum of four components below 10, in whatever order, is off by a few roundings of 40.
ROUNDED = 1e-13


@scoped
def expect_unmoved(p: Particle, cause: str) -> None:
    """Expect the position, the velocity and the acceleration that the particle was made with."""
    about.cause = cause
    state = (*xyz(p.position), *xyz(p.velocity), *xyz(p.acceleration))
    expect_unchanged(
        "(x, y, z, vx, vy, vz, ax, ay, az)",
        state,
        (1, 2, 3, 4, 5, 6, 7, 8, 9),
        read="the docstring of add_force",
    )


@pytest.mark.exercise("B5.1")
def test_forces_add_up(rng: Random) -> None:
    forces = [components(rng) for _ in range(4)]
    about("p = Particle(mass=4.0)", read="book 5.1")
    p = Particle(Vector3(1, 2, 3), Vector3(4, 5, 6), Vector3(7, 8, 9), mass=4.0)
    total = [0.0, 0.0, 0.0]
    for force in forces:
        about.cause = "Add each new force to the sum, component by component. Leave the mass out "
        about.cause += "of it, because the sum is a force."
        about.call += f"; p.add_force(Vector3{force})"
        p.add_force(Vector3(*force))
        total = [total[i] + force[i] for i in range(3)]
        name = "p.force_accumulator, after a force was added"
        cause = "force_accumulator must return the sum of the forces as a new Vector3."
        got = expect_vector(p.force_accumulator, call=name, cause=cause)
        slips = {
            "This is only the latest force. Add each force to the sum instead of replacing the "
            "sum.": force,
            "This is the sum divided by the mass, which is an acceleration. Store the sum of the "
            "forces itself, in N, and divide only in the step.": [t / 4.0 for t in total],
            (
                "The sum has the wrong sign, perhaps because you subtracted each force instead of "
                "adding it."
            ): [-part for part in total],
            "Forces were added, but the sum is still zero. Store it in self._forces[0], and let "
            "force_accumulator read it from there.": ZERO,
        }
        blame(got, slips)
        expect_close(got, total, then="; p.force_accumulator", tolerance=ROUNDED)
        expect_unmoved(
            p,
            "add_force has changed something other than the sum. A force has no effect until the "
            "next step, so change only the sum.",
        )


@pytest.mark.exercise("B5.1")
def test_without_forces_the_sum_is_zero(rng: Random) -> None:
    force = components(rng)
    opposite = (-force[0], -force[1], -force[2])
    about.read = "the docstring of force_accumulator"
    about.cause = "No force has been added yet, so the sum must be Vector3(0, 0, 0), not None."
    about.call = "p = Particle(acceleration=Vector3(0, -10, 0)); p.force_accumulator"
    p = Particle(acceleration=Vector3(0, -10, 0))
    expect_close(xyz(p.force_accumulator), ZERO)
    about.call = f"p.add_force(Vector3{force}); p.add_force(Vector3{opposite}); p.force_accumulator"
    about.cause = "Two opposite forces add up to zero. Check that you add each force to this "
    about.cause += "particle's own sum, which is stored in self."
    p.add_force(Vector3(*force))
    first = xyz(p.force_accumulator)
    p.add_force(Vector3(*opposite))
    expect_close(xyz(p.force_accumulator), ZERO)
    about.call = f"p.add_force(Vector3{force}); p.force_accumulator"
    about.cause = "Only one force has been added, so the sum must equal that force."
    expect_close(first, force)


@pytest.mark.exercise("B5.1")
def test_a_force_is_only_read(rng: Random) -> None:
    first, second = components(rng), components(rng)
    about.call = f"f = Vector3{first}; p.add_force(f)"
    about.cause = "The sum must not change if the caller later changes f. Store the components of "
    about.cause += "the force, not the vector itself."
    about.read = "the docstring of add_force"
    p, f = Particle(), Vector3(*first)
    p.add_force(f)
    f.x = 99.0
    expect_close(xyz(p.force_accumulator), first, then="; f.x = 99.0; p.force_accumulator")
    about.call = f"p.add_force(Vector3{second}); f = Vector3{first}; p.add_force(f)"
    p, f = Particle(), Vector3(*first)
    p.add_force(Vector3(*second))
    p.add_force(f)
    expect_unchanged("f", xyz(f), first, cause=UNCHANGED)
    wanted = tuple(first[i] + second[i] for i in range(3))
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator", tolerance=ROUNDED)


@pytest.mark.exercise("B5.1")
def test_the_sum_is_a_vector_of_its_own(rng: Random) -> None:
    force = components(rng)
    about.call = f"p.add_force(Vector3{force}); total = p.force_accumulator; total.x = 99.0"
    about.cause = "Changing the returned vector must not change the particle. Return a new vector "
    about.cause += "from every call."
    about.read = "the docstring of force_accumulator"
    p = Particle()
    p.add_force(Vector3(*force))
    total = p.force_accumulator
    expect_close(
        xyz(total),
        force,
        call="p.force_accumulator",
        cause="The sum is wrong even before the caller changes it. It must equal the force that "
        "was added.",
    )
    total.x = 99.0
    expect_close(xyz(p.force_accumulator), force, then="; p.force_accumulator")


@pytest.mark.exercise("B5.1")
def test_two_particles_have_forces_of_their_own(rng: Random) -> None:
    first, second = components(rng), components(rng)
    about.call = f"p.add_force(Vector3{first}); q.add_force(Vector3{second})"
    about.cause = "Each particle needs a sum of its own. Store it in self, not in the class or in "
    about.cause += "a global variable."
    about.read = "the docstring of Particle"
    p, q = Particle(), Particle()
    p.add_force(Vector3(*first))
    q.add_force(Vector3(*second))
    got = xyz(p.force_accumulator)
    expect_close(got, first, then="; p.force_accumulator")
    got = xyz(q.force_accumulator)
    expect_close(got, second, then="; q.force_accumulator")


@pytest.mark.exercise("B5.1")
def test_forces_can_be_dropped(rng: Random) -> None:
    first, second = components(rng), components(rng)
    about(
        f"p.add_force(Vector3{first}); p.clear_forces()",
        cause="After clear_forces the sum must be zero, as if no force had ever been added.",
    )
    about.read = "the docstring of clear_forces"
    p = Particle(Vector3(1, 2, 3), Vector3(4, 5, 6), Vector3(7, 8, 9))
    p.add_force(Vector3(*first))
    before = xyz(p.force_accumulator)
    p.clear_forces()
    expect_close(xyz(p.force_accumulator), ZERO, then="; p.force_accumulator")
    p.clear_forces()
    p.add_force(Vector3(*second))
    about.call = f"{about.call}; p.clear_forces(); p.add_force(Vector3{second})"
    about.cause = "clear_forces resets the sum to zero, even if you call it twice, so after the "
    about.cause += "next force the sum must equal that force."
    got = xyz(p.force_accumulator)
    expect_close(got, second, then="; p.force_accumulator")
    name = f"p.add_force(Vector3{first}); p.force_accumulator"
    expect_close(
        before,
        first,
        call=name,
        cause="The sum was wrong even before it was cleared. It must equal the force that was "
        "added.",
    )
    expect_unmoved(
        p,
        "clear_forces has changed something other than the sum of the forces. It must leave "
        "everything else about the particle alone.",
    )


@scoped
def expect_refusal(
    so_far: tuple[float, float, float], call: str, bad: Any, error: type[Exception]
) -> None:
    """Expect that a particle with this force refuses another one, and keeps its sum."""
    about(call, read="the docstring of add_force")
    p = Particle()
    p.add_force(Vector3(*so_far))
    about.call = f"p.add_force(Vector3{so_far}); {about.call}"
    expect_error(
        lambda: p.add_force(bad),
        error,
        allowed=lambda: Particle().add_force(Vector3(1.5e308, 1.5e308, 1.0)),
    )
    about.cause = "The force was rejected, but the sum changed anyway. Check both the force and "
    about.cause += "the new sum before you store anything."
    got = xyz(p.force_accumulator)
    expect_close(got, so_far, then="; p.force_accumulator")


@pytest.mark.exercise("B5.1")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.inf, -math.inf, math.nan])
def test_a_force_must_be_finite(bad: float) -> None:
    about.cause = "A force with an infinite or NaN component must be rejected with a ValueError. "
    about.cause += "Check it with finite_vector from arguments.py."
    for numbers in ((bad, 2.0, 3.0), (1.0, bad, 3.0), (1.0, 2.0, bad)):
        about.call = f"p.add_force(Vector3{numbers})"
        expect_refusal((4.0, 5.0, 6.0), about.call, Vector3(*numbers), ValueError)


@pytest.mark.exercise("B5.1")
@pytest.mark.robust
def test_the_sum_must_be_finite() -> None:
    about.cause = "Each force is finite, but their sum is too large for a float. Check that the "
    about.cause += "new sum is finite before you store it."
    for i in range(3):
        for large in (1e308, -1e308):
            force = tuple(large if i == j else 0.0 for j in range(3))
            so_far = (force[0] + 1.0, force[1] + 2.0, force[2] + 3.0)
            about.call = f"p.add_force(Vector3{force})"
            expect_refusal(so_far, about.call, Vector3(*force), ValueError)


@pytest.mark.exercise("B5.1")
@pytest.mark.robust
def test_a_force_must_be_a_vector() -> None:
    about.cause = "The argument is not a Vector3, so it must be rejected with a TypeError. Check "
    about.cause += "it with finite_vector from arguments.py."
    for bad in (3.0, (1.0, 2.0, 3.0), None, "up"):
        expect_refusal((4.0, 5.0, 6.0), f"p.add_force({bad!r})", bad, TypeError)


@pytest.mark.exercise("B5.1", weight=0.5)
def test_what_changes_the_sum_returns_nothing(rng: Random) -> None:
    force = components(rng)
    about(
        f"p.add_force(Vector3{force})",
        cause="This method changes the particle in place, so it must return None. Leave out the "
        "return statement.",
    )
    about.read = "the docstrings of add_force and clear_forces"
    p = Particle()
    got = p.add_force(Vector3(*force))
    expect_exactly(got, None)
    total = xyz(p.force_accumulator)
    expect_close(
        total,
        force,
        then="; p.force_accumulator",
        cause="Only one force has been added, so the sum must equal that force.",
    )
    expect_exactly(p.clear_forces(), None, call="p.clear_forces()")
