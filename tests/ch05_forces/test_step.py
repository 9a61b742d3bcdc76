"""The step with forces, build task B5.2."""

from __future__ import annotations

from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces import probes
from ch05_forces.particle import Particle
from draw import Components, components
from expect import about, blame, expect_close, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)
# Numbers up to 100, and a handful of roundings of each.
ROUNDED = 1e-12


def draw_frame(rng: Random) -> float:
    """Draw the duration of a frame, long enough for each mistake to show."""
    return round(rng.uniform(0.2, 0.8), 3)


def draw_mass(rng: Random) -> float:
    """Draw a mass that is far from 1, so that it differs from its inverse."""
    return round(rng.choice((rng.uniform(2.0, 9.0), rng.uniform(0.1, 0.5))), 3)


def moving(
    x: Components, v: Components, a: Components, mass: float, damping: float = 1.0
) -> tuple[str, Particle]:
    """Return a particle and the words that make it."""
    vectors = (("position", x), ("velocity", v), ("acceleration", a))
    words = "".join(f"{name}=Vector3{vector}, " for name, vector in vectors if vector != ZERO)
    words += f"mass={mass}" if damping == 1.0 else f"mass={mass}, damping={damping}"
    return f"p = Particle({words})", Particle(
        Vector3(*x), Vector3(*v), Vector3(*a), mass=mass, damping=damping
    )


@pytest.mark.exercise("B5.2", asks="they add the acceleration f/m")
def test_a_force_changes_the_velocity_by_f_h_over_m(rng: Random) -> None:
    v, f, mass, h = components(rng), components(rng), draw_mass(rng), draw_frame(rng)
    words, p = moving(ZERO, v, ZERO, mass)
    about.call = f"{words}; p.add_force(Vector3{f}); p.integrate({h})"
    about.cause = "A force f divided by the mass m is an acceleration (Eq. 3.2). After a step of "
    about.cause += "h seconds, the new velocity must therefore be v + (f / m) h."
    about.read = "book 5.1"
    p.add_force(Vector3(*f))
    p.integrate(h)
    wanted = tuple(v[i] + f[i] / mass * h for i in range(3))
    got = xyz(p.velocity)
    unused = "kick clears the sum of the forces before using it. First move the sum to "
    unused += "self._last_force, where last_acceleration reads it."
    q = Particle(acceleration=Vector3(1, 2, 3))
    q.add_force(Vector3(0, 0, 0))
    q.integrate(h)
    if xyz(q.velocity) == ZERO:
        unused = "Your kick never changes the velocity, not even by the constant acceleration. "
        unused += "Either it does not compute a new velocity, or it returns before that: `if not "
        unused += "inverse_mass` is true for an immovable particle, `if inverse_mass` for the rest."
    elif xyz(p.force_accumulator) != ZERO:
        unused = "Your kick ignores the force, so the velocity does not change. Use the "
        unused += "acceleration a + f / m, where f is the sum of the forces."
    slips = {
        unused: v,
        "Your new velocity is v + f h, without the mass. Divide the force f by the mass.": [
            v[i] + f[i] * h for i in range(3)
        ],
        "Your new velocity is v + f m h. Divide the force f by the mass m instead of "
        "multiplying, because a heavier particle is harder to accelerate.": [
            v[i] + f[i] * mass * h for i in range(3)
        ],
        "Your new velocity is v + f / m, without the duration h of the step. Multiply f / m by "
        "h.": [v[i] + f[i] / mass for i in range(3)],
    }
    blame(got, slips)
    expect_close(got, wanted, then="; p.velocity", unit="m/s", tolerance=ROUNDED)
    about.cause = "The position must move with the velocity from before the step, as in chapter "
    about.cause += "3. Don't change the position in kick, because drift moves it."
    about.read = "book 3.3.1, the docstring of kick, errata.md"
    slips = {
        "The position moved with the new velocity. It must move with the old one, so drift "
        "before you kick.": [wanted[i] * h for i in range(3)],
        "The position moved twice, in drift and again in kick. Don't change the position in "
        "kick.": [(v[i] + wanted[i]) * h for i in range(3)],
        "Your position contains an extra term (f / m) h^2 / 2, which the book's step leaves out. "
        "Move the position only by v h, where v is the old velocity.": [
            (v[i] + wanted[i]) / 2.0 * h for i in range(3)
        ],
    }
    wanted = tuple(v[i] * h for i in range(3))
    got = xyz(p.position)
    blame(got, slips)
    expect_close(got, wanted, then="; p.position", unit="m", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2", asks="the constant acceleration plus f / m")
def test_several_forces_and_the_constant_acceleration_act_together(rng: Random) -> None:
    v, a, f, g = (components(rng) for _ in range(4))
    mass, h = draw_mass(rng), draw_frame(rng)
    words, p = moving(ZERO, v, a, mass)
    about.call = f"{words}; p.add_force(Vector3{f}); p.add_force(Vector3{g}); p.integrate({h})"
    about.cause = "The acceleration of the step must be a + f / m. Here a is the particle's "
    about.cause += "constant acceleration, f the sum of all forces and m the mass."
    about.read = "the docstring of kick"
    p.add_force(Vector3(*f))
    p.add_force(Vector3(*g))
    p.integrate(h)
    sums = [(f[i] + g[i]) / mass for i in range(3)]
    wanted = tuple(v[i] + (a[i] + sums[i]) * h for i in range(3))
    got = xyz(p.velocity)
    slips = {
        "The constant acceleration a is missing from your step. Use a + f / m instead of f / m.": [
            v[i] + sums[i] * h for i in range(3)
        ],
        "Your new velocity is v + a h, without the forces. Use a + f / m instead of a, where f "
        "is the sum of the forces.": [v[i] + a[i] * h for i in range(3)],
        "You add a without multiplying it by h. Put the sum in parentheses: (a + f / m) h.": [
            v[i] + a[i] + sums[i] * h for i in range(3)
        ],
        "You divide the constant acceleration a by the mass, too. Divide only the forces, because "
        "the acceleration must be a + f / m.": [
            v[i] + (a[i] / mass + sums[i]) * h for i in range(3)
        ],
    }
    blame(got, slips)
    expect_close(got, wanted, then="; p.velocity", unit="m/s", tolerance=ROUNDED)
    about.cause = "The step changed p.acceleration, which must stay constant. Forces act for one "
    about.cause += "step only, so don't store their effect in it."
    slips = {
        "You store a + f / m in p.acceleration, which must stay constant. Compute this sum in a "
        "new vector instead.": [a[i] + sums[i] for i in range(3)]
    }
    blame(xyz(p.acceleration), slips)
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)


