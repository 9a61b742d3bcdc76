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
    about,
    blame,
    expect_close,
    expect_error,
    expect_that,
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
    about.read = "the docstrings of add_force and clear_forces"
    for name, now, before in (
        ("position", xyz(p.position), (1, 2, 3)),
        ("velocity", xyz(p.velocity), (4, 5, 6)),
        ("acceleration", xyz(p.acceleration), (7, 8, 9)),
    ):
        expect_unchanged(f"p.{name}", now, before, cause=cause.format(name))


@pytest.mark.exercise("B5.1", asks="Add a force in N to the sum")
def test_forces_add_up(rng: Random) -> None:
    forces = [components(rng) for _ in range(4)]
    about("p = Particle(mass=4.0)", read="book 5.1")
    p = Particle(Vector3(1, 2, 3), Vector3(4, 5, 6), Vector3(7, 8, 9), mass=4.0)
    total = [0.0, 0.0, 0.0]
    for force in forces:
        about.cause = "The sum of the forces is wrong. Add each new force to the sum, component "
        about.cause += "by component, and don't use the mass, because the sum is a force in N."
        about.call += f"; p.add_force(Vector3{force})"
        try:
            p.add_force(Vector3(*force))
            summed = p.force_accumulator
        except (AttributeError, TypeError):
            about.cause = (
                "self._force must stay a Vector3. Add the new force with +, and store the "
            )
            about.cause += "new vector."
            raise
        total = [total[i] + force[i] for i in range(3)]
        name = "p.force_accumulator, after a force was added"
        cause = "force_accumulator does not return a Vector3. Return the sum as a new Vector3."
        got = expect_vector(summed, call=name, cause=cause)
        slips = {
            "Your sum is only the latest force. Add each force to the sum instead of replacing "
            "the sum.": force,
            "You divide the force by the mass. Add the force itself, because the step divides "
            "the sum by the mass later.": [t / 4.0 for t in total],
            "Your sum has the wrong sign, because you subtract the force. Add it instead.": [
                -part for part in total
            ],
            "You swapped y and z. Add x to x, y to y and z to z.": (total[0], total[2], total[1]),
            "The sum is still zero after a force was added. add_force must store the new sum in "
            "self._force, and force_accumulator must return it.": ZERO,
        }
        blame(got, slips)
        if got == ZERO and xyz(p.acceleration) != (7, 8, 9):
            about.cause = "You change p.acceleration instead of the sum of the forces. Store the "
            about.cause += "new sum in self._force."
        expect_close(got, total, then="; p.force_accumulator", unit="N", tolerance=ROUNDED)
        expect_unmoved(
            p,
            "add_force has changed p.{}. A force has no effect until the next step, so change "
            "only the sum of the forces.",
        )


@pytest.mark.exercise("B5.1", asks="zero if no force was added")
def test_without_forces_the_sum_is_zero(rng: Random) -> None:
    force = components(rng)
    opposite = (-force[0], -force[1], -force[2])
    about.read = "the docstring of force_accumulator"
    about.call = "p = Particle(acceleration=Vector3(0, -10, 0)); p.force_accumulator"
    p = Particle(acceleration=Vector3(0, -10, 0))
    total = p.force_accumulator
    none = "No force has been added yet, so the sum must be the zero vector. Return Vector3() "
    none += "instead of None."
    expect_that(total is not None, "None, not a vector", "Vector3(0, 0, 0)", cause=none)
    about.cause = "No force has been added yet, so the sum must be the zero vector."
    expect_close(xyz(total), ZERO, unit="N")
    about.call = f"p.add_force(Vector3{force}); p.add_force(Vector3{opposite}); p.force_accumulator"
    about.cause = "The two forces are opposite, so their sum must be zero. Store the sum of each "
    about.cause += "particle in self, not in the class, where all particles would share it."
    p.add_force(Vector3(*force))
    first = xyz(p.force_accumulator)
    p.add_force(Vector3(*opposite))
    got = xyz(p.force_accumulator)
    latest = (
        "Your sum is only the latest force. Add each force to the sum instead of replacing the sum."
    )
    blame(got, [(opposite, latest)])
    expect_close(got, ZERO, unit="N")
    about.call = f"p.add_force(Vector3{force}); p.force_accumulator"
    about.cause = "Only one force has been added, so the sum must equal that force."
    expect_close(first, force, unit="N")


@pytest.mark.exercise("B5.1", asks="A later change to it does not change the sum")
def test_add_force_does_not_change_its_argument(rng: Random) -> None:
    first, second = components(rng), components(rng)
    about.call = f"f = Vector3{first}; p.add_force(f)"
    about.cause = "Only one force has been added, so the sum must equal that force."
    about.read = "the docstring of add_force"
    p, f = Particle(), Vector3(*first)
    p.add_force(f)
    f.x = 99.0
    got = xyz(p.force_accumulator)
    itself = "You store the vector f itself, so the sum changes when the caller changes f. Store "
    itself += "the three components instead."
    blame(got, [((99.0, *first[1:]), itself)])
    expect_close(got, first, then="; f.x = 99.0; p.force_accumulator", unit="N")
    about.call = f"p.add_force(Vector3{second}); f = Vector3{first}; p.add_force(f)"
    p, f = Particle(), Vector3(*first)
    p.add_force(Vector3(*second))
    p.add_force(f)
    expect_unchanged(
        "f",
        xyz(f),
        first,
        cause="add_force has changed its argument f, because += works in place. Use +, which "
        "creates a new vector.",
    )
    wanted = tuple(first[i] + second[i] for i in range(3))
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, then="; p.force_accumulator", unit="N", tolerance=ROUNDED)


