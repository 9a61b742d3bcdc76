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
        "You multiply the size of the drag by the velocity v, so the force is |v| times too "
        "large. Multiply it by the unit vector v / |v| instead.": along(-speed * (k1 + k2 * speed)),
        "Your drag leaves out the term with k2. Multiply -v by k1 + k2 |v|, where |v| is the "
        "speed.": (along(-k1)),
        "Your drag leaves out the term with k1. Multiply -v by k1 + k2 |v|, where |v| is the "
        "speed.": (along(-k2 * speed)),
        "Your drag is -v (k1 + k2), without the factor |v|. Multiply k2 by the speed |v|.": along(
            -(k1 + k2)
        ),
        "The size of your drag is k1 + k2, no matter what the speed |v| is. Multiply k1 by |v| "
        "and k2 by |v|^2.": along(-(k1 + k2) / speed),
        "You multiply the unit vector v / |v| by k1 + k2 |v|, so a factor |v| is missing. Multiply "
        "v itself.": along(-(k1 + k2 * speed) / speed),
        "You use the squared length of the velocity as the speed. The speed |v| is its length, "
        "which magnitude() returns.": along(-(k1 * speed + k2 * speed**3)),
        "You multiply k2 by |v|^2 and the whole by v, so one factor |v| is too many. Multiply -v "
        "by k1 + k2 |v|.": along(-(k1 + k2 * speed**2)),
        "The minus sign applies only to the term with k1, so the other term points along the "
        "motion. Put both terms in parentheses after the minus sign.": along(k2 * speed - k1),
        "You multiply both k1 and k2 by |v|^2. Multiply k1 by the speed |v| only.": along(
            -(k1 + k2) * speed
        ),
        "You square k2 as well. Square only the speed.": along(-(k1 + k2 * k2 * speed)),
        "You use a different speed for each axis, such as |x| for the x component. Use the same "
        "total speed |v| in all three components.": (x, y, z),
    }


