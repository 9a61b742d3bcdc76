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
        "Your drag points along the velocity, but drag must point against it. Add the missing "
        "minus sign.": along(k1 + k2 * speed),
        "You swapped k1 and k2. In the drag, k1 is multiplied by the speed, and k2 by the "
        "square of the speed.": along(-(k2 + k1 * speed)),
        "You multiply by the velocity v instead of a unit vector, so the force is |v| times "
        "too large. The drag must be -v (k1 + k2 |v|), where |v| is the speed.": along(
            -speed * (k1 + k2 * speed)
        ),
        "Your drag lacks the quadratic part, the one with k2. Multiply -v by k1 + k2 |v|, "
        "where |v| is the speed.": along(-k1),
        "Your drag lacks the linear part, the one with k1. Multiply -v by k1 + k2 |v|, where "
        "|v| is the speed.": along(-k2 * speed),
        "Your drag is -v (k1 + k2), so it lacks a factor |v|. Multiply k2 by the speed |v|.": along(
            -(k1 + k2)
        ),
        "The size of your drag is k1 + k2, whatever the speed |v| is. Multiply k1 by |v| and "
        "k2 by |v|^2.": along(-(k1 + k2) / speed),
        "You compute the drag of each axis from that component of the velocity alone. Drag "
        "depends on the total speed, so use |v| in all three components.": (x, y, z),
    }


@pytest.mark.exercise("B5.5")
def test_the_velocity_is_only_read(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    about.call = f"v = Vector3{v}; drag_force(v, k1=0.5, k2=0.25), in N"
    about.cause = "drag_force must not change v. normalize, invert and *= change a vector in "
    about.cause += "place, so use normalized, - and *, which create new vectors."
    velocity = Vector3(*v)
    got = xyz(drag_force(velocity, 0.5, 0.25))
    expect_unchanged("v", xyz(velocity), v)
    wanted = tuple(-v[i] * (0.5 + 0.25 * math.hypot(*v)) for i in range(3))
    about.cause = named(
        got,
        "The drag must point against the velocity v. It is -v (k1 + k2 |v|), where |v| is the "
        "speed.",
        drag_slips(v, 0.5, 0.25),
    )
    expect_close(got, wanted)
    about.cause = "update_force changed the velocity itself. It must only add a force, and then "
    about.cause += "the step changes the velocity."
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
            "Here k2 is 0, so only the linear part of the drag counts. It is -k1 v, where "
            "v is the velocity.",
        ),
        (
            0.0,
            k2,
            "Here k1 is 0, so only the quadratic part of the drag counts. It is -k2 |v| v, "
            "where |v| is the speed.",
        ),
        (
            k1,
            k2,
            "Here both parts of the drag act. Together they are -v (k1 + k2 |v|), where "
            "|v| is the speed.",
        ),
    ):
        about(f"drag_force(Vector3{v}, k1={one}, k2={two}), in N", cause=cause)
        wanted = tuple(-v[i] * (one + two * speed) for i in range(3))
        got = xyz(drag_force(Vector3(*v), one, two))
        blame(got, drag_slips(v, one, two))
        expect_close(got, wanted)


@pytest.mark.exercise("B5.5")
def test_drag_grows_with_the_speed_and_with_its_square() -> None:
    about.read = READ
    about.cause = "Perhaps you swapped k1 and k2. In the drag, k1 is multiplied by the speed, and "
    about.cause += "k2 by the square of the speed."
    for v, k1, k2, force in (
        ((0.0, 0.0, 2.0), 3.0, 0.0, -6.0),
        ((0.0, 0.0, -2.0), 3.0, 0.0, 6.0),
        ((0.0, 0.0, 2.0), 0.0, 3.0, -12.0),
        ((0.0, 0.0, -4.0), 0.0, 3.0, 48.0),
        ((0.0, 0.0, 0.5), 4.0, 8.0, -4.0),
    ):
        about.call = f"drag_force(Vector3{v}, k1={k1}, k2={k2}), in N"
        got = xyz(drag_force(Vector3(*v), k1, k2))
        expect_close(got, (0.0, 0.0, force))


