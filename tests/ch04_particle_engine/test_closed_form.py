"""The state of a particle without steps, build task B4.8."""

from __future__ import annotations

import itertools
import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import closed_form, probes
from draw import Components, components, number
from expect import about, blame, expect_close, expect_unchanged, expect_vector, xyz

FACTORS = "the docstring of drag_factors"
STATE = "the docstring of state_after"


def particle_of(
    x: Components, v: Components, a: Components, damping: float, mass: float = 1.0
) -> tuple[str, Any]:
    """Return the code that makes a particle, and the particle."""
    words = (
        f"x, v, a = Vector3{x}, Vector3{v}, Vector3{a}; p = Particle(x, v, a, damping={damping})"
    )
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), damping=damping, mass=mass)
    return words, p


def by_series(damping: float, time: float) -> tuple[float, float, float]:
    """Return the factors for a small k t, from the power series of fallen."""
    kt = -math.log(damping) * time
    # For k t up to 0.1, the terms (k t)^n / (n + 2)! after the 12th are below the last digit.
    fallen = time * time * math.fsum((-kt) ** n / math.factorial(n + 2) for n in range(12))
    gone = time + math.log(damping) * fallen
    return damping**time, gone, fallen


@pytest.mark.exercise("B4.8", asks="Compute three factors that give the exact motion")
def test_the_factors_are_those_of_the_equation(rng: Random) -> None:
    about.read = FACTORS
    for damping, time in (
        (0.5, 1.0),
        (round(rng.uniform(0.1, 0.3), 3), round(rng.uniform(5.0, 9.0), 3)),  # too long for a series
        (1.5, round(rng.uniform(1.0, 3.0), 3)),  # the formula also holds for a damping above 1
        (0.9999, 3000.0),  # k t decides whether the drag is small, not k
    ):
        about.call = (
            f"drag_factors(damping={damping}, time={time}), which returns (kept, gone, fallen)"
        )
        k = -math.log(damping)
        gone = -math.expm1(-k * time) / k
        wanted = (math.exp(-k * time), gone, (time - gone) / k)
        about.cause = (
            "One of the three factors is wrong. Call the damping d and the time t. Compute the "
            "drag rate k = -ln d, and then kept = d^t, gone = (1 - d^t) / k and fallen = (t - "
            "gone) / k."
        )
        got = closed_form.drag_factors(damping, time)
        size = max(1.0, *wanted)
        undamped = (
            "You ignore the damping, so these are the factors without drag. Compute the drag rate "
            "from it, which is -ln(damping)."
        )
        if damping == 0.9999:
            undamped = (
                "You treat this damping as 1 because it is close to 1. Over such a long time, the "
                "drag still matters. Use the full formulas unless -ln(damping) x time is small."
            )
        drag = 1.0 - damping
        powers = [(kept, (1.0 - kept) / drag) for kept in (damping**time, math.exp(-drag * time))]
        mistakes = [
            *(
                (
                    (kept, gone, (time - gone) / drag),
                    "You compute the drag rate k as 1 - damping. The equation uses k = "
                    "-ln(damping), which is different unless the damping is near 1.",
                )
                for kept, gone in powers
            ),
            (
                (wanted[0], wanted[1], time * time / 2.0),
                "You compute fallen as t^2 / 2, which is right only without drag. With drag it "
                "is (t - gone) / k, where t is the time and k = -ln(damping).",
            ),
            ((1.0, time, time * time / 2.0), undamped),
        ]
        blame(got, mistakes)
        # Nine digits are required. A solution may choose where its series begins and ends.
        expect_close(got, wanted, tolerance=1e-9 * size)


