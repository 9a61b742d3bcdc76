"""What every step of build tasks B6.6 to B6.8 and B6.12 must do: formula, forces, order."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch06_springs.step_probes import Body, stepped
from draw import Triple, positive_number, vector
from expect import expect_close, expect_exactly, named
from one_step import one_step, wrong_steps

ZERO = Triple((0.0, 0.0, 0.0))
EXERCISES = {
    "explicit_euler": "B6.6",
    "semi_implicit_euler": "B6.6",
    "leapfrog": "B6.12",
    "velocity_verlet": "B6.7",
    "runge_kutta_4": "B6.8",
}
RULES = {
    "explicit_euler":
        "The step is p' = p + v h and v' = (v + a h) d^h. Use the old velocity v and the "
        "acceleration a at the start in both.",
    "semi_implicit_euler":
        "The step is v' = (v + a h) d^h and p' = p + v' h. Compute v' first, and use it for p'.",
    "leapfrog":
        "The step is p1 = p + v h / 2, v' = (v + a h) d^h and p' = p1 + v' h / 2, where a is the "
        "acceleration at p1.",
    "velocity_verlet":
        "Move the particle first, p' = p + v h + a h^2 / 2. Then evaluate the acceleration b at p' "
        "with the velocity v + a h, and set v' = (v + (a + b) h / 2) d^h.",
    "runge_kutta_4":
        "The new state follows from the weighted mean of the four rates. Give the second and the "
        "third rate twice the weight of the others.",
}  # fmt: skip
COUNTS = {1: "exactly once", 2: "exactly twice", 4: "exactly 4 times"}
EVALUATIONS = dict.fromkeys(EXERCISES, 1) | {"velocity_verlet": 2, "runge_kutta_4": 4}


def methods(asks: str, read: str = "the docstring of {}") -> pytest.MarkDecorator:
    """Run a check for each integrator, as a check of its exercise."""
    marks = {
        name: pytest.mark.exercise(id_, asks=asks, read=read.format(name))
        for name, id_ in EXERCISES.items()
    }
    return pytest.mark.parametrize("method", [pytest.param(n, marks=marks[n]) for n in marks])


def moved(method: str, body: Body, k: float, c: float, h: float) -> tuple[Triple, Triple, Triple]:
    """Return a body's position and velocity after a step, and its mean acceleration."""
    p, v, a, mass, d, hand = body
    axes = [
        one_step(method, x, u, b + f / mass, k / mass, c / mass, d, h)
        for x, u, b, f in zip(p, v, a, hand, strict=True)
    ]
    position, velocity, mean = map(Triple, zip(*axes, strict=True))
    return position, velocity, mean


def walk(method: str, body: Body, k: float, c: float, h: float, frames: int) -> list[float]:
    """Return the position of a body after some steps, followed by its velocity."""
    for _ in range(frames):
        body = (*moved(method, body, k, c, h)[:2], *body[2:])
    return [*body[0], *body[1]]