@pytest.mark.exercise("B5.5")
def test_at_rest_there_is_no_drag(rng: Random) -> None:
    about.read = READ
    k1, k2 = draw_coefficient(rng), draw_coefficient(rng)
    about.cause = "The particle is at rest, so there is no drag. The zero vector has no direction, "
    about.cause += "so don't divide by its length."
    about.call = f"v = Vector3(); f = drag_force(v, k1={k1}, k2={k2})"
    v = Vector3()
    force = drag_force(v, k1, k2)
    expect_close(xyz(force), ZERO)
    force.x = 99.0
    about.cause = "For a velocity of zero you return the vector v itself, so a change of the "
    about.cause += "result changes v too. Return a new vector in every case."
    expect_unchanged("v", xyz(v), ZERO, then="; f.x = 99.0")
    about.call = f"drag_force(Vector3(0, 1e-9, 0), k1={k1}, k2={k2}), in N"
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
    about.call += f"Drag(k1={k1}, k2={k2}); drag.update_force(p, {h}); p.force_accumulator, in N"
    about.cause = "The force on the particle is wrong. Compute the drag from the particle's "
    about.cause += "velocity, without the mass, and add it with add_force."
    p, drag = Particle(velocity=Vector3(*v), mass=mass), Drag(k1, k2)
    p.add_force(Vector3(*f))
    drag.update_force(p, h)
    force = [-v[i] * (k1 + k2 * speed) for i in range(3)]
    wanted = tuple(f[i] + force[i] for i in range(3))
    got = xyz(p.force_accumulator)
    slips = {
        "The drag was divided by the mass, which gives an acceleration. Add the force itself, "
        "because the step divides it by the mass later.": [
            f[i] + force[i] / mass for i in range(3)
        ],
        "The drag was multiplied by the duration. Add the force itself, because the step "
        "multiplies it by the duration later.": [f[i] + force[i] * h for i in range(3)],
        "You swapped k1 and k2. In the drag, k1 is multiplied by the speed, and k2 by the "
        "square of the speed.": [f[i] - v[i] * (k2 + k1 * speed) for i in range(3)],
        "The force that was added before the drag is lost. Use add_force, which adds the drag "
        "to the other forces.": force,
        "The drag is missing, and only the force that was added before is left. Compute the "
        "drag from the particle's velocity and add it.": f,
    }
    blame(got, slips)
    # A few roundings of numbers up to 150.
    expect_close(got, wanted, tolerance=1e-12)
    about.call += f"; p.clear_forces(); drag.k1 = {k2}; drag.k2 = {k1}; drag.update_force(p, {h})"
    about.cause = "The check changes drag.k1 and drag.k2 between two calls of update_force. Read "
    about.cause += "self.k1 and self.k2 in every call instead of storing their first values."
    p.clear_forces()
    drag.k1, drag.k2 = k2, k1
    drag.update_force(p, h)
    wanted = tuple(-v[i] * (k2 + k1 * speed) for i in range(3))
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B5.5")
def test_a_fall_comes_to_its_terminal_speed() -> None:
    about(
        "a particle p of 2 kg that falls for 60 s with g = 9.81 m/s^2; Drag(k1=0.3, "
        "k2=0.05).update_force(p, h) in every step",
        read=READ,
    )
    about.cause = "After 60 s the particle must fall at its terminal speed v, at which the drag "
    about.cause += "equals the weight: k1 v + k2 v^2 = m g. Check the force that Drag adds."
    _, velocity = with_drag(ZERO, 0.3, 0.05, 2.0, 1.0 / 60.0, 3600, gravity=9.81)
    wanted = (0.0, -17.034969428476803, 0.0)
    # What is left after a minute, e^-60, is far below rounding.
    expect_close(velocity, wanted, then="; p.velocity, in m/s", tolerance=1e-10)


def expect_first_order(errors: tuple[float, float], scale: float, *, what: str) -> None:
    """Expect that the error of the longer step is small, and that half the step has half of it.

    For a method of order 1, the ratio is 2 plus a term of order h: at most 0.02 with these steps.
    """
    long, short = errors
    expect_between(long, -scale, scale, then=f"; error of {what} with steps of 1/100 s")
    expect_close(
        long / short,
        2.0,
        then=f"; error of {what} with steps of 1/100 s, divided by the error with steps of 1/200 s",
        tolerance=0.05,
    )


@pytest.mark.exercise("B5.5")
def test_a_fall_with_quadratic_drag_comes_nearer_to_the_exact_one_with_shorter_frames() -> None:
    about(
        "a particle p of 2 kg that falls for 3 s with g = 9.81 m/s^2; Drag(k1=0, "
        "k2=0.05).update_force(p, h) in every step",
        read=READ,
    )
    about.cause = "The speed must be close to u tanh(g t / u) and the distance close to (u^2 / g) "
    about.cause += "ln cosh(g t / u), where u is the terminal speed. Check the force that Drag "
    about.cause += "adds."
    states = [with_drag(ZERO, 0.0, 0.05, 2.0, h, round(3.0 / h), 9.81) for h in (0.01, 0.005)]
    speed, distance = 17.878238350449884, 33.699945475035044  # worked out with 40 digits
    speeds = [-velocity[1] - speed for _, velocity in states]
    distances = [-position[1] - distance for position, _ in states]
    expect_first_order((speeds[0], speeds[1]), 0.02, what="the speed")
    expect_first_order((distances[0], distances[1]), 0.06, what="the distance")


@pytest.mark.exercise("B5.5")
def test_coasting_with_both_kinds_of_drag_comes_nearer_with_shorter_frames() -> None:
    about(
        "a particle p of 2 kg that starts at 20 m/s and moves for 2 s; Drag(k1=0.3, "
        "k2=0.05).update_force(p, h) in every step",
        read=READ,
    )
    about.cause = "The speed is too far from the exact solution, in which 1 / v + k2 / k1 grows "
    about.cause += "by the factor e^(k1 t / m). Check the force that Drag adds."
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
    about.cause = "In a step of h seconds, linear drag multiplies the velocity by 1 - k1 h / m, "
    about.cause += "even if this factor is negative. Drag must not limit its force, because only "
    about.cause += "the Airbrake does that."
    # The rounding of each step, which the factor below enlarges at most 1.02^40 = 2.2 times.
    for share in (0.98, 1.02, 1.98, 2.02):
        h = share * mass / k1
        about.call = "a particle p of 2 kg that starts at 3 m/s; Drag(k1=8, k2=0).update_force(p, "
        about.call += f"h) in every step, with h = {h:g} s, which is {share} m / k1"
        for steps in (1, 2, frames):
            _, velocity = with_drag((3.0, 0.0, 0.0), k1, 0.0, mass, h, steps)
            wanted = 3.0 * (1.0 - share) ** steps
            then = f"; p.velocity.x after {steps} step{'s' * (steps > 1)}, in m/s"
            expect_close(velocity[0], wanted, then=then, tolerance=1e-12)
