"""The step with forces, build task B5.2."""

from __future__ import annotations

from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch05_forces.probes import Push, march
from draw import vector
from expect import expect_close, expect_unchanged, named, xyz

ZERO = (0.0, 0.0, 0.0)
KICK = "the docstring of kick"
# Numbers up to 100, and a handful of roundings of each.
ROUNDED = 1e-12


def draw_duration(rng: Random) -> float:
    """Draw the duration of a step, long enough for each mistake to show."""
    return round(rng.uniform(0.2, 0.8), 3)


def draw_mass(rng: Random) -> float:
    """Draw a mass that is far from 1, so that it differs from its inverse."""
    return round(rng.choice((rng.uniform(2.0, 9.0), rng.uniform(0.1, 0.5))), 3)


@pytest.mark.exercise("B5.2", asks="they add the acceleration f/m", read="book 5.1")
def test_a_force_changes_the_velocity_by_f_h_over_m(rng: Random) -> None:
    v, f, mass, h = vector(rng), vector(rng), draw_mass(rng), draw_duration(rng)
    with calls(
        "A force f divided by the mass m is an acceleration (Eq. 3.2). After a step of h seconds, "
        "the new velocity must therefore be v + (f / m) h."
    ):
        p = Particle(velocity=Vector3(*v), mass=mass)
        p.add_force(Vector3(*f))
        p.integrate(h)
    unused = (
        "kick clears the sum of the forces before using it. First move the sum to "
        "self._last_force, where last_acceleration reads it."
    )
    q = Particle(acceleration=Vector3(1, 2, 3))
    q.add_force(Vector3(0, 0, 0))
    q.integrate(h)
    if xyz(q.velocity) == ZERO:
        unused = (
            "Your kick never changes the velocity, not even by the constant acceleration. Either "
            "it does not compute a new velocity, or it returns before that: `if not inverse_mass` "
            "is true for an immovable particle, `if inverse_mass` for the rest."
        )
    elif xyz(p.force_accumulator) != ZERO:
        unused = (
            "Your kick ignores the force, so the velocity does not change. Use the acceleration "
            "a + f / m, where f is the sum of the forces."
        )
    slips = {
        unused: v,
        "Your new velocity is v + f h, without the mass.": v + f * h,
        "Your new velocity is v + f m h. Divide the force f by the mass m instead of multiplying, "
        "because a heavier particle is harder to accelerate.": v + f * mass * h,
        "Your new velocity is v + f / m, without the duration h of the step.": v + f / mass,
    }
    after = v + f / mass * h
    expect_close(xyz(p.velocity), after, slips, then="; p.velocity", unit="m/s", tolerance=ROUNDED)
    slips = {
        "The position moved with the new velocity. It must move with the old one, so drift before "
        "you kick.": after * h,
        "The position moved twice, in drift and again in kick.": (v + after) * h,
        "Your position contains an extra term (f / m) h^2 / 2, which the book's step leaves out.":
            (v + after) / 2.0 * h,
    }  # fmt: skip
    expect_close(
        xyz(p.position), v * h, slips, then="; p.position", unit="m", tolerance=ROUNDED,
        cause="The position must move with the velocity from before the step, as in chapter 3. "
        "Don't change the position in kick, because drift moves it.",
        read="book 3.3.1, the docstring of kick, errata.md",
    )  # fmt: skip


