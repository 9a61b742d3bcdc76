"""The force accumulator, build task B5.1."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from draw import Components, Triple, vector
from expect import about, expect_close, expect_error, expect_unchanged, expect_vector, xyz

ZERO = Triple((0.0, 0.0, 0.0))
SUM = "the docstring of force_accumulator"
ADD = "the docstring of add_force"
ONLY = "Only one force has been added, so the sum must equal that force."
LATEST = "You keep only the latest force. Add each force to the sum instead of replacing the sum."
MADE = {"position": (1, 2, 3), "velocity": (4, 5, 6), "acceleration": (7, 8, 9)}
# The sum of four components below 10, in whatever order, is off by a few roundings of 40.
ROUNDED = 1e-13


def expect_unmoved(p: Particle, cause: str) -> None:
    """Expect the vectors that the particle was made with."""
    for name, before in MADE.items():
        now, read = getattr(p, name), "the docstrings of add_force and clear_forces"
        expect_unchanged(f"p.{name}", now, before, cause=cause.format(name), read=read)


@pytest.mark.exercise("B5.1", asks="Add a force in N to the sum", read="book 5.1")
def test_forces_add_up(rng: Random) -> None:
    with calls("self._force must stay a Vector3.", "p = Particle(mass=4.0)"):
        p = Particle(Vector3(1, 2, 3), Vector3(4, 5, 6), Vector3(7, 8, 9), mass=4.0)
    total = ZERO
    for force in [vector(rng) for _ in range(4)]:
        with calls(
            "self._force must stay a Vector3. Add the new force with +, and store the new vector.",
            f"p.add_force(Vector3{force})",
            more=True,
        ):
            p.add_force(Vector3(*force))
            summed = p.force_accumulator
        total += force
        x, y, z = total
        cause = "force_accumulator does not return a Vector3. Return the sum as a new Vector3."
        call, then = "p.force_accumulator, after a force was added", "; p.force_accumulator"
        got = expect_vector(summed, call=call, cause=cause)
        zero = "The sum is still zero. Store it in self._force, and return it as force_accumulator."
        if xyz(p.acceleration) != (7, 8, 9):
            zero = "You change p.acceleration instead of the sum. Store the sum in self._force."
        slips = {
            LATEST: force,
            "You divide the force by the mass.": total / 4.0,
            "Your sum has the wrong sign, because you subtract the force.": -total,
            "You swapped y and z.": (x, z, y),
            zero: ZERO,
        }
        expect_close(
            got, total, slips, then=then, unit="N", tolerance=ROUNDED,
            cause="Add each force to the sum, component by component, and don't use the mass.",
        )  # fmt: skip
        expect_unmoved(p, "add_force has changed p.{}. Change only the sum of the forces.")


@pytest.mark.exercise("B5.1", asks="zero if no force was added", read=SUM)
def test_without_forces_the_sum_is_zero(rng: Random) -> None:
    force = vector(rng)
    opposite = -force
    with calls("No force was added, so the sum is zero. Return Vector3() instead of None."):
        p = Particle(acceleration=Vector3(0, -10, 0))
        got = p.force_accumulator
    expect_close(xyz(got), ZERO, unit="N")
    own = "Store the sum of each particle in self, not in the class, where all would share it."
    with calls(f"{ONLY} {own}", more=True):
        p.add_force(Vector3(*force))
        got = p.force_accumulator
    expect_close(xyz(got), force, unit="N")
    with calls("The two forces are opposite, so their sum must be zero.", more=True):
        p.add_force(Vector3(*opposite))
        got = p.force_accumulator
    expect_close(xyz(got), ZERO, {LATEST: opposite}, unit="N")


@pytest.mark.exercise("B5.1", asks="A later change to it does not change the sum", read=ADD)
def test_add_force_does_not_change_its_argument(rng: Random) -> None:
    first, second = vector(rng), vector(rng)
    with calls(ONLY):
        p, f = Particle(), Vector3(*first)
        p.add_force(f)
        f.x = 99.0
        got = p.force_accumulator
    itself = "The sum changes when the caller changes f. Store its components instead."
    expect_close(xyz(got), first, {itself: (99.0, *first[1:])}, unit="N")
    with calls("add_force has changed its argument f, because += works in place. Use + instead."):
        p, f = Particle(), Vector3(*first)
        p.add_force(Vector3(*second))
        p.add_force(f)
    expect_unchanged("f", f, first)
    then = "; p.force_accumulator"
    expect_close(xyz(p.force_accumulator), first + second, then=then, unit="N", tolerance=ROUNDED)


@pytest.mark.exercise("B5.1", asks="in N, as a new vector", read=SUM)
def test_the_sum_is_a_new_vector(rng: Random) -> None:
    force = vector(rng)
    with calls(ONLY):
        p = Particle()
        p.add_force(Vector3(*force))
        got = p.force_accumulator
    expect_close(xyz(got), force, unit="N")
    with calls("The caller could change the sum. Return a new vector from every call.", more=True):
        total = p.force_accumulator
        total.x = 99.0
        got = p.force_accumulator
    expect_close(xyz(got), force, unit="N")


@pytest.mark.exercise(
    "B5.1", asks="A particle adds up its forces", read="the docstring of Particle"
)
def test_each_particle_has_its_own_forces(rng: Random) -> None:
    """Only here two particles exist at once, so that a sum that they share would show."""
    first, second = vector(rng), vector(rng)
    with calls("Store each particle's sum in self, not in the class or in a global variable."):
        p, q = Particle(), Particle()
        p.add_force(Vector3(*first))
        q.add_force(Vector3(*second))
    expect_close(xyz(p.force_accumulator), first, then="; p.force_accumulator", unit="N")
    expect_close(xyz(q.force_accumulator), second, then="; q.force_accumulator", unit="N")


@pytest.mark.exercise(
    "B5.1", asks="Discard the forces that were added", read="the docstring of clear_forces"
)
def test_clear_forces_sets_the_sum_to_zero(rng: Random) -> None:
    first, second = vector(rng), vector(rng)
    with calls("clear_forces does not clear the sum. Make self._force a new zero vector."):
        p = Particle(Vector3(1, 2, 3), Vector3(4, 5, 6), Vector3(7, 8, 9))
        p.add_force(Vector3(*first))
    before = xyz(p.force_accumulator)
    with calls(about.cause, more=True):
        p.clear_forces()
    try:
        cleared = p.force_accumulator
    except (AttributeError, TypeError) as error:
        if "NoneType" in str(error):
            about(cause="You set self._force to None. Set it to the zero vector, Vector3().")
        raise
    expect_close(xyz(cleared), ZERO, then="; p.force_accumulator", unit="N")
    expect_unmoved(p, "clear_forces has changed p.{}. It must change only the sum of the forces.")
    with calls("After clear_forces, even twice, the next force must be the whole sum.", more=True):
        p.clear_forces()
        p.add_force(Vector3(*second))
        got = p.force_accumulator
    expect_close(xyz(got), second, unit="N")
    call = f"p.add_force(Vector3{first}); p.force_accumulator"
    expect_close(before, first, call=call, unit="N", cause=ONLY)


def expect_refusal(
    so_far: Components, bad: Any, shown: str, error: type[Exception], cause: str
) -> None:
    """Expect that a particle with this force refuses another one, and keeps its sum."""
    with calls(cause, f"p.add_force(Vector3{so_far}); p.add_force({shown})"):
        p = Particle()
        p.add_force(Vector3(*so_far))
    large = Vector3(1.5e308, 1.5e308, 1.0)
    expect_error(lambda: p.add_force(bad), error, allowed=lambda: Particle().add_force(large))
    expect_close(
        xyz(p.force_accumulator), so_far, then="; p.force_accumulator", unit="N",
        cause="add_force raised the error only after it had stored the new sum. Check the force "
        "and the sum before you store anything.",
    )  # fmt: skip


@pytest.mark.exercise(
    "B5.1", asks="a component of the force, or of the sum, is not finite", read=ADD
)
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.inf, -math.inf, math.nan])
def test_a_force_must_be_finite(bad: float) -> None:
    cause = f"A component of the force is {bad}, so raise ValueError. The function finite_vector "
    cause += "in arguments.py does this for you."
    for numbers in ((bad, 2.0, 3.0), (1.0, bad, 3.0), (1.0, 2.0, bad)):
        force, shown = Vector3(*numbers), f"Vector3{numbers}"
        expect_refusal((4.0, 5.0, 6.0), force, shown, ValueError, cause)


@pytest.mark.exercise("B5.1", asks="or of the sum, is not finite", read=ADD)
@pytest.mark.robust
def test_the_sum_must_be_finite() -> None:
    cause = "Both forces are finite, but their sum is too large for a float. Check the new sum "
    cause += "with finite_vector before you store it."
    for i in range(3):
        for large in (1e308, -1e308):
            force = Triple(large if i == j else 0.0 for j in range(3))
            so_far = Triple((1.0, 2.0, 0.0)) + force
            expect_refusal(so_far, Vector3(*force), f"Vector3{force}", ValueError, cause)


@pytest.mark.exercise("B5.1", asks="TypeError if it is not a Vector3", read=ADD)
@pytest.mark.robust
def test_a_force_must_be_a_vector() -> None:
    for bad in (3.0, (1.0, 2.0, 3.0), None, "up"):
        cause = f"The force is {bad!r}, which is not a Vector3, so raise TypeError. The function "
        cause += "finite_vector in arguments.py does this for you."
        expect_refusal((4.0, 5.0, 6.0), bad, repr(bad), TypeError, cause)