@pytest.mark.exercise("B4.8", asks="At time 0 they are 1, 0 and 0")
def test_dampings_of_0_and_1_and_a_time_of_0(rng: Random) -> None:
    time = round(rng.uniform(1.0, 9.0), 3)
    about.read = FACTORS
    for damping, t, wanted, cause in (
        (
            1.0,
            time,
            (1.0, time, time * time / 2.0),
            "If the damping is 1, the drag rate is 0, so you cannot divide by it. In this case, "
            "return the factors without drag, which are 1, t and t^2 / 2 after a time t.",
        ),
        (
            0.0,
            time,
            (0.0, 0.0, 0.0),
            "Handle a damping of 0 separately, because 0 has no logarithm. The motion stops at "
            "once, so all three factors are 0.",
        ),
        (
            0.5,
            0.0,
            (1.0, 0.0, 0.0),
            "At time 0 nothing has moved yet. Return the factors 1, 0 and 0.",
        ),
        (
            0.0,
            0.0,
            (1.0, 0.0, 0.0),
            "At time 0 nothing has moved yet, even with a damping of 0. Check the time before the "
            "damping, and return the factors 1, 0 and 0.",
        ),
    ):
        about(
            f"drag_factors(damping={damping}, time={t:.6g}), which returns (kept, gone, fallen)",
            cause=cause,
        )
        got = closed_form.drag_factors(damping, t)
        expect_close(got, wanted)


@pytest.mark.exercise("B4.8", asks="must still have at least 9 correct digits")
@pytest.mark.parametrize("away", [1e-13, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2])
def test_the_factors_hold_for_a_damping_near_1(away: float, rng: Random) -> None:
    about.read = FACTORS
    of_gone, of_fallen = (
        f"Your formula for {name} loses digits if the damping d is near 1, because {difference} "
        f"subtracts nearly equal numbers. Use {instead} instead."
        for name, difference, instead in (
            ("gone", "1 - d^t", "math.expm1"),
            ("fallen", "t - gone", "the first terms of its power series"),
        )
    )
    undamped = (
        "You treat this damping as 1 because it is close to 1. Compute kept as d^t, gone with "
        "math.expm1, and fallen from the first terms of its power series, where d is the damping."
    )
    # The formulas usually lose 1e-8 of short times. Long times show whether drag was ignored.
    for damping, most in itertools.product((1.0 - away, 1.0 + away), (2.0, 2.0, 9.0)):
        t = round(rng.uniform(most - 1.0, most), 3)
        about.call = (
            f"drag_factors(damping=1 {'-' if damping < 1.0 else '+'} {away}, time={t}), which "
            "returns (kept, gone, fallen)"
        )
        got = closed_form.drag_factors(damping, t)
        # A series that is cut early or begins elsewhere may be wrong by up to 1e-9.
        wanted = by_series(damping, t)
        size = wanted[2]
        first_two = got[:2] if isinstance(got, (tuple, list)) else got
        about.cause = of_gone
        blame(first_two, [(wanted[:2], of_fallen)])
        blame(got, [((1.0, t, t * t / 2.0), undamped)])
        expect_close(got, wanted, tolerance=1e-9 * max(1.0, size))


@pytest.mark.exercise("B4.8", asks="limit, and for very short times")
def test_the_factors_hold_for_short_times(rng: Random) -> None:
    about(
        cause="After a very short time, gone and fallen are small but not 0. Check whether your "
        "code rounds a small number, or treats it as 0.",
        read=FACTORS,
    )
    damping = round(rng.uniform(0.3, 0.9), 3)
    for t in (1.0 / 60.0, 1e-6):
        about.call = (
            f"drag_factors(damping={damping}, time={t:.6g}), which returns (kept, gone, fallen)"
        )
        wanted = by_series(damping, t)
        got = closed_form.drag_factors(damping, t)
        # Nine digits are required, of gone and of fallen too.
        expect_close(got, wanted, tolerance=1e-9)
        for words, i, power in (("gone / t", 1, t), ("fallen / t^2", 2, t * t)):
            about.call = f"_, gone, fallen = drag_factors(damping={damping}, time={t:.6g}); {words}"
            expect_close(got[i] / power, wanted[i] / power, tolerance=1e-8)


