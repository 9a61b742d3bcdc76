"""The step with forces, build task B5.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces import probes
from ch05_forces.particle import Particle
from draw import Components, components
from expect import UNCHANGED, about, blame, expect_close, expect_error, expect_unchanged, xyz

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
    words = f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, mass={mass}"
    words += f", damping={damping})" if damping != 1.0 else ")"
    return words, Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass, damping=damping)


@pytest.mark.exercise("B5.2")
def test_a_force_changes_the_velocity_by_f_h_over_m(rng: Random) -> None:
    v, f, mass, h = components(rng), components(rng), draw_mass(rng), draw_frame(rng)
    words, p = moving(ZERO, v, ZERO, mass)
    about.call = f"{words}; p.add_force(Vector3{f}); p.integrate({h})"
    about.cause = "v' = v + (f / m) h. A force divided by the mass is an acceleration (Eq. 3.2)."
    about.read = "book 5.1"
    p.add_force(Vector3(*f))
    p.integrate(h)
    wanted = tuple(v[i] + f[i] / mass * h for i in range(3))
    got = xyz(p.velocity)
    slips = {
        "The velocity did not change. Either the kick does not use the force, or it clears the sum "
        "first. Move the sum to self._forces[1] before you use last_acceleration.": v,
        "The result is v + f h. Divide the force by the mass.": [v[i] + f[i] * h for i in range(3)],
        "The result is v + f m h. Divide by the mass instead of multiplying.": [
            v[i] + f[i] * mass * h for i in range(3)
        ],
        "The result is v + f / m. Multiply by the duration.": [
            v[i] + f[i] / mass for i in range(3)
        ],
    }
    blame(got, slips)
    expect_close(got, wanted, then="; p.velocity", tolerance=ROUNDED)
    about.cause = "The position moves with the velocity from before the step, as in chapter 3."
    about.read = "book 3.3.2, the docstring of kick, errata.md"
    slips = {
        "The position moved with the new velocity. Drift before you kick.": [
            wanted[i] * h for i in range(3)
        ],
        "The position moved by v h + a h^2 / 2. The book's step leaves out the second term.": [
            (v[i] + wanted[i]) / 2.0 * h for i in range(3)
        ],
    }
    wanted = tuple(v[i] * h for i in range(3))
    got = xyz(p.position)
    blame(got, slips)
    expect_close(got, wanted, then="; p.position", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_several_forces_and_the_constant_acceleration_act_together(rng: Random) -> None:
    v, a, f, g = (components(rng) for _ in range(4))
    mass, h = draw_mass(rng), draw_frame(rng)
    words, p = moving(ZERO, v, a, mass)
    about.call = f"{words}; p.add_force(Vector3{f}); p.add_force(Vector3{g}); p.integrate({h})"
    about.cause = "The step's acceleration is a + f / m, where f is the sum of all forces."
    about.read = "the docstring of kick"
    p.add_force(Vector3(*f))
    p.add_force(Vector3(*g))
    p.integrate(h)
    sums = [(f[i] + g[i]) / mass for i in range(3)]
    wanted = tuple(v[i] + (a[i] + sums[i]) * h for i in range(3))
    got = xyz(p.velocity)
    slips = {
        "The constant acceleration is missing. Add it to f / m.": [
            v[i] + sums[i] * h for i in range(3)
        ],
        "The result is v + a h. The forces are missing.": [v[i] + a[i] * h for i in range(3)],
    }
    blame(got, slips)
    expect_close(got, wanted, then="; p.velocity", tolerance=ROUNDED)
    about.cause = "The constant acceleration never changes. Forces last for one step only."
    slips = {
        "p.acceleration is now a + f / m. Do not store the sum there.": [
            a[i] + sums[i] for i in range(3)
        ]
    }
    blame(xyz(p.acceleration), slips)
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)


@pytest.mark.exercise("B5.2")
def test_what_a_force_adds_is_damped_too(rng: Random) -> None:
    v, a, f = (components(rng) for _ in range(3))
    mass, h, damping = draw_mass(rng), draw_frame(rng), round(rng.uniform(0.2, 0.8), 3)
    words, p = moving(ZERO, v, a, mass, damping)
    about.call = f"{words}; p.add_force(Vector3{f}); p.integrate({h}); p.velocity"
    about.cause = "v' = (v + (a + f / m) h) d^h. The damping comes last."
    about.read = "the docstring of kick, E-16 of errata.md"
    p.add_force(Vector3(*f))
    p.integrate(h)
    keep, gained = damping**h, [(a[i] + f[i] / mass) * h for i in range(3)]
    wanted = tuple((v[i] + gained[i]) * keep for i in range(3))
    slips = {
        "The result is v d^h + a h, as in Eq. 3.6. The book's listing damps at the end (E-16).": [
            v[i] * keep + gained[i] for i in range(3)
        ],
        "The velocity from the force is not damped. Add f / m before you damp.": [
            (v[i] + a[i] * h) * keep + f[i] / mass * h for i in range(3)
        ],
        "The damping is missing. Multiply by d^h.": [v[i] + gained[i] for i in range(3)],
        "The velocity was multiplied by d. Multiply by d^h.": [
            (v[i] + gained[i]) * damping for i in range(3)
        ],
    }
    got = xyz(p.velocity)
    blame(got, slips)
    expect_close(got, wanted, tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_the_step_clears_the_forces(rng: Random) -> None:
    v, a, f = (components(rng) for _ in range(3))
    mass, h = draw_mass(rng), draw_frame(rng)
    words, p = moving(ZERO, v, a, mass)
    about.call = f"{words}; p.add_force(Vector3{f}); p.integrate({h})"
    about(cause="A force acts for one step. The kick clears the sum.", read="book 5.1")
    p.add_force(Vector3(*f))
    p.integrate(h)
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator")
    p.integrate(h)
    wanted = tuple(v[i] + f[i] / mass * h + a[i] * 2 * h for i in range(3))
    expect_close(xyz(p.velocity), wanted, then=f"; p.integrate({h}); p.velocity", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_without_forces_the_step_is_chapter_3s(rng: Random) -> None:
    x, v, a = (components(rng) for _ in range(3))
    mass, h, damping = draw_mass(rng), draw_frame(rng), round(rng.uniform(0.2, 0.8), 3)
    words, p = moving(x, v, a, mass, damping)
    about.call = f"{words}; p.integrate({h})"
    about.cause = "Without forces, p' = p + v h and v' = (v + a h) d^h. The mass has no effect."
    about.read = "the docstring of kick"
    p.integrate(h)
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    got = xyz(p.position)
    expect_close(got, wanted, then="; p.position", tolerance=ROUNDED)
    wanted = tuple((v[i] + a[i] * h) * damping**h for i in range(3))
    got = xyz(p.velocity)
    expect_close(got, wanted, then="; p.velocity", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_a_new_damping_and_a_new_mass_count_from_the_next_step_on(rng: Random) -> None:
    v, f, mass = components(rng), components(rng), draw_mass(rng)
    about.call = f"p = Particle(velocity=Vector3{v}); p.integrate(0.5); p.damping = 0.25; p.mass = "
    about.call += f"{mass}; p.add_force(Vector3{f}); p.integrate(0.5); p.velocity"
    about.cause = "Use the current d^h and 1 / m. Values stored in an earlier step are outdated."
    about.read = "the docstring of kick"
    p = Particle(velocity=Vector3(*v))
    p.integrate(0.5)
    p.damping = 0.25
    p.mass = mass
    p.add_force(Vector3(*f))
    p.integrate(0.5)
    wanted = tuple((v[i] + f[i] / mass * 0.5) * 0.5 for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED)
    about.call = f"p = Particle(velocity=Vector3{v}, damping=0.25); p.integrate(0.5) twice; "
    about.call += "p.velocity"
    about.cause = "Each step of 0.5 s keeps the fraction 0.25^0.5, which is a half."
    p = Particle(velocity=Vector3(*v), damping=0.25)
    p.integrate(0.5)
    p.integrate(0.5)
    wanted = tuple(0.25 * part for part in v)
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_a_damping_of_0_and_a_frame_of_a_whole_second(rng: Random) -> None:
    v, f = components(rng), components(rng)
    about.read = "the docstring of kick"
    about.cause = "0^h is 0, so a damping of 0 stops the particle, even if a force acts."
    about.call = f"p = Particle(velocity=Vector3{v}, damping=0.0); p.add_force(Vector3{f}); "
    about.call += "p.integrate(0.5); p.velocity"
    p = Particle(velocity=Vector3(*v), damping=0.0)
    p.add_force(Vector3(*f))
    p.integrate(0.5)
    expect_close(xyz(p.velocity), ZERO)
    about.cause = "A duration of 1, an int, is as valid as 1.0."
    about.call = f"p = Particle(velocity=Vector3{v}, damping=0.5); p.add_force(Vector3{f}); "
    about.call += "p.integrate(1); p.velocity"
    p = Particle(velocity=Vector3(*v), damping=0.5)
    p.add_force(Vector3(*f))
    p.integrate(1)
    wanted = tuple((v[i] + f[i]) / 2.0 for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED)
    about.cause = "A damping above 1 makes the particle faster. Use d^h as usual."
    about.call = f"p = Particle(velocity=Vector3{v}, damping=2.0); p.add_force(Vector3{f}); "
    about.call += "p.integrate(2.0); p.velocity"
    p = Particle(velocity=Vector3(*v), damping=2.0)
    p.add_force(Vector3(*f))
    p.integrate(2.0)
    wanted = tuple((v[i] + 2.0 * f[i]) * 4.0 for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=10.0 * ROUNDED)


@pytest.mark.exercise("B5.2")
def test_a_push_of_5_seconds_lags_as_explicit_euler_does(rng: Random) -> None:
    f, mass = components(rng), draw_mass(rng)
    about.call = f"p = Particle(mass={mass}); 300 times p.add_force(Vector3{f}), p.integrate(1/60)"
    about.cause = "A constant force is a constant acceleration. Explicit Euler is a t h / 2 behind."
    about.read = "book 5.1, 3.3.2"
    position, velocity = probes.pushed(f, mass, 1.0, 1.0 / 60.0, 300)
    # 300 roundings of numbers up to 1200.
    wanted = tuple(f[i] / mass * (12.5 - 5.0 / 120.0) for i in range(3))
    expect_close(position, wanted, then="; p.position", tolerance=1e-10)
    wanted = tuple(f[i] / mass * 5.0 for i in range(3))
    expect_close(velocity, wanted, then="; p.velocity", tolerance=1e-10)


@pytest.mark.exercise("B5.2")
def test_the_last_acceleration_includes_the_forces_of_the_step(rng: Random) -> None:
    a, f, g, mass = components(rng), components(rng), components(rng), draw_mass(rng)
    about.call = f"p = Particle(acceleration=Vector3{a}, mass={mass}, damping=0.5); "
    about.call += f"p.add_force(Vector3{f}); p.integrate(0.5)"
    about.cause = "Return a + f / m of the last step, without damping."
    about.read = "the docstring of last_acceleration"
    p = Particle(acceleration=Vector3(*a), mass=mass, damping=0.5)
    p.add_force(Vector3(*f))
    p.integrate(0.5)
    wanted = tuple(a[i] + f[i] / mass for i in range(3))
    got = xyz(p.last_acceleration)
    slips = {
        "This is the constant acceleration only. The kick must store the forces that it uses in "
        "self._forces[1], where last_acceleration reads them.": a,
        "The result is a + f. Divide the force by the mass.": [a[i] + f[i] for i in range(3)],
        "The result is a + f m. Divide by the mass instead.": [
            a[i] + f[i] * mass for i in range(3)
        ],
        "The result is f / m. Add the constant acceleration.": [f[i] / mass for i in range(3)],
    }
    blame(got, slips)
    expect_close(got, wanted, then="; p.last_acceleration", tolerance=ROUNDED)
    about.cause = "Forces for the next step must not change the acceleration of the last one."
    p.add_force(Vector3(*g))
    got = xyz(p.last_acceleration)
    expect_close(
        got, wanted, then=f"; p.add_force(Vector3{g}); p.last_acceleration", tolerance=ROUNDED
    )
    about.cause = "clear_forces clears only the forces for the next step."
    p.clear_forces()
    got = xyz(p.last_acceleration)
    expect_close(got, wanted, then="; p.clear_forces(); p.last_acceleration", tolerance=ROUNDED)
    about.cause = "After a step without forces, the result is the constant acceleration."
    p.integrate(0.5)
    expect_close(
        xyz(p.last_acceleration),
        a,
        then="; p.integrate(0.5); p.last_acceleration",
        tolerance=ROUNDED,
    )


@pytest.mark.exercise("B5.2")
def test_before_the_first_step_the_last_acceleration_is_the_constant_one(rng: Random) -> None:
    a, f = components(rng), components(rng)
    about.call = f"p = Particle(acceleration=Vector3{a}); p.add_force(Vector3{f}); "
    about.call += "p.last_acceleration"
    about(cause="No step has used the force yet.", read="the docstring of last_acceleration")
    p = Particle(acceleration=Vector3(*a))
    p.add_force(Vector3(*f))
    last = p.last_acceleration
    expect_close(xyz(last), a)
    last.x = 99.0
    about.cause = "Return a new vector, so that changing it does not change the particle."
    expect_unchanged("p.acceleration", xyz(p.acceleration), a, then=".x = 99.0", cause=UNCHANGED)
    p.integrate(0.5)
    last = p.last_acceleration
    last.x = 99.0
    wanted = tuple(a[i] + f[i] for i in range(3))
    name = f"{about.call[: about.call.rindex(';')]}; p.integrate(0.5); p.last_acceleration.x = 99.0"
    name += "; p.last_acceleration"
    got = xyz(p.last_acceleration)
    expect_close(got, wanted, call=name, tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_no_force_moves_an_immovable_particle(rng: Random) -> None:
    x, v, a, f = (components(rng) for _ in range(4))
    h, mass = draw_frame(rng), draw_mass(rng)
    about.call = f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, mass=math.inf); "
    about.call += f"p.add_force(Vector3{f}); p.integrate({h})"
    about(cause="Check the inverse mass before you move anything.", read="the docstring of kick")
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf)
    p.add_force(Vector3(*f))
    p.integrate(h)
    expect_unchanged("p.position", xyz(p.position), x)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    about.cause = "Clear its forces, too. Otherwise they add up until the particle becomes movable."
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator")
    about.cause = (
        "Forces do not accelerate an immovable particle, so only the constant acceleration is left."
    )
    expect_close(xyz(p.last_acceleration), a, then="; p.last_acceleration")
    p.mass = mass
    p.add_force(Vector3(*f))
    p.integrate(h)
    about.call += f"; p.mass = {mass}; p.add_force(Vector3{f}); p.integrate({h}); p.velocity"
    about.cause = "The mass is finite now, and only the new force acts."
    wanted = tuple(v[i] + (a[i] + f[i] / mass) * h for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
def test_a_drift_leaves_the_forces_to_the_kick(rng: Random) -> None:
    x, v, a, f = (components(rng) for _ in range(4))
    mass, h = draw_mass(rng), draw_frame(rng)
    words, p = moving(x, v, a, mass)
    about(f"{words}; p.add_force(Vector3{f}); p.drift({h} / 2)", read="the docstring of kick")
    p.add_force(Vector3(*f))
    p.drift(h / 2.0)
    about.cause = "A drift changes only the position. The forces wait for the kick."
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    got = xyz(p.force_accumulator)
    expect_close(got, f, then="; p.force_accumulator")
    about.call += f"; p.kick({h})"
    before = xyz(p.position)
    p.kick(h)
    about.cause = "A kick changes only the velocity: v' = (v + (a + f / m) h) d^h."
    expect_unchanged("p.position", xyz(p.position), before)
    total = [a[i] + f[i] / mass for i in range(3)]
    wanted = tuple(v[i] + total[i] * h for i in range(3))
    got = xyz(p.velocity)
    expect_close(got, wanted, then="; p.velocity", tolerance=ROUNDED)
    about.cause = "The kick has used the forces, so it clears their sum."
    got = xyz(p.force_accumulator)
    expect_close(got, ZERO, then="; p.force_accumulator")
    about.cause = "last_acceleration is the acceleration that the last kick used."
    about.call += f"; p.drift({h} / 2)"
    p.drift(h / 2.0)
    got = xyz(p.last_acceleration)
    expect_close(got, total, then="; p.last_acceleration", tolerance=ROUNDED)
    about.cause = "Half a drift, a kick and half a drift are exact under a constant force."
    wanted = tuple(x[i] + v[i] * h + total[i] * h * h / 2.0 for i in range(3))
    got = xyz(p.position)
    expect_close(got, wanted, then="; p.position", tolerance=ROUNDED)


@pytest.mark.exercise("B5.2")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan, "0.5"])
def test_a_refused_step_keeps_the_forces(duration: float) -> None:
    about.read = "the docstring of kick"
    error = TypeError if isinstance(duration, str) else ValueError
    x, v, a, f = (1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0), (1.0, -2.0, 3.0)
    for mass in (2.0, math.inf):
        words, p = moving(x, v, a, mass)
        about.cause = "The duration must be positive and finite. integrate checks it."
        about.call = f"{words}; p.add_force(Vector3{f}); p.integrate({duration!r})"
        p.add_force(Vector3(*f))
        expect_error(
            lambda p=p: p.integrate(duration), error, allowed=lambda: Particle().integrate(0.5)
        )
        about.cause = "Refuse the duration before you change anything."
        expect_unchanged("p.position", xyz(p.position), x)
        expect_unchanged("p.velocity", xyz(p.velocity), v)
        expect_unchanged("p.acceleration", xyz(p.acceleration), a)
        got = xyz(p.force_accumulator)
        expect_close(got, f, then="; p.force_accumulator")
        got = xyz(p.last_acceleration)
        expect_close(got, a, then="; p.last_acceleration")
