"""The step with forces, and the last acceleration, build task B5.2."""

from __future__ import annotations

import math
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
E_16 = f"{KICK}, E-16 of docs/errata.md"
LAST = "the docstring of last_acceleration"
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
    with calls("A force f is an acceleration f / m (Eq. 3.2), so it adds (f / m) h to v."):
        p = Particle(velocity=Vector3(*v), mass=mass)
        p.add_force(Vector3(*f))
        p.integrate(h)
    unused = "kick clears the sum before using it. First move it to self._last_force."
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
        unused = "Your kick ignores the force. Use the acceleration a + f / m."
    slips = {
        unused: v,
        "Your new velocity is v + f h, without the mass.": v + f * h,
        "Your new velocity is v + f m h. Divide the force f by the mass m instead of multiplying.":
            v + f * mass * h,
        "Your new velocity is v + f / m, without the duration h of the step.": v + f / mass,
    }  # fmt: skip
    after = v + f / mass * h
    expect_close(xyz(p.velocity), after, slips, then="; p.velocity", unit="m/s", tolerance=ROUNDED)
    slips = {
        "The position moved with the new velocity. Drift before you kick.": after * h,
        "The position moved twice, in drift and again in kick.": (v + after) * h,
        "Your position contains an extra term (f / m) h^2 / 2, which the book's step leaves out.":
            (v + after) / 2.0 * h,
    }  # fmt: skip
    expect_close(
        xyz(p.position), v * h, slips, then="; p.position", unit="m", tolerance=ROUNDED,
        cause="The position must move with the velocity from before the step, as in chapter 3. "
        "Don't change the position in kick, because drift moves it.",
        read="book 3.3.1, the docstring of kick, docs/errata.md",
    )  # fmt: skip


@pytest.mark.exercise("B5.2", asks="the constant acceleration plus f / m", read=KICK)
def test_several_forces_and_the_constant_acceleration_act_together(rng: Random) -> None:
    v, a, f, g = vector(rng), vector(rng), vector(rng), vector(rng)
    mass, h = draw_mass(rng), draw_duration(rng)
    with calls("The acceleration must be a + f / m, where f is the sum of all forces."):
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
    cause = "p.acceleration must stay constant, so don't store the effect of forces in it."
    slips, now = {"You store a + f / m in p.acceleration.": a + pushed}, xyz(p.acceleration)
    expect_unchanged("p.acceleration", now, a, cause=named(now, cause, slips))