def slips_of(
    method: str, body: Body, k: float, c: float, h: float, frames: int, asked: int
) -> dict[str, list[float]]:
    """Return what walk would return after each likely mistake, keyed by its explanation."""
    p, v, a, mass, d, hand = body
    bodies: dict[str, Body] = {
        "You leave out p.acceleration, the constant acceleration. Add it to f / m, the "
        "acceleration that the forces cause.": (p, v, ZERO, mass, d, hand),
        "Your step leaves out the force that was added to p before the step. This force acts "
        "during the whole step, so include it in every evaluation.": (p, v, a, mass, d, ZERO),
        "You don't divide the forces by the mass. The acceleration is p.acceleration + f / m, "
        "where f is the sum of the forces.": (p, v, a, 1.0, d, hand),
        "Your velocity is never damped. Multiply it by d^h once per step, where d is the "
        "damping and h the duration.": (p, v, a, mass, 1.0, hand),
        "You multiply the velocity by d, the damping for a whole second. The step lasts only h "
        "seconds, so multiply by d^h instead.": (p, v, a, mass, d ** (1.0 / h), hand),
    }
    slips = {slip: walk(method, wrong, k, c, h, frames) for slip, wrong in bodies.items()}
    slips[
        "The forces that apply_forces adds have no effect on your step. Call apply_forces before "
        "you update the velocity, and don't clear the accumulators in between."
        if asked
        else "You never call apply_forces. Call it in every step, before you use the accumulators."
    ] = walk(method, body, 0.0, 0.0, h, frames)
    if frames == 1:
        axes = [
            wrong_steps(method, x, u, b + f / mass, k / mass, c / mass, d, h, b)
            for x, u, b, f in zip(p, v, a, hand, strict=True)
        ]
        slips |= {s: [axis[s][i] for i in (0, 1) for axis in axes] for s in axes[0]}
    return slips | {
        f"Your step matches that of {other}. {RULES[method]}": walk(other, body, k, c, h, frames)
        for other in EXERCISES
        if other != method
    }


def draw_body(rng: Random, hand: Triple = ZERO) -> Body:
    damping = round(rng.uniform(0.3, 0.95), 3)
    return vector(rng), vector(rng), vector(rng), positive_number(rng), damping, hand


def in_words(method: str, body: Body, k: float, c: float, h: float) -> str:
    """Describe a body, the forces on it, and a step."""
    p, v, a, mass, d, hand = body
    text = f"p is at {p} m and moves at {v} m/s; its acceleration is {a} m/s^2, its mass {mass} kg "
    text += f"and its damping d = {d}; "
    if any(hand):
        text += f"before the step, the check adds a force of {hand} N to p; "
    text += f"apply_forces adds the force -{k} x - {c} v, where x is p's position and v its "
    return f"{text}velocity; {method}([p], apply_forces, duration={h})"


@methods(asks="In the formulas, p is a position, v a velocity")
def test_a_step_follows_its_formula(method: str, rng: Random) -> None:
    k, c, h = positive_number(rng), positive_number(rng, 0.2, 2.0), positive_number(rng, 0.1, 0.4)
    for body, frames, cause in (
        (draw_body(rng), 1, RULES[method]),
        (draw_body(rng, vector(rng)), 1,
         "Your step is wrong if a force was added to p before the step. This force acts during the "
         "whole step, so include it in every evaluation of the forces."),
        (draw_body(rng), 3,
         "Your first step is right, but its forces are still in the accumulators in the next step. "
         "Clear the accumulators at the end of each step."),
        ((*draw_body(rng)[:4], 0.0, ZERO), 1,
         "With a damping d of 0 the factor d^h is 0, so the velocity must be 0 at the end of the "
         "step."),
    ):  # fmt: skip
        times = "once" if frames == 1 else "three times"
        with calls(cause, f"{in_words(method, body, k, c, h)} {times}"):
            ends = stepped(method, [body], (k, c), h, frames)
        (p,), (v,) = ends["positions"], ends["velocities"]
        states = walk(method, body, k, c, h, frames)
        slips = slips_of(method, body, k, c, h, frames, len(ends["asked"]))
        whole = named((*p, *v), cause, slips)
        expect_exactly(ends["dampings"], [body[4]], then="; p.damping")
        for name, unit, got, part in (
            ("p.position", "m", p, slice(3)),
            ("p.velocity", "m/s", v, slice(3, 6)),
        ):
            parts = {
                slip.replace("Your step matches", f"Your {name} matches"): numbers[part]
                for slip, numbers in slips.items()
            }
            why = named(got, cause, parts) if whole == cause else whole
            # A few roundings of numbers up to 10^4.
            expect_close(got, states[part], then=f"; {name}", unit=unit, cause=why, tolerance=1e-10)


