"""The state of a particle without steps, build task B4.8."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import closed_form, probes
from draw import Components, components, number
from expect import about, blame, expect_close, expect_unchanged, expect_vector, xyz

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
        k = -math.log(damping)
        share = time if damping == 1.0 else (1.0 - damping**time) / k
        fallen = time * time / 2.0 if damping == 1.0 else (time - share) / k
        kept = damping**time
        mistakes = [
            ((0.0, 1.5 + (30.0 - 20.0) * time, 40.0 * time), gone),
            (
                (0.0, 1.5 + 30.0 * share - 10.0 * fallen, 40.0 * share),
                "You take half of fallen. This factor already contains the 1/2, so multiply the "
                "acceleration by fallen alone.",
            ),
            (
                (0.0, 30.0 * kept - 20.0 * share, 40.0 * kept),
                "You return the velocity first. Return the position, and then the velocity.",
            ),
            (
                (0.0, 30.0 * share - 20.0 * fallen, 40.0 * share),
                "You leave out the position at the start. Add it to the path.",
            ),
            (
                (0.0, 1.5 + 30.0 * kept - 20.0 * fallen, 40.0 * kept),
                "To get the position, you multiply the velocity by kept. Multiply it by gone.",
            ),
            (
                (0.0, 1.5 + 30.0 * time - 20.0 * fallen, 40.0 * time),
                "To get the position, you multiply the velocity by the time. Multiply it by gone, "
                "because the drag slows the shell down.",
            ),
        ]
        blame(got, mistakes)
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
    fallen = (
        "To get the velocity, you multiply the acceleration by fallen. Multiply it by gone instead."
    )
    blame(got, [(tuple(v[i] + a[i] * t * t / 2.0 for i in range(3)), fallen)])
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
    full = tuple(v[i] * damping**first + a[i] * first for i in range(3))
    timed = (
        "To get the velocity, you multiply the acceleration by the time. Multiply it by gone, "
        "because the drag also slows down what the acceleration has added."
    )
    blame(xyz(middle[1]), [(gain, undamped), (full, timed)])
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