@pytest.mark.exercise("B5.2", asks="The new velocity is v' = (v + a h) d^h", read=E_16)
def test_the_damping_also_applies_to_the_effect_of_forces(rng: Random) -> None:
    v, a, f = vector(rng), vector(rng), vector(rng)
    mass, h, damping = draw_mass(rng), draw_duration(rng), draw_duration(rng)
    with calls("The damping comes last. The new velocity must be (v + (a + f / m) h) d^h."):
        p = Particle(None, Vector3(*v), Vector3(*a), mass=mass, damping=damping)
        p.add_force(Vector3(*f))
        p.integrate(h)
    keep, gained = damping**h, (a + f / mass) * h
    slips = {
        "You apply the damping before you add the acceleration, as in Eq. 3.6. Follow the book's "
        "listing instead: add the acceleration first, and then multiply the velocity by the "
        "damping to the power of the duration.": v * keep + gained,
        "You apply the damping before the force.": (v + a * h) * keep + f / mass * h,
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
    with calls("The force is still there after the step. kick must set self._force to Vector3()."):
        p = Particle(velocity=Vector3(*v), acceleration=Vector3(*a), mass=mass)
        p.add_force(Vector3(*f))
        p.integrate(h)
    expect_close(xyz(p.force_accumulator), ZERO, then="; p.force_accumulator", unit="N")
    with calls("The step used the force of the first step again. It acts only once.", more=True):
        p.integrate(h)
        got = p.velocity
    expect_close(xyz(got), v + f / mass * h + a * 2 * h, unit="m/s", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2", asks="The new velocity is v' = (v + a h) d^h", read=KICK)
def test_without_forces_the_step_is_that_of_chapter_3(rng: Random) -> None:
    x, v, a = vector(rng), vector(rng), vector(rng)
    mass, h, damping = draw_mass(rng), draw_duration(rng), draw_duration(rng)
    with calls("Without forces, x moves by v h, and the new velocity is (v + a h) d^h."):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass, damping=damping)
        p.integrate(h)
    expect_close(xyz(p.position), x + v * h, then="; p.position", unit="m", tolerance=ROUNDED)
    wanted = (v + a * h) * damping**h
    expect_close(xyz(p.velocity), wanted, then="; p.velocity", unit="m/s", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2", asks="with the mass and the damping of now", read=KICK)
def test_a_new_damping_and_mass_apply_from_the_next_step(rng: Random) -> None:
    """Only here the damping changes between two steps, so that a stored d^h would show."""
    v, f, mass = vector(rng), vector(rng), draw_mass(rng)
    with calls("Compute d^h and 1 / m again in every step, because both have changed."):
        p = Particle(velocity=Vector3(*v))
        p.integrate(0.5)
        p.damping = 0.25
        p.mass = mass
        p.add_force(Vector3(*f))
        p.integrate(0.5)
        got = p.velocity
    expect_close(xyz(got), (v + f / mass * 0.5) * 0.5, tolerance=ROUNDED, unit="m/s")
    with calls("Two steps of 0.5 s must multiply the velocity by the damping, which is 0.25."):
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
         "The damping d is 0, so the new velocity must be, too. Multiply it by d^h."),
        (0.5, 1, (v + f) / 2.0, ROUNDED, "The int 1 must work just like the duration 1.0."),
        (2.0, 2.0, (v + 2.0 * f) * 4.0, 10.0 * ROUNDED,
         "A damping above 1 is valid and speeds the particle up. Multiply by d^h as usual."),
    ):  # fmt: skip
        logarithm = "The logarithm of a damping of 0 fails. Compute damping**duration instead."
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
        "The force must change the velocity by (f / m) h in every step of h seconds.",
        f"p = Particle(mass={mass}); 300 times: p.add_force(Vector3{f}) and p.integrate(1/60)",
    ):
        position, velocity = march(Particle(mass=mass), Push(f), 1.0 / 60.0, 300)
    # 300 roundings of numbers up to 1200.
    wanted = f / mass * (12.5 - 5.0 / 120.0)
    expect_close(position, wanted, then="; p.position", unit="m", tolerance=1e-10)
    expect_close(velocity, f / mass * 5.0, then="; p.velocity", unit="m/s", tolerance=1e-10)