@methods(
    asks="so move all particles before you call it again",
    read="the docstring of {}, and that of the module",
)
def test_all_particles_move_before_forces_are_asked_again(method: str, rng: Random) -> None:
    s, h, mass = positive_number(rng), positive_number(rng, 0.1, 0.3), positive_number(rng)
    p, q, v, w = vector(rng), vector(rng), vector(rng), vector(rng)
    cause = "You finish the step of one particle before you move the other. The force depends on "
    cause += "both positions, so move all particles before you evaluate the forces again."
    with calls(
        cause,
        f"two particles of {mass} kg are joined by a spring of {s} N/m; {method}(particles, "
        f"apply_forces, duration={h}) once",
    ):
        bodies: list[Body] = [(p, v, ZERO, mass, 1.0, ZERO), (q, w, ZERO, mass, 1.0, ZERO)]
        ends = stepped(method, bodies, (0.0, 0.0, 0.0, s), h, 1)
    (one, two), (fast, last) = (map(Triple, ends[of]) for of in ("positions", "velocities"))
    if (two, last) == (q, w):
        cause = "Your step leaves the second particle as it was. Move all particles. If you use "
        cause += "return, put it after the loop, because it ends the loop."
    position, velocity, _ = moved(method, (p - q, v - w, ZERO, mass, 1.0, ZERO), 2.0 * s, 0.0, h)
    then = "; the {} of the first particle relative to the second"
    for got, wanted, what, unit in (
        (one - two, position, then.format("position"), "m"),
        (fast - last, velocity, then.format("velocity"), "m/s"),
        (0.5 * (one + two), 0.5 * (p + q + (v + w) * h), "; the midpoint of the particles", "m"),
    ):
        expect_close(got, wanted, then=what, unit=unit, cause=cause, tolerance=1e-11)


@methods(
    asks="the accumulators must contain exactly the forces",
    read="the docstring of {}, and that of the module",
)
def test_how_often_a_step_asks_for_forces(method: str, rng: Random) -> None:
    h, hand, frames = positive_number(rng, 0.05, 0.2), vector(rng), rng.randint(2, 5)
    with calls(
        RULES[method],
        f"{method}(particles, apply_forces, duration={h}) {frames} times; before each step, the "
        f"check adds a force of {hand} N to particles[0]",
    ):
        bodies = [draw_body(rng, hand), draw_body(rng)]
        asked = stepped(method, bodies, (1.0, 0.1), h, frames)["asked"]
    expect_exactly(
        len(asked),
        frames * EVALUATIONS[method],
        then="; the number of calls to apply_forces",
        cause=f"On average, your step calls apply_forces {len(asked) / frames:.3g} times, but it "
        f"must do so {COUNTS[EVALUATIONS[method]]}. Each call evaluates the forces of all "
        "particles.",
    )
    got, then = [d for d, _, _ in asked], "; the duration that apply_forces gets in each call"
    cause = "You call apply_forces with only part of the duration. Pass that of the whole step."
    expect_close(got, [h] * len(asked), then=then, unit="s", cause=cause)
    kept = "The forces of an earlier evaluation are still in the accumulators. Clear them before "
    kept += "each evaluation, and add only the forces from before the step."
    gone = "The force that was added to particles[0] before the step is lost. Store it, and add it "
    gone += "again before each evaluation."
    for number, (_, sums, _) in enumerate(asked, 1):
        for i, wanted in enumerate((hand, ZERO)):
            then = f"; particles[{i}].force_accumulator at call {number} of apply_forces"
            why = gone if i == 0 and sums[i] == ZERO else kept
            expect_close(sums[i], wanted, then=then, unit="N", cause=why, tolerance=1e-12)


