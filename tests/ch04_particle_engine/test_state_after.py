"""The state of a particle without steps, build task B4.8."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import probes
from ch04_particle_engine.closed_form import state_after
from draw import Components, Triple, number, vector
from expect import about, expect_close, expect_unchanged, expect_vector, named, xyz

STATE = "the docstring of state_after"
OWN = "The result shares a vector with the particle, so both change. Return new vectors."


def made(x: Components, v: Components, a: Components, damping: float) -> tuple[str, Any]:
    """Return the code that makes a particle, and the particle."""
    words = (
        f"x, v, a = Vector3{x}, Vector3{v}, Vector3{a}; p = Particle(x, v, a, damping={damping})"
    )
    return words, Particle(Vector3(*x), Vector3(*v), Vector3(*a), damping=damping)


@pytest.mark.exercise("B4.8", asks="its position is p + v * gone + a * fallen", read=STATE)
def test_an_artillery_shell_lands_at_the_known_place() -> None:
    x, v, a = Triple((0.0, 1.5, 0.0)), Triple((0.0, 30.0, 40.0)), Triple((0.0, -20.0, 0.0))
    for damping, time, reach in ((1.0, 3.0491933, 121.96773), (0.99, 3.0347583, 119.557788)):
        words, p = made(x, v, a, damping)
        cause = "Compute x + v * gone + a * fallen with the factors that drag_factors returns."
        with calls(cause, f"{words}; state_after(p, {time}); the position"):
            position, _ = state_after(p, time)
            # The times are known to 5e-8 s, and the shell moves at up to 50 m/s.
            got, wanted = expect_vector(position), Triple((0.0, 0.0, reach))
        k, kept = -math.log(damping), damping**time
        gone = time if damping == 1.0 else (1.0 - kept) / k
        fallen = time * time / 2.0 if damping == 1.0 else (time - gone) / k
        if abs(wanted - got) < 1.0:
            cause = "Your position is close but not exact. Use the factors, not time steps."
        multiply = "To get the position, you multiply the"
        slips = {
            f"{multiply} acceleration by gone. Multiply it by fallen instead.": x + gone * (v + a),
            "You take half of fallen. This factor already contains the 1/2, so multiply the "
            "acceleration by fallen alone.": x + gone * v + fallen / 2.0 * a,
            "You return the velocity first. Return the position, and then the velocity.":
                kept * v + gone * a,
            "You leave out the position at the start. Add it to the path.": gone * v + fallen * a,
            f"{multiply} velocity by kept. Multiply it by gone.": x + kept * v + fallen * a,
            f"{multiply} velocity by the time. Multiply it by gone, because the drag slows the "
            "shell down.": x + time * v + fallen * a,
        }  # fmt: skip
        expect_close(got, wanted, slips, unit="m", tolerance=1e-5, cause=cause)


@pytest.mark.exercise("B4.8", asks="Without damping, the factors kept, gone and fallen", read=STATE)
def test_without_damping_it_is_the_parabola(rng: Random) -> None:
    x, v, a, t = vector(rng), vector(rng), vector(rng), round(rng.uniform(2, 9), 3)
    words, p = made(x, v, a, 1.0)
    with calls(
        "With a damping of 1 there is no drag. After a time t, the position must be x + v t + a "
        "t^2 / 2, and the velocity v + a t.",
        f"{words}; state_after(p, {t})",
    ):
        position, velocity = state_after(p, t)
    # The rounding errors of numbers up to 500.
    wanted = x + t * v + t * t / 2.0 * a
    expect_close(xyz(position), wanted, then="; the position", unit="m", tolerance=1e-11)
    slips = {
        "To get the velocity, you multiply the acceleration by fallen. Multiply it by gone "
        "instead.": v + t * t / 2.0 * a
    }
    then = "; the velocity"
    expect_close(xyz(velocity), v + t * a, slips, then=then, unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("B4.8", asks="Predict the position and velocity of particle", read=STATE)
def test_two_predictions_in_a_row_equal_one_long_prediction(rng: Random) -> None:
    x, v, a = vector(rng), vector(rng), vector(rng)
    damping, first, second = (round(rng.uniform(0.2, 0.8), 3) for _ in range(3))
    words, p = made(x, v, a, damping)
    cause = "Two predictions in a row must equal one over the total time. Check your formulas."
    with calls(
        cause,
        f"{words}; middle = state_after(p, {first}); q = Particle(*middle, a, damping={damping}); "
        f"state_after(q, {second})",
    ):
        middle = [xyz(part) for part in state_after(p, first)]
        if xyz(p.position) != x or xyz(p.velocity) != v:
            cause = "Your state_after changes the particle p itself. Return new vectors."
        _, q = made(middle[0], middle[1], a, damping)
        later, at_once = state_after(q, second), state_after(p, first + second)
    slips = {
        "You don't damp the initial velocity. Multiply it by the factor kept before you add the "
        "acceleration times gone.": v + (1.0 - damping**first) / -math.log(damping) * a,
        "To get the velocity, you multiply the acceleration by the time. Multiply it by gone, "
        "because the drag also slows down what the acceleration has added.":
            damping**first * v + first * a,
    }  # fmt: skip
    cause = named(middle[1], cause, slips)
    for i, (name, unit) in enumerate((("position", "m"), ("velocity", "m/s"))):
        then = f"; the {name}, which must equal that of state_after(p, {first + second:.6g})"
        # The factors have nine digits, and the numbers are up to 30.
        wanted = xyz(at_once[i])
        expect_close(xyz(later[i]), wanted, then=then, unit=unit, tolerance=3e-8, cause=cause)
    step = 1e-4
    with calls(
        "Your velocity is not the rate at which your position changes. Check that both formulas "
        "use the same three factors from drag_factors.",
        f"{words}; state_after(p, {first}); the velocity, which must equal the slope of the "
        "position",
    ):
        low, high = (Triple(xyz(state_after(p, first + s)[0])) for s in (-step, step))
    # The central difference is off by h^2 / 6 times the third derivative, about 30 m/s^3.
    expect_close(middle[1], (high - low) / (2.0 * step), tolerance=1e-6)


@pytest.mark.exercise(
    "B4.8", asks="the equation of motion is dv/dt = a - k v", read=f"{STATE}; chapter 3's integrate"
)
def test_short_steps_of_integrate_come_close_to_the_prediction(rng: Random) -> None:
    x, v, a = vector(rng), vector(rng), (number(rng), -9.81, number(rng))
    damping, t = round(rng.uniform(0.3, 0.8), 3), 2.0
    words, p = made(x, v, a, damping)
    with calls(
        "With shorter time steps, the result of integrate must get closer to your exact state, but "
        "it doesn't. Check that you use the particle's damping and acceleration.",
        f"{words}; state_after(p, {t})",
    ):
        exact = [xyz(part) for part in state_after(p, t)]
        coarse, fine = (probes.stepped(x, v, a, damping, t / n, n) for n in (2000, 4000))
    for i, name in enumerate(("position", "velocity")):
        about(
            f"{words}; the error of the {name} after {t} s with 2000 steps of integrate, divided "
            "by the error with 4000 steps"
        )
        # Each error is of the order of 10 / 2000, and the next order changes the ratio as little.
        ratio = math.dist(coarse[i], exact[i]) / max(math.dist(fine[i], exact[i]), 1e-300)
        expect_close(ratio, 2.0, tolerance=0.02)


@pytest.mark.exercise("B4.8", asks="Both results are new vectors", read=STATE)
def test_the_particle_stays_as_it_is(rng: Random) -> None:
    x, v, a = vector(rng), vector(rng), vector(rng)
    words, p = made(x, v, a, 0.5)
    for t in (2.0, 0.0):
        with calls(
            OWN, f"{words}; position, velocity = state_after(p, {t}); position.x = velocity.x = 99"
        ):
            position, velocity = state_after(p, t)
            position.x = velocity.x = 99.0
        for name, now, before in (
            ("p.position", p.position, x),
            ("p.velocity", p.velocity, v),
            ("p.acceleration", p.acceleration, a),
        ):
            expect_unchanged(name, now, before, then=f"; {name}")


@pytest.mark.exercise("B4.8", asks="For an immovable particle, return copies", read=STATE)
def test_an_immovable_particle_keeps_its_state(rng: Random) -> None:
    x, v, a = vector(rng), vector(rng), vector(rng)
    words, p = made(x, v, a, 0.5)
    with calls(
        "This particle has an infinite mass, so its position and velocity never change. Return "
        "copies of both.",
        f"{words}; p.mass = math.inf; position, velocity = state_after(p, 3)",
    ):
        p.mass = math.inf
        position, velocity = state_after(p, 3.0)
    expect_close(xyz(position), x, then="; position", unit="m")
    expect_close(xyz(velocity), v, then="; velocity", unit="m/s")
    with calls(OWN, "position.x = velocity.x = 99", more=True):
        position.x = velocity.x = 99.0
    expect_unchanged("p.position", p.position, x, then="; p.position")
    expect_unchanged("p.velocity", p.velocity, v, then="; p.velocity")