@pytest.mark.exercise("B5.2", asks="the sum that the last step used", read=LAST)
def test_the_last_acceleration_includes_the_forces_of_the_step(rng: Random) -> None:
    a, f, g, mass = vector(rng), vector(rng), vector(rng), round(rng.uniform(2.0, 9.0), 3)
    with calls("last_acceleration must be a + f / m, where f is the force of the last step."):
        p = Particle(acceleration=Vector3(*a), mass=mass, damping=0.5)
        p.add_force(Vector3(*f))
        p.integrate(0.5)
        got = p.last_acceleration
    wanted = a + f / mass
    slips = {
        "Your result is only the constant acceleration, without the forces of the last step. "
        "kick must store them in self._last_force, and last_acceleration must read them there.": a,
        "Your result is a + f, so the mass is missing.": a + f,
        "Your result is a + f m. Divide the force f by the mass m instead.": a + f * mass,
        "Your result is only f / m.": f / mass,
        "You divide the constant acceleration by the mass, too.": (a + f) / mass,
        "You divide the constant acceleration a by the mass, but not the force f.": a / mass + f,
    }
    expect_close(xyz(got), wanted, slips, unit="m/s^2", tolerance=ROUNDED)
    expect_unchanged(
        "p.acceleration", p.acceleration, a,
        cause="last_acceleration has changed p.acceleration, because += works in place. Use +.",
    )  # fmt: skip
    with calls("No step has used this force yet, so last_acceleration must not change.", more=True):
        p.add_force(Vector3(*g))
        got = p.last_acceleration
    expect_close(xyz(got), wanted, unit="m/s^2", tolerance=ROUNDED)
    with calls("clear_forces has changed last_acceleration. Clear only self._force.", more=True):
        p.clear_forces()
        got = p.last_acceleration
    expect_close(xyz(got), wanted, unit="m/s^2", tolerance=ROUNDED)
    with calls("No force acted in the last step. Return the constant acceleration.", more=True):
        p.integrate(0.5)
        got = p.last_acceleration
    expect_close(xyz(got), a, unit="m/s^2", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2", asks="Before the first step f is zero", read=LAST)
def test_before_the_first_step_the_last_acceleration_is_the_constant_one(rng: Random) -> None:
    a, f = vector(rng), vector(rng)
    with calls("No step has used the force yet. Return only the constant acceleration."):
        p = Particle(acceleration=Vector3(*a))
        p.add_force(Vector3(*f))
        got = p.last_acceleration
    expect_close(xyz(got), a, unit="m/s^2")
    own = "The caller could change p.acceleration. Return a new vector from every call."
    with calls(own, more=True):
        last = p.last_acceleration
        last.x = 99.0
    expect_unchanged("p.acceleration", p.acceleration, a)
    with calls("After the step, last_acceleration must be a + f / m.", more=True):
        p.integrate(0.5)
        last = p.last_acceleration
        last.x = 99.0
        got = p.last_acceleration
    wanted = a + f
    expect_close(xyz(got), wanted, {own: (99.0, *wanted[1:])}, tolerance=ROUNDED, unit="m/s^2")


@pytest.mark.exercise(
    "B5.2", asks="No force changes the velocity of an immovable particle", read=KICK
)
def test_no_force_moves_an_immovable_particle(rng: Random) -> None:
    x, v, a, f = vector(rng), vector(rng), vector(rng), vector(rng)
    h, mass = draw_duration(rng), round(rng.uniform(2.0, 9.0), 3)
    with calls("Your step changed an immovable particle. Check its inverse mass first."):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf)
        p.add_force(Vector3(*f))
        p.integrate(h)
    expect_unchanged("p.position", p.position, x)
    expect_unchanged("p.velocity", p.velocity, v)
    expect_close(
        xyz(p.force_accumulator), ZERO, then="; p.force_accumulator", unit="N",
        cause="kick must clear the forces in every step, even those on an immovable particle.",
    )  # fmt: skip
    expect_close(
        xyz(p.last_acceleration), a, then="; p.last_acceleration", unit="m/s^2",
        cause="Multiply the force by the inverse mass, which is 0 for an immovable particle.",
    )  # fmt: skip
    with calls("The mass is finite now. Only the second force must act in this step.", more=True):
        p.mass = mass
        p.add_force(Vector3(*f))
        p.integrate(h)
        got = p.velocity
    expect_close(xyz(got), v + (a + f / mass) * h, tolerance=ROUNDED, unit="m/s")


@pytest.mark.exercise("B5.2", asks="Apply the acceleration, forces and damping", read=KICK)
def test_forces_act_in_kick_and_not_in_drift(rng: Random) -> None:
    """Only here drift and kick are called one by one, so that each must do its own part."""
    x, v, a, f = vector(rng), vector(rng), vector(rng), vector(rng)
    mass, h = round(rng.uniform(2.0, 9.0), 3), draw_duration(rng)
    with calls("drift must change only the position, because the forces act in kick."):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass)
        p.add_force(Vector3(*f))
        p.drift(h / 2.0)
    expect_unchanged("p.velocity", p.velocity, v)
    expect_close(xyz(p.force_accumulator), f, then="; p.force_accumulator", unit="N")
    before = xyz(p.position)
    with calls("kick changed the position. Let only drift move the particle.", more=True):
        p.kick(h)
    expect_unchanged("p.position", p.position, before)
    total = a + f / mass
    expect_close(
        xyz(p.velocity), v + total * h, then="; p.velocity", unit="m/s", tolerance=ROUNDED,
        cause="The velocity after kick must be v + (a + f / m) h.",
    )  # fmt: skip
    expect_close(
        xyz(p.force_accumulator), ZERO, then="; p.force_accumulator", unit="N",
        cause="A force acts only once, so kick must set the sum of the forces to zero.",
    )  # fmt: skip
    with calls("The drift must keep the acceleration that the last kick used.", more=True):
        p.drift(h / 2.0)
        got = p.last_acceleration
    expect_close(xyz(got), total, unit="m/s^2", tolerance=ROUNDED)
    expect_close(
        xyz(p.position), x + v * h + total * h * h / 2.0,
        then="; p.position", unit="m", tolerance=ROUNDED,
        cause="The two drifts and the kick must give the exact position for a constant force.",
    )  # fmt: skip