@pytest.mark.exercise("B5.2", asks="The new velocity is v' = (v + a h) d^h")
def test_the_damping_also_applies_to_the_effect_of_forces(rng: Random) -> None:
    v, a, f = (components(rng) for _ in range(3))
    mass, h, damping = draw_mass(rng), draw_frame(rng), round(rng.uniform(0.2, 0.8), 3)
    words, p = moving(ZERO, v, a, mass, damping)
    about.call = f"{words}; p.add_force(Vector3{f}); p.integrate({h}); p.velocity"
    about.cause = "The damping d comes last in a step of h seconds. The new velocity must be (v + "
    about.cause += "(a + f / m) h) d^h."
    about.read = "the docstring of kick, E-16 of errata.md"
    p.add_force(Vector3(*f))
    p.integrate(h)
    keep, gained = damping**h, [(a[i] + f[i] / mass) * h for i in range(3)]
    wanted = tuple((v[i] + gained[i]) * keep for i in range(3))
    slips = {
        "You apply the damping before you add the acceleration, as in Eq. 3.6. Follow the book's "
        "listing instead: add the acceleration first, and then multiply the velocity by the "
        "damping to the power of the duration.": [v[i] * keep + gained[i] for i in range(3)],
        "You apply the damping before the force. Let the force act first, and then multiply "
        "the velocity by d^h, the damping to the power of the duration.": [
            (v[i] + a[i] * h) * keep + f[i] / mass * h for i in range(3)
        ],
        "You damp only the change of the velocity. Multiply the whole new velocity by d^h, the "
        "damping to the power of the duration.": [v[i] + gained[i] * keep for i in range(3)],
        "The damping is missing. Multiply the new velocity by d^h, the damping to the power of "
        "the duration.": [v[i] + gained[i] for i in range(3)],
        "You multiply the velocity by d, the damping for a whole second. In a step of h "
        "seconds, multiply by d^h instead.": [(v[i] + gained[i]) * damping for i in range(3)],
    }
    got = xyz(p.velocity)
    blame(got, slips)
    expect_close(got, wanted, tolerance=ROUNDED, unit="m/s")


