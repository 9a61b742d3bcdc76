"""Drag, where steps with it lead (B5.5), and time steps that are too long for it (B5.8)."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.closed_form import drag_limits
from ch05_forces.forces import Drag, drag_force
from ch05_forces.particle import Particle
from ch05_forces.probes import march
from draw import Triple, positive_number, vector
from expect import expect_between, expect_close, expect_exactly, expect_unchanged, named, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "book 5.2.4, Eq. 5.1"
LIMITS = "the docstring of drag_limits"
RULE = (
    "A step of h seconds multiplies the velocity by 1 - (k1 + k2 |v|) h / m. This must be 0 at the "
    "first limit and -1 at the second."
)


def draw_coefficient(rng: Random) -> float:
    return round(rng.uniform(0.2, 0.9), 3)


def drag_slips(v: Triple, k1: float, k2: float) -> dict[str, Triple | float]:
    """Return what likely mistakes make of a drag that is -v (k1 + k2 |v|)."""
    speed = abs(v)
    size = k1 * speed + k2 * speed**2
    return {
        "Your drag points along the velocity. Add the missing minus sign.": v * (k1 + k2 * speed),
        "You swapped k1 and k2.": -v * (k2 + k1 * speed),
        "You multiply the size of the drag by the velocity v, so the force is |v| times too large. "
        "Multiply it by the unit vector v / |v| instead.": -v * size,
        "Your drag leaves out the term with k2.": -v * k1,
        "Your drag leaves out the term with k1.": -v * k2 * speed,
        "Your drag is -v (k1 + k2), without the factor |v|.": -v * (k1 + k2),
        "The size of your drag is k1 + k2, no matter what the speed |v| is.":
            -v * (k1 + k2) / speed,
        "You multiply the unit vector v / |v| by k1 + k2 |v|, so a factor |v| is missing.":
            -v * (k1 + k2 * speed) / speed,
        "You use the squared length of the velocity as the speed. The speed |v| is its length, "
        "which magnitude() returns.": -v * (k1 * speed + k2 * speed**3),
        "You multiply k2 by |v|^2 and the whole by v, so one factor |v| is too many.":
            -v * (k1 + k2 * speed**2),
        "The minus sign applies only to the term with k1, so the other term points along the "
        "motion. Put both terms in parentheses after the minus sign.": v * (k2 * speed - k1),
        "You multiply both k1 and k2 by |v|^2.": -v * (k1 + k2) * speed,
        "You square k2 as well as the speed.": -v * (k1 + k2 * k2 * speed),
        "You use a different speed for each axis, such as |x| for the x component. Use the same "
        "total speed |v| in all three components.":
            Triple(-part * (k1 + k2 * abs(part)) for part in v),
        "You return the size of the drag, which is a number.": size,
        "You return minus the size of the drag, which is a number.": -size,
    }  # fmt: skip


@pytest.mark.exercise("B5.5", asks="(k1 |v| + k2 |v|^2), as a new vector", read=READ)
def test_the_drag_at_one_velocity(rng: Random) -> None:
    v = vector(rng)
    with calls("The drag must be -v (k1 + k2 |v|), where v is the velocity and |v| its length."):
        velocity = Vector3(*v)
        got = drag_force(velocity, k1=0.5, k2=0.25)
    expect_unchanged(
        "velocity", velocity, v,
        cause="The operations normalize, invert and *= work in place. Use normalized, - and *.",
    )  # fmt: skip
    expect_close(xyz(got), -v * (0.5 + 0.25 * abs(v)), drag_slips(v, 0.5, 0.25), unit="N")
    with calls("Pass the result of drag_force to particle.add_force, and change nothing else."):
        p = Particle(velocity=Vector3(*v))
        Drag(0.5, 0.25).update_force(p, 0.5)
    only = "update_force changed the velocity of the particle. It must only add a force."
    expect_unchanged("p.velocity", p.velocity, v, cause=only)


@pytest.mark.exercise("B5.5", asks="drag acts against the motion", read=READ)
def test_drag_points_against_the_motion(rng: Random) -> None:
    v, one, two = vector(rng), draw_coefficient(rng), draw_coefficient(rng)
    for k1, k2, cause in (
        (one, 0.0, "Here k2 is 0, so the drag must be -k1 v, where v is the velocity."),
        (0.0, two, "Here k1 is 0, so the drag must be -k2 |v| v, where |v| is the speed."),
        (one, two, "The drag must be -v (k1 + k2 |v|), where |v| is the speed."),
    ):  # fmt: skip
        with calls(cause):
            got = drag_force(Vector3(*v), k1=k1, k2=k2)
        expect_close(xyz(got), -v * (k1 + k2 * abs(v)), drag_slips(v, k1, k2), unit="N")


@pytest.mark.exercise("B5.5", asks="-v^ (k1 |v| + k2 |v|^2)", read=READ)
def test_drag_grows_with_the_speed_and_with_its_square() -> None:
    for z, k1, k2, force in (
        (2.0, 3.0, 0.0, -6.0),
        (-2.0, 3.0, 0.0, 6.0),
        (2.0, 0.0, 3.0, -12.0),
        (-4.0, 0.0, 3.0, 48.0),
        (0.5, 4.0, 8.0, -4.0),
    ):
        with calls("Multiply k1 by the speed, and k2 by the square of the speed."):
            got = drag_force(Vector3(0.0, 0.0, z), k1=k1, k2=k2)
        expect_close(xyz(got), (0.0, 0.0, force), unit="N")


@pytest.mark.exercise("B5.5", asks="If the velocity is zero, so is the drag", read=READ)
def test_at_rest_there_is_no_drag(rng: Random) -> None:
    k1, k2 = draw_coefficient(rng), draw_coefficient(rng)
    with calls(
        "At rest, you divide by a velocity of length 0. Return the zero vector.",
        f"v = Vector3(); f = drag_force(v, k1={k1}, k2={k2})",
    ):
        v = Vector3()
        force = drag_force(v, k1, k2)
    expect_close(xyz(force), ZERO, unit="N")
    cause = "You return the vector v itself, so both change. Return a new vector."
    with calls(cause, "f.x = 99.0", more=True):
        force.x = 99.0
    expect_unchanged("v", v, ZERO)
    with calls("You treat a slow particle as if it were at rest. Compute its drag as usual."):
        got = drag_force(Vector3(0, 1e-9, 0), k1=k1, k2=k2)
    expect_close(xyz(got), (0.0, -k1 * 1e-9 - k2 * 1e-18, 0.0), unit="N")


@pytest.mark.exercise("B5.5", asks="to the particle's other forces", read="the docstring of Drag")
def test_the_generator_adds_the_drag_of_its_particle(rng: Random) -> None:
    x, v, f = Triple((1.0, 2.0, 3.0)), vector(rng), vector(rng)
    k1, k2, mass = draw_coefficient(rng), draw_coefficient(rng), round(rng.uniform(2.0, 9.0), 3)
    h = 0.0625  # short enough for a drag that never reverses the motion
    with calls("Compute the drag of p.velocity with drag_force, and add it with add_force."):
        p, drag = Particle(Vector3(*x), Vector3(*v), mass=mass), Drag(k1=k1, k2=k2)
        p.add_force(Vector3(*f))
        drag.update_force(p, h)
        got = p.force_accumulator
    force, swapped = -v * (k1 + k2 * abs(v)), -v * (k2 + k1 * abs(v))
    slips = {
        "Your force points along the velocity. drag_force has the minus sign already, so add its "
        "result unchanged.": f - force,
        "You divide the drag by the mass.": f + force / mass,
        "You multiply the drag by the duration.": f + force * h,
        "You swapped k1 and k2. In the drag, k2 belongs to the square of the speed.": f + swapped,
        "The sum is only the drag. Don't clear the earlier forces.": force,
        "Your update_force added no force to the particle. Pass the result of drag_force to "
        "particle.add_force.": f,
        "You compute the drag from the position of the particle.": f - x * (k1 + k2 * abs(x)),
    }
    # A few roundings of numbers up to 150.
    expect_close(got, f + force, slips, tolerance=1e-12, unit="N")
    with calls("Read self.k1 and self.k2 in every call, because they may change.", more=True):
        p.clear_forces()
        drag.k1, drag.k2 = k2, k1
        drag.update_force(p, h)
        got = p.force_accumulator
    expect_close(got, swapped, tolerance=1e-12, unit="N")


@pytest.mark.exercise("B5.5", asks="the drag, -v^ (k1 |v| + k2 |v|^2)", read=READ)
def test_a_fall_reaches_its_terminal_speed() -> None:
    """Only here the drag balances a weight. The speed then does not depend on the step."""
    with calls(
        "After 60 s, the drag that you add must equal the weight: k1 v + k2 v^2 = m g.",
        "p = Particle(acceleration=Vector3(0, -9.81, 0), mass=2); for 60 s, in steps of h = 1/60 "
        "s: Drag(k1=0.3, k2=0.05).update_force(p, h) and p.integrate(h)",
    ):
        p = Particle(acceleration=Vector3(0.0, -9.81, 0.0), mass=2.0)
        _, velocity = march(p, Drag(0.3, 0.05), 1.0 / 60.0, 3600)
    wanted = (0.0, -17.034969428476803, 0.0)
    # What is left after a minute, e^-60, is far below rounding.
    expect_close(velocity, wanted, then="; p.velocity", unit="m/s", tolerance=1e-10)


@pytest.mark.exercise("B5.5", asks="the drag, -v^ (k1 |v| + k2 |v|^2)", read=READ)
def test_coasting_is_more_accurate_with_shorter_steps() -> None:
    with calls(
        "The speed is not exact. The drag must be -v (k1 + k2 |v|), where |v| is the speed.",
        "p = Particle(velocity=Vector3(20, 0, 0), mass=2); for 2 s: Drag(k1=0.3, "
        "k2=0.05).update_force(p, h) and p.integrate(h)",
    ):
        drag = Drag(0.3, 0.05)
        p, q = (Particle(velocity=Vector3(20.0, 0.0, 0.0), mass=2.0) for _ in range(2))
        states = march(p, drag, 0.01, 200), march(q, drag, 0.005, 400)
    ratio = 0.05 / 0.3
    exact = 1.0 / ((1.0 / 20.0 + ratio) * math.exp(0.3 * 2.0 / 2.0) - ratio)
    long, short = (velocity[0] - exact for _, velocity in states)
    then = "; error of the speed with steps of 1/100 s"
    expect_between(long, -0.03, 0.03, then=then)
    # For a method of order 1, the ratio is 2 plus a term of order h: at most 0.02 with these steps.
    then += ", divided by the error with steps of 1/200 s"
    expect_close(long / short, 2.0, then=then, tolerance=0.05)


@pytest.mark.exercise("B5.5", asks="the motion reverses in every step", read=READ)
def test_linear_drag_in_steps_near_its_limits() -> None:
    limited = "You limit the drag. Remove the limit, because only the Airbrake has one."
    # The rounding of each step, which the factor below enlarges at most 1.02^40 = 2.2 times.
    for share in (0.98, 1.02, 1.98, 2.02):
        h = share * 2.0 / 8.0
        for times, steps in (("once", 1), ("twice", 2), ("40 times", 40)):
            with calls(
                "A step must multiply the velocity by 1 - k1 h / m, even if this is negative.",
                f"p = Particle(velocity=Vector3(3, 0, 0), mass=2); {times}: Drag(k1=8, "
                f"k2=0).update_force(p, {h:g}) and p.integrate({h:g}); p.velocity.x",
            ):
                p = Particle(velocity=Vector3(3.0, 0.0, 0.0), mass=2.0)
                _, velocity = march(p, Drag(8.0, 0.0), h, steps)
            wanted = 3.0 * (1.0 - share) ** steps
            slips = {limited: 0.0} if share > 1.0 else {}
            expect_close(velocity[0], wanted, slips, unit="m/s", tolerance=1e-12)


# B5.8 Time steps that are too long


@pytest.mark.exercise("B5.8", asks="Return the durations in s above which", read=LIMITS)
def test_the_limits_by_their_formula(rng: Random) -> None:
    one, two, mass = positive_number(rng), positive_number(rng), positive_number(rng)
    speed = positive_number(rng, 1.0, 90.0)
    for k1, k2 in ((one, two), (one, 0.0), (0.0, two)):
        with calls(RULE):
            got = drag_limits(k1=k1, k2=k2, mass=mass, speed=speed)
        rate = (k1 + k2 * speed) / mass
        first, second = wanted = 1.0 / rate, 2.0 / rate
        rates = {
            "The mass is missing.": rate * mass,
            "You divide by the mass, but a heavier particle tolerates a longer step.":
                rate * mass**2,
            "You divide only k2 |v| by the mass. Put parentheses around the sum.":
                k1 + k2 * speed / mass,
            "You use the drag itself, k1 |v| + k2 |v|^2. Divide it by the speed |v|.": rate * speed,
            "You multiply k2 by |v|^2, but the drag is divided by |v| here.":
                (k1 + k2 * speed**2) / mass,
            "You use k1 + k2, without the speed.": (k1 + k2) / mass,
            "You multiply both k1 and k2 by the speed |v|.": (k1 + k2) * speed / mass,
            "You use k1 + 2 k2 |v|, the derivative of the drag.": (k1 + 2.0 * k2 * speed) / mass,
        }  # fmt: skip
        slips = {name: (1.0 / wrong, 2.0 / wrong) for name, wrong in rates.items()} | {
            "You return the two limits in the wrong order.": (second, first),
            "Your two limits are equal.": (first, first),
            "You return (k1 + k2 |v|) / m, which is a rate. Its inverse is a time.":
                (rate, 2.0 * rate),
            "Your limits are half the right ones.": (0.5 * first, first),
            "You return only the first limit. Return a tuple of both.": first,
            "Your second limit is the square of the first.": (first, first**2),
        }  # fmt: skip
        cause = named(got, RULE, slips)
        if isinstance(got, (tuple, list)) and math.inf in got:
            cause = f"You return an infinite limit although there is drag. {RULE}"
        expect_close(got, wanted, cause=cause, unit="s")
    with calls("You treat a very small drag as 0. Compute the two limits as usual."):
        got = drag_limits(k1=1e-12, k2=0.0, mass=1.0, speed=1.0)
    expect_close(got, (1e12, 2e12), unit="s")
    with calls("At a speed of 0, only k1 has an effect. The limits must be m / k1 and 2 m / k1."):
        got = drag_limits(k1=one, k2=two, mass=mass, speed=0.0)
    expect_close(got, (mass / one, 2.0 * mass / one), unit="s")


@pytest.mark.exercise("B5.8", asks="Both are math.inf without drag", read=LIMITS)
def test_without_drag_no_step_is_too_long() -> None:
    for k2, speed in ((0.0, 5.0), (0.5, 0.0)):
        with calls("There is no drag, so no step is too long. Return math.inf for both limits."):
            got = drag_limits(k1=0.0, k2=k2, mass=2.0, speed=speed)
        expect_exactly([*got], [math.inf, math.inf])
    with calls("Here (k1 + k2 |v|) / m is 1 per second, so the limits must be 1 s and 2 s."):
        got = drag_limits(k1=1.0, k2=0.5, mass=2.0, speed=2.0)
    expect_close(got, (1.0, 2.0), unit="s")


@pytest.mark.exercise("B5.8", asks="above which a step reverses the motion", read=LIMITS)
def test_steps_slightly_shorter_and_longer_than_the_limits(rng: Random) -> None:
    """Only here real steps show what the limits mean, without the formula for them."""
    k1, mass, speed = positive_number(rng), positive_number(rng), positive_number(rng, 5.0, 90.0)
    k2 = round(positive_number(rng, 0.3, 3.0) * k1 / speed, 6)  # both parts of the drag count
    with calls(RULE):
        first, second = drag_limits(k1=k1, k2=k2, mass=mass, speed=speed)
    for limit, share, wanted, cause in (
        (first, 0.98, "slower",
         "Your first limit is too long. A shorter step must not reverse the motion."),
        (first, 1.02, "reversed and slower",
         "Your first limit is too short. A step that is slightly longer must reverse the motion."),
        (second, 0.98, "reversed and slower",
         "Your second limit is wrong. A shorter step must reverse the motion and slow it down."),
        (second, 1.02, "reversed and faster",
         "Your second limit is too short. A longer step must reverse the motion and speed it up."),
    ):  # fmt: skip
        h = limit * share
        with calls(
            cause,
            f"drag_limits(k1={k1}, k2={k2}, mass={mass}, speed={speed}) = ({first:.6g}, "
            f"{second:.6g}) s; the motion after one step of {h:.6g} s with this drag, compared "
            "with the motion before it",
        ):
            p = Particle(velocity=Vector3(speed, 0.0, 0.0), mass=mass)
            _, velocity = march(p, Drag(k1, k2), h, 1)
        v = velocity[0] / speed
        kind = "reversed and faster" if v < -1.0 else "reversed and slower" if v < 0.0 else "slower"
        expect_exactly(kind if v < 1.0 else "not slower", wanted)