@pytest.mark.exercise("B5.5", asks="(k1 |v| + k2 |v|^2), as a new vector")
def test_the_drag_at_one_velocity(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    about.call = f"v = Vector3{v}; drag_force(v, k1=0.5, k2=0.25)"
    about.cause = (
        "The drag must be the vector -v (k1 + k2 |v|), where v is the velocity and |v| the "
    )
    about.cause += "speed. Put the sum k1 + k2 |v| in parentheses."
    velocity = Vector3(*v)
    got = xyz(drag_force(velocity, 0.5, 0.25))
    about.cause = "drag_force has changed its argument v. The operations normalize, invert and *= "
    about.cause += "work in place, so use normalized, - and * instead."
    expect_unchanged("v", xyz(velocity), v)
    wanted = tuple(-v[i] * (0.5 + 0.25 * math.hypot(*v)) for i in range(3))
    about.cause = named(
        got,
        "The drag is wrong. It must be -v (k1 + k2 |v|), where v is the velocity and |v| the "
        "speed.",
        drag_slips(v, 0.5, 0.25),
    )
    size = math.hypot(*v) * (0.5 + 0.25 * math.hypot(*v))
    number = "You return the size of the drag, which is a number. Multiply the unit vector along v "
    number += "by it to get a vector against the motion."
    blame(got, [(size, number), (-size, number)])
    expect_close(got, wanted, unit="N")
    about.cause = (
        "Call drag_force with the velocity of the particle, self.k1 and self.k2, and pass "
    )
    about.cause += "its result to particle.add_force."
    about.call = f"p = Particle(velocity=Vector3{v}); Drag(0.5, 0.25).update_force(p, 0.5)"
    p = Particle(velocity=Vector3(*v))
    Drag(0.5, 0.25).update_force(p, 0.5)
    about.cause = "update_force changed the velocity of the particle. It must only add a force."
    expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise("B5.5", asks="drag acts against the motion")
def test_drag_points_against_the_motion(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    k1, k2 = draw_coefficient(rng), draw_coefficient(rng)
    speed = math.hypot(*v)
    for one, two, cause in (
        (
            k1,
            0.0,
            "Here k2 is 0, so there is only linear drag. It must be -k1 v, where v is the "
            "velocity.",
        ),
        (
            0.0,
            k2,
            "Here k1 is 0, so there is only quadratic drag. It must be -k2 |v| v, where |v| is "
            "the speed.",
        ),
        (
            k1,
            k2,
            "The drag is wrong when both its linear and its quadratic part act. It must be -v "
            "(k1 + k2 |v|), where |v| is the speed.",
        ),
    ):
        about(f"drag_force(Vector3{v}, k1={one}, k2={two})", cause=cause)
        wanted = tuple(-v[i] * (one + two * speed) for i in range(3))
        got = xyz(drag_force(Vector3(*v), one, two))
        blame(got, drag_slips(v, one, two))
        expect_close(got, wanted, unit="N")


@pytest.mark.exercise("B5.5", asks="-v^ (k1 |v| + k2 |v|^2)")
def test_drag_grows_with_the_speed_and_with_its_square() -> None:
    about.read = READ
    about.cause = "The drag does not increase with the speed as it should. Multiply k1 by the "
    about.cause += "speed, and k2 by the square of the speed."
    for v, k1, k2, force in (
        ((0.0, 0.0, 2.0), 3.0, 0.0, -6.0),
        ((0.0, 0.0, -2.0), 3.0, 0.0, 6.0),
        ((0.0, 0.0, 2.0), 0.0, 3.0, -12.0),
        ((0.0, 0.0, -4.0), 0.0, 3.0, 48.0),
        ((0.0, 0.0, 0.5), 4.0, 8.0, -4.0),
    ):
        about.call = f"drag_force(Vector3{v}, k1={k1}, k2={k2})"
        got = xyz(drag_force(Vector3(*v), k1, k2))
        expect_close(got, (0.0, 0.0, force), unit="N")


@pytest.mark.exercise("B5.5", asks="If the velocity is zero, so is the drag")
def test_at_rest_there_is_no_drag(rng: Random) -> None:
    about.read = READ
    k1, k2 = draw_coefficient(rng), draw_coefficient(rng)
    about.cause = "You divide by the length of the velocity, which is 0 at rest. There is no drag "
    about.cause += "at rest, so return the zero vector."
    about.call = f"v = Vector3(); f = drag_force(v, k1={k1}, k2={k2})"
    v = Vector3()
    force = drag_force(v, k1, k2)
    expect_close(xyz(force), ZERO, unit="N")
    force.x = 99.0
    about.cause = "For a velocity of zero, you return the vector v itself, so changing the "
    about.cause += "result also changes v. Return a new vector."
    expect_unchanged("v", xyz(v), ZERO, then="; f.x = 99.0")
    about.call = f"drag_force(Vector3(0, 1e-9, 0), k1={k1}, k2={k2})"
    about.cause = "You treat a slow particle as if it were at rest. Its drag is small but not "
    about.cause += "zero, so compute it as usual."
    got = xyz(drag_force(Vector3(0, 1e-9, 0), k1, k2))
    wanted = (0.0, -k1 * 1e-9 - k2 * 1e-18, 0.0)
    expect_close(got, wanted, unit="N")


@pytest.mark.exercise("B5.5", asks="to the particle's other forces")
def test_the_generator_adds_the_drag_of_its_particle(rng: Random) -> None:
    v, f = components(rng), components(rng)
    k1, k2, mass = draw_coefficient(rng), draw_coefficient(rng), round(rng.uniform(2.0, 9.0), 3)
    speed = math.hypot(*v)
    h = 0.0625  # short enough for a drag that never reverses the motion
    about.read = "the docstring of Drag"
    about.call = f"p = Particle(Vector3(1, 2, 3), Vector3{v}, mass={mass}); "
    about.call += f"p.add_force(Vector3{f}); drag = Drag(k1={k1}, k2={k2}); "
    about.call += f"drag.update_force(p, {h}); p.force_accumulator"
    about.cause = "The force on the particle is wrong. Compute the drag from the particle's "
    about.cause += "velocity with drag_force, and add it unchanged."
    p, drag = Particle(Vector3(1, 2, 3), Vector3(*v), mass=mass), Drag(k1, k2)
    p.add_force(Vector3(*f))
    drag.update_force(p, h)
    force = [-v[i] * (k1 + k2 * speed) for i in range(3)]
    wanted = tuple(f[i] + force[i] for i in range(3))
    got = xyz(p.force_accumulator)
    slips = {
        "Your force points along the velocity. drag_force has the minus sign already, so add its "
        "result unchanged.": [f[i] - force[i] for i in range(3)],
        "You divide the drag by the mass. Add the force itself, because the step divides it by "
        "the mass later.": [f[i] + force[i] / mass for i in range(3)],
        "You multiply the drag by the duration. Add the force itself, because the step "
        "multiplies it by the duration later.": [f[i] + force[i] * h for i in range(3)],
        "You swapped k1 and k2. In the drag, k1 is multiplied by the speed, and k2 by the "
        "square of the speed.": [f[i] - v[i] * (k2 + k1 * speed) for i in range(3)],
        "The sum is only the drag, without the force that was added before. Add the drag with "
        "add_force, and don't clear any forces.": force,
        "Your update_force added no force to the particle. Pass the result of drag_force to "
        "particle.add_force.": f,
        "You compute the drag from the position of the particle. Use its velocity instead.": [
            f[i] - (1.0, 2.0, 3.0)[i] * (k1 + k2 * math.sqrt(14.0)) for i in range(3)
        ],
    }
    blame(got, slips)
    # A few roundings of numbers up to 150.
    expect_close(got, wanted, tolerance=1e-12, unit="N")
    about.call += f"; p.clear_forces(); drag.k1 = {k2}; drag.k2 = {k1}; drag.update_force(p, {h}); "
    about.call += "p.force_accumulator"
    about.cause = "You use the initial values of drag.k1 and drag.k2, which have changed since "
    about.cause += "then. Read self.k1 and self.k2 in every call."
    p.clear_forces()
    drag.k1, drag.k2 = k2, k1
    drag.update_force(p, h)
    wanted = tuple(-v[i] * (k2 + k1 * speed) for i in range(3))
    got = xyz(p.force_accumulator)
    expect_close(got, wanted, tolerance=1e-12, unit="N")


@pytest.mark.exercise("B5.5", asks="the drag, -v^ (k1 |v| + k2 |v|^2)")
def test_a_fall_reaches_its_terminal_speed() -> None:
    about(
        "p = Particle(acceleration=Vector3(0, -9.81, 0), mass=2); for 60 s, in steps of h = 1/60 "
        "s: Drag(k1=0.3, k2=0.05).update_force(p, h) and p.integrate(h)",
        read=READ,
    )
    about.cause = "The particle does not fall at its terminal speed v after 60 s. The drag that "
    about.cause += "you add must then equal the weight: k1 v + k2 v^2 = m g."
    _, velocity = with_drag(ZERO, 0.3, 0.05, 2.0, 1.0 / 60.0, 3600, gravity=9.81)
    wanted = (0.0, -17.034969428476803, 0.0)
    # What is left after a minute, e^-60, is far below rounding.
    expect_close(velocity, wanted, then="; p.velocity", unit="m/s", tolerance=1e-10)


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


@pytest.mark.exercise("B5.5", asks="the drag, -v^ (k1 |v| + k2 |v|^2)")
def test_a_fall_is_more_accurate_with_shorter_steps() -> None:
    about(
        "p = Particle(acceleration=Vector3(0, -9.81, 0), mass=2); for 3 s: Drag(k1=0, "
        "k2=0.05).update_force(p, h) and p.integrate(h)",
        read=READ,
    )
    about.cause = "The fall differs too much from the exact one, so the drag is wrong. With k1 = 0 "
    about.cause += "it must be -k2 |v| v, where |v| is the speed."
    states = [with_drag(ZERO, 0.0, 0.05, 2.0, h, round(3.0 / h), 9.81) for h in (0.01, 0.005)]
    speed, distance = 17.878238350449884, 33.699945475035044  # worked out with 40 digits
    speeds = [-velocity[1] - speed for _, velocity in states]
    distances = [-position[1] - distance for position, _ in states]
    expect_first_order((speeds[0], speeds[1]), 0.02, what="the speed")
    expect_first_order((distances[0], distances[1]), 0.06, what="the distance")


@pytest.mark.exercise("B5.5", asks="the drag, -v^ (k1 |v| + k2 |v|^2)")
def test_coasting_is_more_accurate_with_shorter_steps() -> None:
    about(
        "p = Particle(velocity=Vector3(20, 0, 0), mass=2); for 2 s: Drag(k1=0.3, "
        "k2=0.05).update_force(p, h) and p.integrate(h)",
        read=READ,
    )
    about.cause = "The speed differs too much from the exact one, so the drag is wrong. It must be "
    about.cause += "-v (k1 + k2 |v|), where |v| is the speed."
    ends = [
        with_drag((20.0, 0.0, 0.0), 0.3, 0.05, 2.0, h, round(2.0 / h))[1][0] for h in (0.01, 0.005)
    ]
    ratio = 0.05 / 0.3
    exact = 1.0 / ((1.0 / 20.0 + ratio) * math.exp(0.3 * 2.0 / 2.0) - ratio)
    errors = (ends[0] - exact, ends[1] - exact)
    expect_first_order(errors, 0.03, what="the speed")


@pytest.mark.exercise("B5.5", asks="the motion reverses in every step")
def test_linear_drag_in_steps_near_its_limits() -> None:
    about.read = READ
    k1, mass, frames = 8.0, 2.0, 40
    cause = "Your linear drag is wrong. A step of h seconds must multiply the velocity by "
    cause += "1 - k1 h / m, even if this factor is negative."
    about.cause = cause
    limited = "You limit the drag so that it cannot reverse the motion. Remove the limit, because "
    limited += "only the Airbrake has one."
    # The rounding of each step, which the factor below enlarges at most 1.02^40 = 2.2 times.
    for share in (0.98, 1.02, 1.98, 2.02):
        h = share * mass / k1
        for steps in (1, 2, frames):
            about.call = "p = Particle(velocity=Vector3(3, 0, 0), mass=2); "
            about.call += f"{steps} times: " if steps > 1 else ""
            about.call += f"Drag(k1=8, k2=0).update_force(p, {h:g})"
            about.call += " and " if steps > 1 else "; "
            about.call += f"p.integrate({h:g})"
            _, velocity = with_drag((3.0, 0.0, 0.0), k1, 0.0, mass, h, steps)
            wanted = 3.0 * (1.0 - share) ** steps
            why = limited if share > 1.0 and abs(velocity[0]) < 1e-9 else cause
            then = "; p.velocity.x"
            expect_close(velocity[0], wanted, then=then, unit="m/s", cause=why, tolerance=1e-12)