@methods(asks="which then belong to the wrong positions")
def test_where_a_step_asks_for_forces(method: str, rng: Random) -> None:
    k, h, body = positive_number(rng), positive_number(rng, 0.1, 0.4), draw_body(rng)
    start, v, a, mass, _, _ = body
    p = Triple(start)
    cause = "You call apply_forces at the wrong time. Call it "
    cause += "after the first half drift." if method == "leapfrog" else "before you move p."
    if EVALUATIONS[method] == 2:
        cause = RULES[method]
    elif EVALUATIONS[method] == 4:
        cause = "At least one of your four rates belongs to the wrong state. For each rate, go "
        cause += "back to the start and move at the previous rate: 0, h / 2, h / 2 and h."
    with calls(cause, in_words(method, body, k, 0.0, h)):
        asked = stepped(method, [body], (k, 0.0), h, 1)["asked"]
    middle = p + 0.5 * h * Triple(v)
    first, second = a - k / mass * p, a - k / mass * middle
    wanted = {
        "leapfrog": [middle],
        "velocity_verlet": [p, p + h * Triple(v) + 0.5 * h * h * first],
        "runge_kutta_4": [
            p, middle, middle + 0.25 * h * h * first, p + h * (v + 0.5 * h * second)
        ],
    }.get(method, [p])  # fmt: skip
    expect_close(
        [part for _, _, places in asked for part in places[0]],
        [part for place in wanted for part in place],
        then="; the position of the particle at each call of apply_forces, in m",
        tolerance=1e-11,
    )


@methods(
    asks="Particle.last_acceleration is the mean acceleration",
    read="the docstring of the module, and Particle.last_acceleration",
)
def test_what_a_step_leaves_behind(method: str, rng: Random) -> None:
    k, c, h = positive_number(rng), positive_number(rng, 0.2, 2.0), positive_number(rng, 0.1, 0.4)
    body = draw_body(rng, vector(rng))
    with calls(
        "Clear the accumulators at the end of the step, or their forces act again.",
        in_words(method, body, k, c, h),
    ):
        ends = stepped(method, [body], (k, c), h, 1)
    expect_close(ends["forces"][0], ZERO, then="; p.force_accumulator", unit="N")
    cause = (
        "last_acceleration must be the mean acceleration of the step. Add the mean force to the "
    )
    cause += "particle and call kick, which changes the velocity and sets this attribute."
    got, wanted = ends["accelerations"][0], moved(method, body, k, c, h)[2]
    then = "; p.last_acceleration"
    expect_close(got, wanted, then=then, unit="m/s^2", cause=cause, tolerance=1e-9)


@methods(
    asks="particles do not move, and keep their velocities", read="the docstring of the module"
)
def test_an_immovable_particle_stays(method: str, rng: Random) -> None:
    place, velocity = vector(rng), vector(rng)
    still: Body = (place, velocity, vector(rng), math.inf, 0.5, vector(rng))
    other: Body = (Triple((1.0, 2.0, 3.0)), ZERO, ZERO, 2.0, 1.0, ZERO)
    with calls(
        "You move an immovable particle. Skip it, or use drift and kick, which do nothing to it.",
        f"particles[0] is immovable, at {place} m, with a velocity of {velocity} m/s; particles[1] "
        f"has a mass of 2 kg; {method}(particles, apply_forces, duration=0.25) twice",
    ):
        ends = stepped(method, [still, other], (3.0, 0.5), 0.25, 2)
    then = "; particles[0].{}"
    got, moves = ends["positions"][0], then.format("position")
    expect_close(got, place, then=moves, unit="m", tolerance=0.0)
    cause = "You change the velocity of an immovable particle, which must stay the same."
    got, turns = ends["velocities"][0], then.format("velocity")
    expect_close(got, velocity, then=turns, unit="m/s", cause=cause, tolerance=0.0)
    cause = "Its forces must not add up from step to step. Clear them at the end of the step."
    pulls = then.format("force_accumulator")
    expect_close(ends["forces"][0], ZERO, then=pulls, unit="N", cause=cause)
    cause = "Your loop probably ends at the immovable particle. Skip only that one."
    wanted = walk(method, other, 3.0, 0.5, 0.25, 2)[:3]
    got, then = ends["positions"][1], "; particles[1].position"
    expect_close(got, wanted, then=then, unit="m", cause=cause, tolerance=1e-12)
