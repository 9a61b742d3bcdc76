"""Drag, build task B5.5: the force, and where the steps that it is used in lead."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Drag, drag_force
from ch05_forces.particle import Particle
from ch05_forces.probes import with_drag
from draw import Components, components
from expect import about, blame, expect_between, expect_close, expect_unchanged, named, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "book 5.2.4, Eq. 5.1"


def draw_coefficient(rng: Random) -> float:
    return round(rng.uniform(0.2, 0.9), 3)


def drag_slips(v: Components, k1: float, k2: float) -> dict[str, Components]:
    """Return what likely mistakes make of a drag that is -v (k1 + k2 |v|)."""
    speed = math.hypot(*v)

    def along(size: float) -> Components:
        return v[0] * size, v[1] * size, v[2] * size

    x, y, z = (-part * (k1 + k2 * abs(part)) for part in v)
    return {
        "The force points along the motion, but it must point against it. Add the missing minus "
        "sign.": along(k1 + k2 * speed),
        "k1 and k2 are swapped. k1 goes with the speed, and k2 goes with its square.": along(
            -(k2 + k1 * speed)
        ),
        "You used v instead of the unit vector v^, so the force is |v| times too large.": along(
            -speed * (k1 + k2 * speed)
        ),
        "The quadratic part of the drag is missing. Add k2 |v| to k1.": along(-k1),
        "The linear part of the drag is missing. Add k1 to k2 |v|.": along(-k2 * speed),
        "This force is -v (k1 + k2), which lacks a factor |v|. Multiply k2 by the speed.": along(
            -(k1 + k2)
        ),
        "This force is -v^ (k1 + k2), which doesn't depend on the speed. Multiply k1 by |v| and k2 "
        "by |v|^2.": along(-(k1 + k2) / speed),
        "You computed the drag for each axis separately. It depends on the whole speed, so use |v| "
        "for all three components.": (x, y, z),
    }


@pytest.mark.exercise("B5.5")
def test_the_velocity_is_only_read(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    about.call = f"v = Vector3{v}; drag_force(v, 0.5, 0.25)"
    about.cause = "drag_force must not change v. normalize, invert and *= work in place, so use "
    about.cause += "normalized, - and *, which create new vectors."
    velocity = Vector3(*v)
    got = xyz(drag_force(velocity, 0.5, 0.25))
    expect_unchanged("v", xyz(velocity), v)
    wanted = tuple(-v[i] * (0.5 + 0.25 * math.hypot(*v)) for i in range(3))
    about.cause = named(
        got,
        "The drag must point against the velocity, so it is -v (k1 + k2 |v|).",
        drag_slips(v, 0.5, 0.25),
    )
    expect_close(got, wanted)
    about.cause = "The generator changed the velocity itself. It must only add a force, and let "
    about.cause += "the step change the velocity."
    about.call = f"p = Particle(velocity=Vector3{v}); Drag(0.5, 0.25).update_force(p, 0.5)"
    p = Particle(velocity=Vector3(*v))
    Drag(0.5, 0.25).update_force(p, 0.5)
    expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise("B5.5")
def test_drag_points_against_the_motion(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    k1, k2 = draw_coefficient(rng), draw_coefficient(rng)
    speed = math.hypot(*v)
    for one, two, cause in (
        (
            k1,
            0.0,
            (
                "Here k2 is 0, so only k1 counts. This part of the drag is -k1 v, because v^ |v| "
                "is v."
            ),
        ),
        (
            0.0,
            k2,
            "Here k1 is 0, so only k2 counts. This part of the drag is -k2 |v| v, because v^ "
            "|v|^2 is v |v|.",
        ),
        (k1, k2, "Both parts of the drag act here, and they add up to -v (k1 + k2 |v|)."),
    ):
        about(f"drag_force(Vector3{v}, {one}, {two})", cause=cause)
        wanted = tuple(-v[i] * (one + two * speed) for i in range(3))
        got = xyz(drag_force(Vector3(*v), one, two))
        blame(got, drag_slips(v, one, two))
        expect_close(got, wanted)


@pytest.mark.exercise("B5.5")
def test_drag_grows_with_the_speed_and_with_its_square() -> None:
    about.read = READ
    about.cause = "Perhaps you swapped the two coefficients. k1 goes with the speed, and k2 goes "
    about.cause += "with its square."
    for v, k1, k2, force in (
        ((0.0, 0.0, 2.0), 3.0, 0.0, -6.0),
        ((0.0, 0.0, -2.0), 3.0, 0.0, 6.0),
        ((0.0, 0.0, 2.0), 0.0, 3.0, -12.0),
        ((0.0, 0.0, -4.0), 0.0, 3.0, 48.0),
        ((0.0, 0.0, 0.5), 4.0, 8.0, -4.0),
    ):
        about.call = f"drag_force(Vector3{v}, {k1}, {k2})"
        got = xyz(drag_force(Vector3(*v), k1, k2))
        expect_close(got, (0.0, 0.0, force))


@pytest.mark.exercise("B5.5")
def test_at_rest_there_is_no_drag(rng: Random) -> None:
    about.read = READ
    k1, k2 = draw_coefficient(rng), draw_coefficient(rng)
    about.cause = "The particle is at rest, so there is no drag. The zero vector has no direction, "
    about.cause += "so don't divide by its length."
    about.call = f"v = Vector3(); f = drag_force(v, {k1}, {k2})"
    v = Vector3()
    force = drag_force(v, k1, k2)
    expect_close(xyz(force), ZERO)
    force.x = 99.0
    about.cause = "For a particle at rest, you returned the vector v itself. Return a new vector "
    about.cause += "in every case."
    expect_unchanged("v", xyz(v), ZERO, then="; f.x = 99.0")
    about.call = f"drag_force(Vector3(0, 1e-9, 0), {k1}, {k2})"
    about.cause = "The speed is low, so the drag is small, but it is not zero. Don't treat a slow "
    about.cause += "particle as if it were at rest."
    got = xyz(drag_force(Vector3(0, 1e-9, 0), k1, k2))
    wanted = (0.0, -k1 * 1e-9 - k2 * 1e-18, 0.0)
    expect_close(got, wanted)


@pytest.mark.exercise("B5.5")
def test_the_generator_adds_the_drag_of_its_particle(rng: Random) -> None:
    v, f = components(rng), components(rng)
    k1, k2, mass = draw_coefficient(rng), draw_coefficient(rng), round(rng.uniform(2.0, 9.0), 3)
    speed = math.hypot(*v)
    h = 0.0625  # short enough for a drag that never reverses the motion
    about.read = "the docstring of Drag"
    about.call = f"p = Particle(velocity=Vector3{v}, mass={mass}); p.add_force(Vector3{f}); drag = "
    about.call += f"Drag({k1}, {k2}); drag.update_force(p, {h}); p.force_accumulator"
    about.cause = "Compute the drag from the particle's velocity, and add it with add_force. Drag "
    about.cause += "is a force, so it doesn't depend on the mass."
    p, drag = Particle(velocity=Vector3(*v), mass=mass), Drag(k1, k2)
    p.add_force(Vector3(*f))
    drag.update_force(p, h)
    force = [-v[i] * (k1 + k2 * speed) for i in range(3)]
    wanted = tuple(f[i] + force[i] for i in range(3))
    got = xyz(p.force_accumulator)
    slips = {
        "The drag was divided by the mass, which makes it an acceleration. Add the force itself, "
        "and let the step divide by the mass.": [f[i] + force[i] / mass for i in range(3)],
        "The drag was multiplied by the duration. Add the force itself, and let the step multiply "
        "it by the duration.": [f[i] + force[i] * h for i in range(3)],
        "k1 and k2 are swapped. k1 goes with the speed, and k2 goes with its square.": [
            f[i] - v[i] * (k2 + k1 * speed) for i in range(3)
        ],
        "The force that was already there is gone. Use add_force, which adds the drag to the other "
        "forces.": force,
        "The drag is missing, and only the other force is left. Compute the drag from the "
        "particle's velocity and add it.": f,
    }
    blame(got, slips)
    # A few roundings of numbers up to 150.
    expect_close(got, wanted, tolerance=1e-12)
    about.call += f"; p.clear_forces(); drag.k1 = {k2}; drag.k2 = {k1}; drag.update_force(p, {h})"
    about.cause = "The check changes k1 and k2 between the two calls. Read self.k1 and self.k2 in "
    about.cause += "every call."
    p.clear_forces()
    drag.k1, drag.k2 = k2, k1
    drag.update_force(p, h)
    wanted = tuple(-v[i] * (k2 + k1 * speed) for i in range(3))
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B5.5")
def test_a_fall_comes_to_its_terminal_speed() -> None:
    about("drag = Drag(0.3, 0.05), 2 kg, g = 9.81; a minute of drag.update_force(), ", read=READ)
    about.call += "p.integrate()"
    about.cause = "The body must reach its terminal speed, where the drag equals the weight: k1 v "
    about.cause += "+ k2 v^2 = m g."
    _, velocity = with_drag(ZERO, 0.3, 0.05, 2.0, 1.0 / 60.0, 3600, gravity=9.81)
    wanted = (0.0, -17.034969428476803, 0.0)
    # What is left after a minute, e^-60, is far below rounding.
    expect_close(velocity, wanted, then="; p.velocity", tolerance=1e-10)


def expect_first_order(errors: tuple[float, float], scale: float, *, what: str) -> None:
    """Expect that the error of the longer step is small, and that half the step has half of it.

    For a method of order 1, the ratio is 2 plus a term of order h: at most 0.02 with these steps.
    """
    long, short = errors
    expect_between(long, -scale, scale, then=f": error of {what}, at h = 1/100")
    expect_close(
        long / short, 2.0, then=f": error of {what}, at h = 1/100 over h = 1/200", tolerance=0.05
    )


@pytest.mark.exercise("B5.5")
def test_a_fall_with_quadratic_drag_comes_nearer_to_the_exact_one_with_shorter_frames() -> None:
    about("Drag(0, 0.05), 2 kg, g = 9.81, a fall of 3 s by drag.update_force(), ", read=READ)
    about.call += "p.integrate()"
    about.cause = "The motion strays too far from the exact solution, in which the speed is v_t "
    about.cause += "tanh(g t / v_t) and the distance is v_t^2 / g ln cosh(g t / v_t)."
    states = [with_drag(ZERO, 0.0, 0.05, 2.0, h, round(3.0 / h), 9.81) for h in (0.01, 0.005)]
    speed, distance = 17.878238350449884, 33.699945475035044  # worked out with 40 digits
    speeds = [-velocity[1] - speed for _, velocity in states]
    distances = [-position[1] - distance for position, _ in states]
    expect_first_order((speeds[0], speeds[1]), 0.02, what="the speed")
    expect_first_order((distances[0], distances[1]), 0.06, what="the distance")


@pytest.mark.exercise("B5.5")
def test_coasting_with_both_kinds_of_drag_comes_nearer_with_shorter_frames() -> None:
    about("Drag(0.3, 0.05), 2 kg, 20 m/s, 2 s of drag.update_force(), p.integrate()", read=READ)
    about.cause = "The motion strays too far from the exact solution, which is 1 / v + k2 / k1 = "
    about.cause += "(1 / v0 + k2 / k1) e^(k1 t / m). Check the drag force."
    ends = [
        with_drag((20.0, 0.0, 0.0), 0.3, 0.05, 2.0, h, round(2.0 / h))[1][0] for h in (0.01, 0.005)
    ]
    ratio = 0.05 / 0.3
    exact = 1.0 / ((1.0 / 20.0 + ratio) * math.exp(0.3 * 2.0 / 2.0) - ratio)
    errors = (ends[0] - exact, ends[1] - exact)
    expect_first_order(errors, 0.03, what="the speed")


@pytest.mark.exercise("B5.5")
def test_linear_drag_in_frames_just_inside_and_just_outside_its_limits() -> None:
    about.read = READ
    k1, mass, frames = 8.0, 2.0, 40
    about.cause = "With linear drag, each step multiplies v by 1 - k1 h / m, even if that factor "
    about.cause += "is negative. Unlike the Airbrake, Drag must not limit its force."
    # The rounding of each step, which the factor below enlarges at most 1.02^40 = 2.2 times.
    for share in (0.98, 1.02, 1.98, 2.02):
        h = share * mass / k1
        about.call = f"p at 3 m/s, 2 kg, Drag(8, 0), h = {share} m / k1 = {h}; p.velocity.x"
        for steps in (1, 2, frames):
            _, velocity = with_drag((3.0, 0.0, 0.0), k1, 0.0, mass, h, steps)
            wanted = 3.0 * (1.0 - share) ** steps
            then = f" after {steps} times drag.update_force(), p.integrate()"
            expect_close(velocity[0], wanted, then=then, tolerance=1e-12)