@pytest.mark.exercise("B4.8", asks="its position is p + v * gone + a * fallen")
def test_an_artillery_shell_lands_at_the_known_place() -> None:
    about.read = STATE
    x, v, a = (0.0, 1.5, 0.0), (0.0, 30.0, 40.0), (0.0, -20.0, 0.0)
    for damping, time, reach in ((1.0, 3.0491933, 121.96773), (0.99, 3.0347583, 119.557788)):
        words, p = particle_of(x, v, a, damping)
        about.call = f"{words}; state_after(p, {time}); the position"
        about.cause = (
            "Your position is not x + v * gone + a * fallen. Compute it with this formula and the "
            "factors that drag_factors returns."
        )
        position, _ = closed_form.state_after(p, time)
        # The times are known to 5e-8 s, and the shell moves at up to 50 m/s.
        got, wanted = expect_vector(position), (0.0, 0.0, reach)
        gone = (
            "To get the position, you multiply the acceleration by gone. Multiply it by fallen "
            "instead."
        )
        blame(got, [((0.0, 1.5 + (30.0 - 20.0) * time, 40.0 * time), gone)])
        if math.dist(got, wanted) < 1.0:
            about.cause = (
                "Your position is close but not exact, perhaps because you use time steps. "
                "Compute x + v * gone + a * fallen instead, with the factors from drag_factors."
            )
        expect_close(got, wanted, unit="m", tolerance=1e-5)