@pytest.mark.exercise("B5.2", asks="so that each force acts only once")
def test_the_step_clears_the_forces(rng: Random) -> None:
    v, a, f = (components(rng) for _ in range(3))
    mass, h = draw_mass(rng), draw_frame(rng)
    words, p = moving(ZERO, v, a, mass)
    about.call = f"{words}; p.add_force(Vector3{f}); p.integrate({h})"
    about(
        cause=(
            "The force is still there after the step. A force acts for one step only, so kick "
            "must move the sum to self._last_force, and set self._force to Vector3()."
        ),
        read="book 5.1",
    )
    p.add_force(Vector3(*f))
    p.integrate(h)
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator", unit="N")
    about.call += f"; p.integrate({h})"
    p.integrate(h)
    wanted = tuple(v[i] + f[i] / mass * h + a[i] * 2 * h for i in range(3))
    about.cause = "The second step used the force of the first step again. A force acts for one "
    about.cause += "step only."
    expect_close(xyz(p.velocity), wanted, then="; p.velocity", unit="m/s", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2", asks="The new velocity is v' = (v + a h) d^h")
def test_without_forces_the_step_is_that_of_chapter_3(rng: Random) -> None:
    x, v, a = (components(rng) for _ in range(3))
    mass, h, damping = draw_mass(rng), draw_frame(rng), round(rng.uniform(0.2, 0.8), 3)
    words, p = moving(x, v, a, mass, damping)
    about.call = f"{words}; p.integrate({h})"
    about.cause = "Without forces the step must be the same as in chapter 3. The position moves "
    about.cause += "by v h, the new velocity is (v + a h) d^h, and the mass has no effect."
    about.read = "the docstring of kick"
    p.integrate(h)
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    got = xyz(p.position)
    expect_close(got, wanted, then="; p.position", unit="m", tolerance=ROUNDED)
    wanted = tuple((v[i] + a[i] * h) * damping**h for i in range(3))
    got = xyz(p.velocity)
    expect_close(got, wanted, then="; p.velocity", unit="m/s", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2", asks="with the mass and the damping of now")
def test_a_new_damping_and_mass_apply_from_the_next_step(rng: Random) -> None:
    v, f, mass = components(rng), components(rng), draw_mass(rng)
    about.call = f"p = Particle(velocity=Vector3{v}); p.integrate(0.5); p.damping = 0.25; p.mass = "
    about.call += f"{mass}; p.add_force(Vector3{f}); p.integrate(0.5); p.velocity"
    about.cause = "The damping and the mass changed between the two steps. Compute d^h and 1 / m "
    about.cause += "again in every step."
    about.read = "the docstring of kick"
    p = Particle(velocity=Vector3(*v))
    p.integrate(0.5)
    p.damping = 0.25
    p.mass = mass
    p.add_force(Vector3(*f))
    p.integrate(0.5)
    wanted = tuple((v[i] + f[i] / mass * 0.5) * 0.5 for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED, unit="m/s")
    about.call = f"p = Particle(velocity=Vector3{v}, damping=0.25); p.integrate(0.5); "
    about.call += "p.integrate(0.5); p.velocity"
    about.cause = "With a damping of 0.25, a step of 0.5 s must multiply the velocity by "
    about.cause += "0.25^0.5, which is one half."
    p = Particle(velocity=Vector3(*v), damping=0.25)
    p.integrate(0.5)
    p.integrate(0.5)
    wanted = tuple(0.25 * part for part in v)
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED, unit="m/s")


@pytest.mark.exercise("B5.2", asks="0 stops the particle, and a number above 1 speeds it up")
def test_dampings_of_0_and_above_1(rng: Random) -> None:
    v, f = components(rng), components(rng)
    about.read = "the docstring of kick"
    about.cause = "You take the logarithm of the damping, which fails for a damping of 0. Compute "
    about.cause += "damping**duration instead."
    about.call = f"p = Particle(velocity=Vector3{v}, damping=0.0); p.add_force(Vector3{f}); "
    about.call += "p.integrate(0.5); p.velocity"
    p = Particle(velocity=Vector3(*v), damping=0.0)
    p.add_force(Vector3(*f))
    p.integrate(0.5)
    got = xyz(p.velocity)
    about.cause = "The new velocity is not zero, although the damping d is 0. Multiply it by d^h, "
    about.cause += "which is 0."
    expect_close(got, ZERO, unit="m/s")
    about.cause = "The duration is the int 1 here, which must work just like 1.0."
    about.call = f"p = Particle(velocity=Vector3{v}, damping=0.5); p.add_force(Vector3{f}); "
    about.call += "p.integrate(1); p.velocity"
    p = Particle(velocity=Vector3(*v), damping=0.5)
    p.add_force(Vector3(*f))
    p.integrate(1)
    wanted = tuple((v[i] + f[i]) / 2.0 for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED, unit="m/s")
    about.cause = "A damping above 1 is valid and speeds the particle up. Multiply by d^h as "
    about.cause += "usual, where d is the damping and h the duration."
    about.call = f"p = Particle(velocity=Vector3{v}, damping=2.0); p.add_force(Vector3{f}); "
    about.call += "p.integrate(2.0); p.velocity"
    p = Particle(velocity=Vector3(*v), damping=2.0)
    p.add_force(Vector3(*f))
    p.integrate(2.0)
    wanted = tuple((v[i] + 2.0 * f[i]) * 4.0 for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=10.0 * ROUNDED, unit="m/s")


@pytest.mark.exercise("B5.2", asks="Apply the acceleration, forces and damping")
def test_a_constant_force_for_5_seconds(rng: Random) -> None:
    f, mass = components(rng), draw_mass(rng)
    about.call = f"p = Particle(mass={mass}); 300 times: p.add_force(Vector3{f}) and "
    about.call += "p.integrate(1/60)"
    about.cause = "The force is not the same in all steps, or it acts for the wrong length of "
    about.cause += "time. It must change the velocity by (f / m) h in every step of h seconds."
    about.read = "book 5.1, 3.3.2"
    position, velocity = probes.pushed(f, mass, 1.0, 1.0 / 60.0, 300)
    # 300 roundings of numbers up to 1200.
    wanted = tuple(f[i] / mass * (12.5 - 5.0 / 120.0) for i in range(3))
    expect_close(position, wanted, then="; p.position", unit="m", tolerance=1e-10)
    wanted = tuple(f[i] / mass * 5.0 for i in range(3))
    expect_close(velocity, wanted, then="; p.velocity", unit="m/s", tolerance=1e-10)
