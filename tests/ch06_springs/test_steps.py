"""What every step of build tasks B6.6 to B6.8 must do: formula, forces, order."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch06_springs.step_probes import Body, stepped
from draw import Components, components, positive_number
from expect import about, expect_close, expect_exactly, named
from one_step import one_step, wrong_steps

ZERO = (0.0, 0.0, 0.0)
EXERCISES = {
    "explicit_euler": "B6.6",
    "semi_implicit_euler": "B6.6",
    "leapfrog": "B6.12",
    "velocity_verlet": "B6.7",
    "runge_kutta_4": "B6.8",
}
RULES = {
    "explicit_euler": (
        "Your result differs from p' = p + v h and v' = (v + a h) d^h. Use the old velocity v and "
        "the acceleration a at the start in both."
    ),
    "semi_implicit_euler": (
        "Your result differs from v' = (v + a h) d^h and p' = p + v' h. Compute v' first, and use "
        "it for p'."
    ),
    "leapfrog": (
        "Your result differs from p1 = p + v h / 2, v' = (v + a h) d^h and p' = p1 + v' h / 2, "
        "where a is the acceleration at p1."
    ),
    "velocity_verlet": (
        "Move the particle first, p' = p + v h + a h^2 / 2. Then evaluate the acceleration b "
        "at p' with the velocity v + a h, and set v' = (v + (a + b) h / 2) d^h."
    ),
    "runge_kutta_4": (
        "Your new state does not follow from the weighted mean of the four rates. Give the "
        "second and the third rate twice the weight of the others."
    ),
}
WAYS = {
    "explicit_euler": "moves p with its old velocity",
    "semi_implicit_euler": "moves p with its new velocity",
    "leapfrog": "drifts for half the step, kicks for all of it, and drifts for the other half",
    "velocity_verlet": "moves p by v h + a h^2 / 2 and uses the mean of two accelerations",
    "runge_kutta_4": "uses the weighted mean of four rates",
}
INSTEAD = {
    "explicit_euler": "move p with its old velocity",
    "semi_implicit_euler": "move p with its new velocity",
    "leapfrog": "drift for half the step, kick for all of it, and drift for the other half",
    "velocity_verlet": "move p by v h + a h^2 / 2 and use the mean of two accelerations",
    "runge_kutta_4": "use the weighted mean of four rates",
}
COUNTS = {1: "exactly once", 2: "exactly twice", 4: "exactly 4 times"}
EVALUATIONS = dict.fromkeys(EXERCISES, 1) | {"velocity_verlet": 2, "runge_kutta_4": 4}


def methods(*, asks: str) -> pytest.MarkDecorator:
    """Run a check for each integrator, as a check of its exercise."""
    marks = {id_: pytest.mark.exercise(id_, asks=asks) for id_ in EXERCISES.values()}
    return pytest.mark.parametrize(
        "method", [pytest.param(name, marks=marks[id_]) for name, id_ in EXERCISES.items()]
    )


def walk(method: str, body: Body, k: float, c: float, h: float, frames: int) -> list[float]:
    """Return the position of a body after some steps, followed by its velocity."""
    p, v, a, mass, d, hand = body
    states = []
    for i in range(3):
        x, u = p[i], v[i]
        for _ in range(frames):
            x, u, _ = one_step(method, x, u, a[i] + hand[i] / mass, k / mass, c / mass, d, h)
        states.append((x, u))
    return [x for x, _ in states] + [u for _, u in states]


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
            wrong_steps(method, p[i], v[i], a[i] + hand[i] / mass, k / mass, c / mass, d, h, a[i])
            for i in range(3)
        ]
        slips |= {s: [axis[s][0] for axis in axes] + [axis[s][1] for axis in axes] for s in axes[0]}
    slips |= {
        f"Your step matches that of {other}, which {WAYS[other]}. Instead, "
        f"{INSTEAD[method]}.": walk(other, body, k, c, h, frames)
        for other in EXERCISES
        if other != method
    }
    return slips


def draw_body(rng: Random, hand: Components = ZERO) -> Body:
    damping = round(rng.uniform(0.3, 0.95), 3)
    place, velocity, acceleration = components(rng), components(rng), components(rng)
    return place, velocity, acceleration, positive_number(rng), damping, hand


@methods(asks="In the formulas, p is a position, v a velocity")
def test_a_step_follows_its_formula(method: str, rng: Random) -> None:
    about.read = f"the docstring of {method}"
    k, c, h = positive_number(rng), positive_number(rng, 0.2, 2.0), positive_number(rng, 0.1, 0.4)
    by_hand = "Your step is wrong if a force was added to p before the step. This force acts "
    by_hand += "during the whole step, so include it in every evaluation of the forces."
    for what, body, frames, cause in (
        ("once", draw_body(rng), 1, RULES[method]),
        ("once", draw_body(rng, components(rng)), 1, by_hand),
        (
            "three times",
            draw_body(rng),
            3,
            "Your first step is right, but its forces are still in the accumulators in the next "
            "step. Clear the accumulators at the end of each step.",
        ),
        (
            "once",
            (*draw_body(rng)[:4], 0.0, ZERO),
            1,
            "With a damping d of 0 the factor d^h is 0, so the velocity must be 0 at the end "
            "of the step.",
        ),
    ):
        about.cause = cause
        p, v, a, mass, d, hand = body
        about.call = f"p is at {p} m and moves at {v} m/s; its acceleration is {a} m/s^2, its mass "
        about.call += f"{mass} kg and its damping d = {d}; "
        if any(hand):
            about.call += f"before the step, the check adds a force of {hand} N to p; "
        about.call += f"apply_forces adds the force -{k} x - {c} v, where x is p's position and v "
        about.call += f"its velocity; {method}([p], apply_forces, duration={h}) {what}"
        ends = stepped(method, [body], (k, c), h, frames)
        states = walk(method, body, k, c, h, frames)
        slips = slips_of(method, body, k, c, h, frames, len(ends["asked"]))
        slip = named((*ends["positions"][0], *ends["velocities"][0]), about.cause, slips)
        expect_exactly(ends["dampings"], [d], then="; p.damping")
        # A few roundings of numbers up to 10^4.
        for name, unit, got, numbers in (
            ("p.position", "m", ends["positions"][0], slice(3)),
            ("p.velocity", "m/s", ends["velocities"][0], slice(3, 6)),
        ):
            parts = {
                one.replace("Your step matches", f"Your {name} matches"): slips[one][numbers]
                for one in slips
            }
            why = named(got, about.cause, parts) if slip == about.cause else slip
            wanted = states[numbers]
            expect_close(got, wanted, then=f"; {name}, in {unit}", cause=why, tolerance=1e-10)


@methods(asks="so move all particles before you call it again")
def test_all_particles_move_before_forces_are_asked_again(method: str, rng: Random) -> None:
    about.read = f"the docstring of {method}, and that of the module"
    s, h, mass = positive_number(rng), positive_number(rng, 0.1, 0.3), positive_number(rng)
    one, two = components(rng), components(rng)
    v, w = components(rng), components(rng)
    bodies: list[Body] = [(one, v, ZERO, mass, 1.0, ZERO), (two, w, ZERO, mass, 1.0, ZERO)]
    about.call = f"two particles of {mass} kg are joined by a spring of {s} N/m; {method}(particles"
    about.call += f", apply_forces, duration={h}) once"
    about.cause = (
        "You finish the step of one particle before you move the other. The force depends on "
    )
    about.cause += "both positions, so move all particles before you evaluate the forces again."
    ends = stepped(method, bodies, (0.0, 0.0, 0.0, s), h, 1)
    if tuple(ends["positions"][1]) == two and tuple(ends["velocities"][1]) == w:
        about.cause = "Your step leaves the second particle as it was. Move all particles. If you "
        about.cause += "use return, put it after the loop, because it ends the loop."
    states = [
        one_step(method, one[i] - two[i], v[i] - w[i], 0.0, 2.0 * s / mass, 0.0, 1.0, h)
        for i in range(3)
    ]
    got = tuple(ends["positions"][0][i] - ends["positions"][1][i] for i in range(3))
    wanted = tuple(state[0] for state in states)
    expect_close(
        got,
        wanted,
        then="; the position of the first particle relative to the second, in m",
        tolerance=1e-11,
    )
    got = tuple(ends["velocities"][0][i] - ends["velocities"][1][i] for i in range(3))
    wanted = tuple(state[1] for state in states)
    expect_close(
        got,
        wanted,
        then="; the velocity of the first particle relative to the second, in m/s",
        tolerance=1e-11,
    )
    got = tuple(0.5 * (ends["positions"][0][i] + ends["positions"][1][i]) for i in range(3))
    wanted = tuple(0.5 * (one[i] + two[i] + (v[i] + w[i]) * h) for i in range(3))
    expect_close(got, wanted, then="; the midpoint of the particles, in m", tolerance=1e-11)


@methods(asks="the accumulators must contain exactly the forces")
def test_how_often_a_step_asks_for_forces(method: str, rng: Random) -> None:
    about.read = f"the docstring of {method}, and that of the module"
    h, hand = positive_number(rng, 0.05, 0.2), components(rng)
    frames = rng.randint(2, 5)
    bodies = [draw_body(rng, hand), draw_body(rng)]
    about.call = f"{method}(particles, apply_forces, duration={h}) {frames} times; before each "
    about.call += f"step, the check adds a force of {hand} N to particles[0]"
    about.cause = RULES[method]
    asked = stepped(method, bodies, (1.0, 0.1), h, frames)["asked"]
    about.cause = f"On average, your step calls apply_forces {len(asked) / frames:.3g} times, but "
    about.cause += f"it must do so {COUNTS[EVALUATIONS[method]]}. Each call evaluates the forces "
    about.cause += "of all particles."
    expect_exactly(
        len(asked), frames * EVALUATIONS[method], then="; the number of calls to apply_forces"
    )
    about.cause = "You call apply_forces with only part of the duration. Pass the duration of the "
    about.cause += "whole step in every call."
    expect_close(
        [d for d, _, _ in asked],
        [h] * len(asked),
        then="; the duration that apply_forces gets in each call, in s",
    )
    about.cause = "The forces of an earlier evaluation are still in the accumulators. Clear them "
    about.cause += "before each evaluation, and add only the forces from before the step."
    gone = "The force that was added to particles[0] before the step is lost. Store it, and add "
    gone += "it again before each evaluation."
    for number, (_, sums, _) in enumerate(asked, 1):
        for i, wanted in enumerate((hand, ZERO)):
            then = f"; particles[{i}].force_accumulator in N at call {number} of apply_forces"
            why = gone if i == 0 and sums[i] == ZERO else about.cause
            expect_close(sums[i], wanted, then=then, cause=why, tolerance=1e-12)


@methods(asks="which then belong to the wrong positions")
def test_where_a_step_asks_for_forces(method: str, rng: Random) -> None:
    about.read = f"the docstring of {method}"
    k, h = positive_number(rng), positive_number(rng, 0.1, 0.4)
    body = draw_body(rng)
    p, v, a, mass, _, _ = body
    about.call = f"p is at {p} m and moves at {v} m/s; its acceleration is {a} m/s^2 and its mass "
    about.call += f"{mass} kg; apply_forces adds the force -{k} x, where x is p's position; "
    about.call += f"{method}([p], apply_forces, duration={h})"
    about.cause = RULES[method]
    if EVALUATIONS[method] == 1:
        when = "after the first half drift" if method == "leapfrog" else "before you move p"
        about.cause = f"You call apply_forces at the wrong time. Call it {when}."
    asked = stepped(method, [body], (k, 0.0), h, 1)["asked"]
    wanted = []
    for i in range(3):
        first = a[i] - k * p[i] / mass
        places = [p[i]]
        if method == "leapfrog":
            places = [p[i] + 0.5 * h * v[i]]
        elif method == "velocity_verlet":
            places.append(p[i] + v[i] * h + 0.5 * first * h * h)
        elif method == "runge_kutta_4":
            about.cause = (
                "At least one of your four rates belongs to the wrong state. For each rate, "
            )
            about.cause += (
                "go back to the start and move at the previous rate: 0, h / 2, h / 2 and h."
            )
            places.append(p[i] + 0.5 * h * v[i])
            second = a[i] - k * places[1] / mass
            places.append(p[i] + 0.5 * h * (v[i] + 0.5 * h * first))
            places.append(p[i] + h * (v[i] + 0.5 * h * second))
        wanted.append(places)
    got = [part for _, _, places in asked for part in places[0]]
    flat = [wanted[i][n] for n in range(len(wanted[0])) for i in range(3)]
    expect_close(
        got,
        flat,
        then="; the position of the particle at each call of apply_forces, in m",
        tolerance=1e-11,
    )


@methods(asks="Particle.last_acceleration is the mean acceleration")
def test_what_a_step_leaves_behind(method: str, rng: Random) -> None:
    about.read = "the docstring of the module, and Particle.last_acceleration"
    k, c, h = positive_number(rng), positive_number(rng, 0.2, 2.0), positive_number(rng, 0.1, 0.4)
    body = draw_body(rng, components(rng))
    p, v, a, mass, d, hand = body
    about.call = f"p has an acceleration of {a} m/s^2 and a mass of {mass} kg; the check adds "
    about.call += f"{hand} N to p, and apply_forces adds -{k} x - {c} v; "
    about.call += f"{method}([p], apply_forces, duration={h})"
    about.cause = "Some forces are still in the accumulators at the end of the step, so they act "
    about.cause += "again in the next step. Clear the accumulators."
    ends = stepped(method, [body], (k, c), h, 1)
    expect_close(ends["forces"][0], ZERO, then="; p.force_accumulator, in N")
    about.cause = "last_acceleration must be the mean acceleration of the step. Add the mean "
    about.cause += "force to the particle and call kick, which changes the velocity and sets this "
    about.cause += "attribute."
    wanted = tuple(
        one_step(method, p[i], v[i], a[i] + hand[i] / mass, k / mass, c / mass, d, h)[2]
        for i in range(3)
    )
    got = ends["accelerations"][0]
    expect_close(got, wanted, then="; p.last_acceleration, in m/s^2", tolerance=1e-9)


@methods(asks="particles do not move, and keep their velocities")
def test_an_immovable_particle_stays(method: str, rng: Random) -> None:
    about.read = "the docstring of the module"
    place, velocity, a = components(rng), components(rng), components(rng)
    still: Body = (place, velocity, a, math.inf, 0.5, components(rng))
    other: Body = ((1.0, 2.0, 3.0), ZERO, ZERO, 2.0, 1.0, ZERO)
    about.call = f"particles[0] is immovable, at {place} m, with a velocity of {velocity} m/s; "
    about.call += "particles[1] has a mass of 2 kg; "
    about.call += f"{method}(particles, apply_forces, duration=0.25) twice"
    about.cause = "You move an immovable particle. Skip immovable particles, or use drift and "
    about.cause += "kick, which leave them where they are."
    ends = stepped(method, [still, other], (3.0, 0.5), 0.25, 2)
    expect_close(
        ends["positions"][0],
        place,
        then="; particles[0].position, in m",
        tolerance=0.0,
    )
    about.cause = "You change the velocity of an immovable particle, which must stay the same."
    expect_close(
        ends["velocities"][0],
        velocity,
        then="; particles[0].velocity, in m/s",
        tolerance=0.0,
    )
    about.cause = (
        "Forces have no effect on an immovable particle, but they must not add up from step to "
        "step. Clear its accumulator at the end of the step too."
    )
    expect_close(ends["forces"][0], ZERO, then="; particles[0].force_accumulator, in N")
    x, v = 1.0, 0.0
    for _ in range(2):
        x, v, _ = one_step(method, x, v, 0.0, 1.5, 0.25, 1.0, 0.25)
    about.cause = (
        "The particle after the immovable one has the wrong position. Your loop probably ends at "
        "the immovable particle, so skip only that one."
    )
    got = ends["positions"][1][0]
    expect_close(got, x, then="; particles[1].position.x, in m", tolerance=1e-12)