@pytest.mark.exercise("B5.2", asks="the constant acceleration plus f / m", read=KICK)
def test_several_forces_and_the_constant_acceleration_act_together(rng: Random) -> None:
    v, a, f, g = vector(rng), vector(rng), vector(rng), vector(rng)
    mass, h = draw_mass(rng), draw_duration(rng)
    with calls(
        "The acceleration of the step must be a + f / m. Here a is the particle's constant "
        "acceleration, f the sum of all forces and m the mass."
    ):
        p = Particle(velocity=Vector3(*v), acceleration=Vector3(*a), mass=mass)
        p.add_force(Vector3(*f))
        p.add_force(Vector3(*g))
        p.integrate(h)
    pushed = (f + g) / mass
    slips = {
        "The constant acceleration a is missing from your step.": v + pushed * h,
        "Your new velocity is v + a h, without the forces.": v + a * h,
        "You add a without multiplying it by h. Put the sum in parentheses: (a + f / m) h.":
            v + a + pushed * h,
        "You divide the constant acceleration a by the mass, too.": v + (a / mass + pushed) * h,
    }  # fmt: skip
    wanted = v + (a + pushed) * h
    expect_close(xyz(p.velocity), wanted, slips, then="; p.velocity", unit="m/s", tolerance=ROUNDED)
    slip = "You store a + f / m in p.acceleration, but forces must not change it."
    cause = (
        "The step changed p.acceleration, which must stay constant. Forces act for one step only, "
        "so don't store their effect in it."
    )
    now = xyz(p.acceleration)
    expect_unchanged("p.acceleration", now, a, cause=named(now, cause, {slip: a + pushed}))


@pytest.mark.exercise(
    "B5.2", asks="The new velocity is v' = (v + a h) d^h", read=f"{KICK}, E-16 of errata.md"
)
def test_the_damping_also_applies_to_the_effect_of_forces(rng: Random) -> None:
    v, a, f = vector(rng), vector(rng), vector(rng)
    mass, h, damping = draw_mass(rng), draw_duration(rng), draw_duration(rng)
    with calls(
        "The damping d comes last in a step of h seconds. The new velocity must be (v + (a + f / "
        "m) h) d^h."
    ):
        p = Particle(None, Vector3(*v), Vector3(*a), mass=mass, damping=damping)
        p.add_force(Vector3(*f))
        p.integrate(h)
    keep, gained = damping**h, (a + f / mass) * h
    slips = {
        "You apply the damping before you add the acceleration, as in Eq. 3.6. Follow the book's "
        "listing instead: add the acceleration first, and then multiply the velocity by the "
        "damping to the power of the duration.": v * keep + gained,
        "You apply the damping before the force.":
            (v + a * h) * keep + f / mass * h,
        "You damp only the change of the velocity. Multiply the whole new velocity by d^h, the "
        "damping to the power of the duration.": v + gained * keep,
        "The damping is missing.": v + gained,
        "You multiply the velocity by d, the damping for a whole second.": (v + gained) * damping,
    }  # fmt: skip
    wanted = (v + gained) * keep
    expect_close(xyz(p.velocity), wanted, slips, then="; p.velocity", tolerance=ROUNDED, unit="m/s")