@pytest.mark.exercise("B5.1", asks="in N, as a new vector")
def test_the_sum_is_a_new_vector(rng: Random) -> None:
    force = components(rng)
    about.call = f"p.add_force(Vector3{force}); total = p.force_accumulator; total.x = 99.0"
    about.cause = "force_accumulator returned a vector that belongs to the particle, so the "
    about.cause += "caller could change the sum. Return a new vector from every call."
    about.read = "the docstring of force_accumulator"
    p = Particle()
    p.add_force(Vector3(*force))
    total = p.force_accumulator
    expect_close(
        xyz(total),
        force,
        call=about.call.rpartition(";")[0],
        cause="The sum must equal the only force that was added.",
    )
    total.x = 99.0
    expect_close(xyz(p.force_accumulator), force, then="; p.force_accumulator", unit="N")


@pytest.mark.exercise("B5.1", asks="A particle adds up its forces")
def test_each_particle_has_its_own_forces(rng: Random) -> None:
    first, second = components(rng), components(rng)
    about.call = f"p.add_force(Vector3{first}); q.add_force(Vector3{second})"
    about.cause = "Each particle needs its own sum of forces. Store the sum in self, not in the "
    about.cause += "class or in a global variable."
    about.read = "the docstring of Particle"
    p, q = Particle(), Particle()
    p.add_force(Vector3(*first))
    q.add_force(Vector3(*second))
    got = xyz(p.force_accumulator)
    expect_close(got, first, then="; p.force_accumulator", unit="N")
    got = xyz(q.force_accumulator)
    expect_close(got, second, then="; q.force_accumulator", unit="N")


@pytest.mark.exercise("B5.1", asks="Discard the forces that were added")
def test_clear_forces_sets_the_sum_to_zero(rng: Random) -> None:
    first, second = components(rng), components(rng)
    about(
        f"p.add_force(Vector3{first}); p.clear_forces()",
        cause="clear_forces does not clear the sum of the forces. The sum is stored in "
        "self._force, so make it a new zero vector.",
    )
    about.read = "the docstring of clear_forces"
    p = Particle(Vector3(1, 2, 3), Vector3(4, 5, 6), Vector3(7, 8, 9))
    p.add_force(Vector3(*first))
    before = xyz(p.force_accumulator)
    p.clear_forces()
    try:
        cleared = p.force_accumulator
    except (AttributeError, TypeError) as error:
        if "NoneType" in str(error):
            about.cause = "You set self._force to None. Set it to the zero vector, Vector3()."
        raise
    expect_close(xyz(cleared), ZERO, then="; p.force_accumulator", unit="N")
    expect_unmoved(p, "clear_forces has changed p.{}. It must change only the sum of the forces.")
    p.clear_forces()
    p.add_force(Vector3(*second))
    about.call = f"{about.call}; p.clear_forces(); p.add_force(Vector3{second})"
    about.cause = "clear_forces must set the sum to zero, even if it is called twice in a row. "
    about.cause += "The next force that is added must then be the whole sum."
    got = xyz(p.force_accumulator)
    expect_close(got, second, then="; p.force_accumulator", unit="N")
    expect_close(
        before,
        first,
        call=f"p.add_force(Vector3{first}); p.force_accumulator",
        unit="N",
        cause="The sum must equal the only force that was added.",
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
    about.cause = "add_force raised the error only after it had stored the new sum. Check the "
    about.cause += "force and the sum before you store anything."
    got = xyz(p.force_accumulator)
    expect_close(got, so_far, then="; p.force_accumulator", unit="N")


@pytest.mark.exercise("B5.1", asks="a component of the force, or of the sum, is not finite")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.inf, -math.inf, math.nan])
def test_a_force_must_be_finite(bad: float) -> None:
    about.cause = f"A component of the force is {bad}, so raise ValueError. The function "
    about.cause += "finite_vector in arguments.py does this for you."
    for numbers in ((bad, 2.0, 3.0), (1.0, bad, 3.0), (1.0, 2.0, bad)):
        about.call = f"p.add_force(Vector3{numbers})"
        expect_refusal((4.0, 5.0, 6.0), about.call, Vector3(*numbers), ValueError)


@pytest.mark.exercise("B5.1", asks="or of the sum, is not finite")
@pytest.mark.robust
def test_the_sum_must_be_finite() -> None:
    about.cause = "Both forces are finite, but their sum is too large for a float. Check the new "
    about.cause += "sum with finite_vector before you store it."
    for i in range(3):
        for large in (1e308, -1e308):
            force = tuple(large if i == j else 0.0 for j in range(3))
            so_far = (force[0] + 1.0, force[1] + 2.0, force[2] + 3.0)
            about.call = f"p.add_force(Vector3{force})"
            expect_refusal(so_far, about.call, Vector3(*force), ValueError)


@pytest.mark.exercise("B5.1", asks="TypeError if it is not a Vector3")
@pytest.mark.robust
def test_a_force_must_be_a_vector() -> None:
    for bad in (3.0, (1.0, 2.0, 3.0), None, "up"):
        about.cause = f"The force is {bad!r}, which is not a Vector3, so raise TypeError. The "
        about.cause += "function finite_vector in arguments.py does this for you."
        expect_refusal((4.0, 5.0, 6.0), f"p.add_force({bad!r})", bad, TypeError)