@pytest.mark.exercise("B4.8", asks="Without damping, the factors kept, gone and fallen")
def test_without_damping_it_is_the_parabola(rng: Random) -> None:
    x, v, a, t = components(rng), components(rng), components(rng), round(rng.uniform(2, 9), 3)
    words, p = particle_of(x, v, a, 1.0)
    about(
        f"{words}; state_after(p, {t})",
        cause="With a damping of 1 there is no drag. After a time t, the position must "
        "be x + v t + a t^2 / 2, and the velocity v + a t.",
        read=STATE,
    )
    position, velocity = closed_form.state_after(p, t)
    wanted = tuple(x[i] + v[i] * t + a[i] * t * t / 2.0 for i in range(3))
    # The rounding errors of numbers up to 500.
    got = xyz(position)
    expect_close(got, wanted, then="; the position", unit="m", tolerance=1e-11)
    wanted = tuple(v[i] + a[i] * t for i in range(3))
    got = xyz(velocity)
    expect_close(got, wanted, then="; the velocity", unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("B4.8", asks="Predict the position and velocity of particle")
def test_two_predictions_in_a_row_equal_one_long_prediction(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    damping, first, second = (round(rng.uniform(0.2, 0.8), 3) for _ in range(3))
    words, p = particle_of(x, v, a, damping)
    about.call = (
        f"{words}; middle = state_after(p, {first}); q = Particle(*middle, a, damping={damping}); "
        f"state_after(q, {second})"
    )
    about.cause = (
        "Predicting in two parts must give the same state as a single prediction over the total "
        "time. Check your formulas for position and velocity."
    )
    about.read = STATE
    middle = closed_form.state_after(p, first)
    if xyz(p.position) != x or xyz(p.velocity) != v:
        about.cause = (
            "Your state_after changes the particle p itself. Only read p.position and p.velocity, "
            "and return new vectors."
        )
    undamped = (
        "You don't damp the initial velocity. Multiply it by the factor kept before you add the "
        "acceleration times gone."
    )
    gone = (1.0 - damping**first) / -math.log(damping)
    gain = tuple(v[i] + a[i] * gone for i in range(3))
    blame(xyz(middle[1]), [(gain, undamped)])
    _, q = particle_of(xyz(middle[0]), xyz(middle[1]), a, damping)
    later, at_once = closed_form.state_after(q, second), closed_form.state_after(p, first + second)
    for i in range(2):
        got, wanted = xyz(later[i]), xyz(at_once[i])
        name, unit = (("position", "m"), ("velocity", "m/s"))[i]
        then = f"; the {name}, which must equal the one that "
        then += f"state_after(p, {first + second:.6g}) returns"
        # The factors have nine digits, and the numbers are up to 30.
        expect_close(got, wanted, then=then, unit=unit, tolerance=3e-8)
    about.call = (
        f"{words}; state_after(p, {first}); the velocity, which must equal the slope of the "
        "position"
    )
    about.cause = (
        "Your velocity is not the rate at which your position changes. Check that both formulas "
        "use the same three factors from drag_factors."
    )
    step = 1e-4
    around = [closed_form.state_after(p, first + s)[0] for s in (-step, step)]
    low, high = (xyz(position) for position in around)
    slope = tuple((high[i] - low[i]) / (2.0 * step) for i in range(3))
    # The central difference is off by h^2 / 6 times the third derivative, about 30 m/s^3.
    expect_close(xyz(middle[1]), slope, tolerance=1e-6)


@pytest.mark.exercise("B4.8", asks="the equation of motion is dv/dt = a - k v")
def test_short_steps_of_integrate_come_close_to_the_prediction(rng: Random) -> None:
    x, v, a = components(rng), components(rng), (number(rng), -9.81, number(rng))
    damping, t = round(rng.uniform(0.3, 0.8), 3), 2.0
    words, p = particle_of(x, v, a, damping)
    about.cause = (
        "With shorter time steps, the result of integrate must get closer to your exact state, "
        "but it doesn't. Check that you use the particle's damping and acceleration."
    )
    about(f"{words}; state_after(p, {t})", read=f"{STATE}; chapter 3's integrate")
    exact = [xyz(vector) for vector in closed_form.state_after(p, t)]
    for i, name in enumerate(("position", "velocity")):
        errors = []
        for frames in (2000, 4000):
            stepped = probes.stepped(x, v, a, damping, t / frames, frames)
            errors.append(math.dist(stepped[i], exact[i]))
        about.call = (
            f"{words}; the error of the {name} after {t} s with 2000 steps of integrate, divided "
            "by the error with 4000 steps"
        )
        # Each error is of the order of 10 / 2000, and the next order changes the ratio as little.
        ratio = errors[0] / max(errors[1], 1e-300)
        expect_close(ratio, 2.0, tolerance=0.02)


@pytest.mark.exercise("B4.8", asks="Both results are new vectors")
def test_the_particle_stays_as_it_is(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    words, p = particle_of(x, v, a, 0.5)
    about.call = f"{words}; position, velocity = state_after(p, t); position.x = velocity.x = 99"
    about(
        cause="Your state_after returns one of the particle's own vectors, so a change to the "
        "result also changes the particle. Return new vectors.",
        read=STATE,
    )
    for t in (2.0, 0.0):
        state = closed_form.state_after(p, t)
        state[0].x = state[1].x = 99.0
        expect_unchanged("p.position", xyz(p.position), x, then="; p.position")
        expect_unchanged("p.velocity", xyz(p.velocity), v, then="; p.velocity")
        expect_unchanged("p.acceleration", xyz(p.acceleration), a, then="; p.acceleration")


@pytest.mark.exercise("B4.8", asks="For an immovable particle, return copies")
def test_an_immovable_particle_keeps_its_state(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    words, p = particle_of(x, v, a, 0.5, mass=math.inf)
    about.call = f"{words}; p.mass = math.inf; position, velocity = state_after(p, 3)"
    about(
        cause="This particle has an infinite mass, so its position and velocity never change. "
        "Return copies of both.",
        read=STATE,
    )
    position, velocity = closed_form.state_after(p, 3.0)
    expect_close(xyz(position), x, then="; position", unit="m")
    expect_close(xyz(velocity), v, then="; velocity", unit="m/s")
    position.x = velocity.x = 99.0
    about.call += "; position.x = velocity.x = 99"
    about.cause = (
        "You return one of the particle's own vectors, so a change to the result also changes the "
        "particle. Return copies instead."
    )
    expect_unchanged("p.position", xyz(p.position), x, then="; p.position")
    expect_unchanged("p.velocity", xyz(p.velocity), v, then="; p.velocity")