@pytest.mark.exercise("B5.2", asks="so that each force acts only once", read="book 5.1")
def test_the_step_clears_the_forces(rng: Random) -> None:
    v, a, f = vector(rng), vector(rng), vector(rng)
    mass, h = draw_mass(rng), draw_duration(rng)
    with calls(
        "The force is still there after the step. A force acts for one step only, so kick must "
        "move the sum to self._last_force, and set self._force to Vector3()."
    ):
        p = Particle(velocity=Vector3(*v), acceleration=Vector3(*a), mass=mass)
        p.add_force(Vector3(*f))
        p.integrate(h)
    expect_close(xyz(p.force_accumulator), ZERO, then="; p.force_accumulator", unit="N")
    with calls(
        "The second step used the force of the first step again. A force acts for one step only.",
        more=True,
    ):
        p.integrate(h)
        got = p.velocity
    expect_close(xyz(got), v + f / mass * h + a * 2 * h, unit="m/s", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2", asks="The new velocity is v' = (v + a h) d^h", read=KICK)
def test_without_forces_the_step_is_that_of_chapter_3(rng: Random) -> None:
    x, v, a = vector(rng), vector(rng), vector(rng)
    mass, h, damping = draw_mass(rng), draw_duration(rng), draw_duration(rng)
    with calls(
        "Without forces the step must be the same as in chapter 3. The position moves by v h, the "
        "new velocity is (v + a h) d^h, and the mass has no effect."
    ):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass, damping=damping)
        p.integrate(h)
    expect_close(xyz(p.position), x + v * h, then="; p.position", unit="m", tolerance=ROUNDED)
    wanted = (v + a * h) * damping**h
    expect_close(xyz(p.velocity), wanted, then="; p.velocity", unit="m/s", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2", asks="with the mass and the damping of now", read=KICK)
def test_a_new_damping_and_mass_apply_from_the_next_step(rng: Random) -> None:
    v, f, mass = vector(rng), vector(rng), draw_mass(rng)
    with calls(
        "The damping and the mass changed between the two steps. Compute d^h and 1 / m again in "
        "every step."
    ):
        p = Particle(velocity=Vector3(*v))
        p.integrate(0.5)
        p.damping = 0.25
        p.mass = mass
        p.add_force(Vector3(*f))
        p.integrate(0.5)
        got = p.velocity
    expect_close(xyz(got), (v + f / mass * 0.5) * 0.5, tolerance=ROUNDED, unit="m/s")
    with calls(
        "With a damping of 0.25, a step of 0.5 s must multiply the velocity by 0.25^0.5, which is "
        "one half."
    ):
        p = Particle(velocity=Vector3(*v), damping=0.25)
        p.integrate(0.5)
        p.integrate(0.5)
        got = p.velocity
    expect_close(xyz(got), 0.25 * v, tolerance=ROUNDED, unit="m/s")


@pytest.mark.exercise(
    "B5.2", asks="0 stops the particle, and a number above 1 speeds it up", read=KICK
)
def test_dampings_of_0_and_above_1(rng: Random) -> None:
    v, f = vector(rng), vector(rng)
    for damping, h, wanted, tolerance, cause in (
        (0.0, 0.5, ZERO, 0.0,
         "The new velocity is not zero, although the damping d is 0. Multiply it by d^h, which is "
         "0."),
        (0.5, 1, (v + f) / 2.0, ROUNDED,
         "The duration is the int 1 here, which must work just like 1.0."),
        (2.0, 2.0, (v + 2.0 * f) * 4.0, 10.0 * ROUNDED,
         "A damping above 1 is valid and speeds the particle up. Multiply by d^h as usual, where "
         "d is the damping and h the duration."),
    ):  # fmt: skip
        logarithm = (
            "You take the logarithm of the damping, which fails for a damping of 0. Compute "
            "damping**duration instead."
        )
        with calls(cause if damping else logarithm):
            p = Particle(velocity=Vector3(*v), damping=damping)
            p.add_force(Vector3(*f))
            p.integrate(h)
            got = p.velocity
        expect_close(xyz(got), wanted, cause=cause, tolerance=tolerance, unit="m/s")


@pytest.mark.exercise(
    "B5.2", asks="Apply the acceleration, forces and damping", read="book 5.1, 3.3.2"
)
def test_a_constant_force_for_5_seconds(rng: Random) -> None:
    f, mass = vector(rng), draw_mass(rng)
    with calls(
        "The force is not the same in all steps, or it acts for the wrong length of time. It must "
        "change the velocity by (f / m) h in every step of h seconds.",
        f"p = Particle(mass={mass}); 300 times: p.add_force(Vector3{f}) and p.integrate(1/60)",
    ):
        position, velocity = march(Particle(mass=mass), Push(f), 1.0 / 60.0, 300)
    # 300 roundings of numbers up to 1200.
    wanted = f / mass * (12.5 - 5.0 / 120.0)
    expect_close(position, wanted, then="; p.position", unit="m", tolerance=1e-10)
    expect_close(velocity, f / mass * 5.0, then="; p.velocity", unit="m/s", tolerance=1e-10)
