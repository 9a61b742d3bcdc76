"""The world: energy and frames, B8.1 and B8.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch08_mass_aggregate.probes import (
    Body,
    appended,
    depths_of,
    energy_of,
    frame,
    rained,
    refused,
    started,
    told_frame,
)
from draw import components, dot, positive_number
from expect import about, blame, cause_of, expect_close, expect_exactly

ZERO = (0.0, 0.0, 0.0)
ENERGY = "the docstring of mechanical_energy"
WORLD = "book 8.1, and the docstring of ParticleWorld."


def draw_body(rng: Random) -> Body:
    return components(rng), components(rng), components(rng), positive_number(rng)


@pytest.mark.exercise("B8.1")
def test_energy_is_kinetic_and_that_of_the_acceleration(rng: Random) -> None:
    about.read = ENERGY
    bodies = [draw_body(rng) for _ in range(3)]
    parts = [0.5 * m * dot(v, v) - m * dot(a, p) for p, v, a, m in bodies]
    simple = ((0.0, 3.0, 0.0), (4.0, 0.0, 0.0), (0.0, -10.0, 0.0), 2.0)
    about.call = "mechanical_energy of 2 kg at (0, 3, 0), velocity (4, 0, 0), acceleration (0, "
    about.call += "-10, 0)"
    got = energy_of([simple])
    mistakes = [
        (16.0, "that is the kinetic energy alone: m g y, so 60 J, is left out"),
        (60.0, "that is m g y alone: the kinetic energy, 16 J, is left out"),
        (-44.0, "the sign of the second part is turned round: - m a . p, with a = (0, -g, 0)"),
        (74.86, "that is with 9.81 m/s^2: take the particle's own acceleration, 10 m/s^2 here"),
        (92.0, "the half of m v^2 / 2 is left out"),
        (38.0, "the mass is left out: m v^2 / 2 - m a . p"),
        (46.0, "the mass is left out of the second part: m v^2 / 2 - m a . p"),
    ]
    about.cause = cause_of(got, mistakes, "m v^2 / 2 + m g y: 16 J and 60 J")
    expect_close(got, 76.0)
    about.cause = "m v^2 / 2 - m a . p of each: with a = (0, -g, 0) the second part is + m g y"
    for name, some, wanted in (
        ("one particle", bodies[:1], parts[0]),
        ("three particles", bodies, math.fsum(parts)),
    ):
        about.call = f"mechanical_energy of {name}, by place, velocity, acceleration, mass: {some}"
        got = energy_of(some)
        # Rounding of terms of some hundreds of J.
        expect_close(got, wanted, tolerance=1e-10)
    about.call = f"mechanical_energy of one particle, and a force acts on it: {bodies[0]}"
    about.cause = "forces have no part in it: only the particle's own acceleration"
    got = energy_of(bodies[:1], components(rng))
    expect_close(got, parts[0], tolerance=1e-10)


@pytest.mark.exercise("B8.1")
def test_what_nothing_moves_has_no_energy(rng: Random) -> None:
    about.read = ENERGY
    p, v, a, m = draw_body(rng)
    about.cause = "leave out what has no inverse_mass: its energy would be infinite, or not a "
    about.cause += "number"
    wanted = 0.5 * m * dot(v, v) - m * dot(a, p)
    for first, call in (
        (True, "mechanical_energy of a particle and an immovable one"),
        (False, "mechanical_energy of an immovable particle and another one"),
    ):
        about.call = call
        both = [(p, v, a, m), (components(rng), ZERO, components(rng), math.inf)]
        got = energy_of(both if first else both[::-1])
        expect_close(got, wanted, tolerance=1e-10)
    about.call = "mechanical_energy of no particles"
    expect_close(energy_of([]), 0.0, cause="nothing has no energy", tolerance=0.0)


@pytest.mark.exercise("B8.2")
def test_starting_a_frame_clears_the_accumulators(rng: Random) -> None:
    about.read = f"{WORLD}start_frame"
    bodies = [draw_body(rng) for _ in range(3)]
    bodies.insert(1, (components(rng), ZERO, ZERO, math.inf))
    force = components(rng)
    about.call = f"each of four particles, one of them immovable, .add_force(Vector3{force}); "
    about.call += "world.start_frame()"
    about.cause = "clear_forces() of every particle, and nothing else"
    done = started(bodies, force)
    for i, body in enumerate(bodies):
        expect_close(
            done["after"][i], ZERO, then=f"; particles[{i}].force_accumulator", tolerance=0.0
        )
        name = f"{about.call}; place and velocity of particles[{i}]"
        expect_close(done["states"][i][0], body[0], call=name, tolerance=0.0)
        expect_close(done["states"][i][1], body[1], call=name, tolerance=0.0)


@pytest.mark.exercise("B8.2")
def test_contacts_are_those_of_every_generator(rng: Random) -> None:
    about.read = f"{WORLD}contacts"
    count = rng.randint(150, 300)
    low, high = sorted(float(rng.randint(2, 9)) for _ in range(2))
    about.call = f"{count} particles at a height of 1, floors at 0, 1, {low} and {high}: the "
    about.call += "depths of world.contacts(), one list of contacts"
    about.cause = "one generator after the other, in their order, and none of what they find is "
    about.cause += "left out: the book's world has a maximum, and drops what is above it"
    wanted = [0.0] * count + [low - 1.0] * count + [high - 1.0] * count
    got = depths_of(count, [0.0, 1.0, low, high])
    first = "nothing touches the first floor: go on to the next generator"
    seen = cause_of(len(got), [(0, first)], about.cause)
    expect_exactly(len(got), 3 * count, then=": how many", cause=seen)
    order = "one generator after the other, in the order of contact_generators"
    runs = [round(depth, 9) for depth in got[::count]]
    expect_exactly(
        runs, [0.0, low - 1.0, high - 1.0], then=": in which order, by depth", cause=order
    )
    expect_close(got, wanted)
    about.call, about.cause = (
        "world.contacts() without a generator",
        "there are none: an empty list",
    )
    expect_exactly(depths_of(count, []), [])


@pytest.mark.exercise("B8.2")
@pytest.mark.parametrize("integrator", ["explicit_euler", "semi_implicit_euler"])
def test_a_frame_moves_by_forces_and_gravity(rng: Random, integrator: str) -> None:
    about.read = f"{WORLD}run_physics"
    h, k = positive_number(rng, 0.05, 0.2), positive_number(rng)
    hand = components(rng)
    bodies = [draw_body(rng) for _ in range(2)]
    about.cause = "the integrator is called with the particles, with what adds the registry's "
    about.cause += "forces, registry.update_forces, and with the duration; what was added since "
    about.cause += "start_frame counts"
    about.call = f"world of two particles, integrator={integrator}, forces -{k} x: start_frame(); "
    about.call += f"add_force(Vector3{hand}); run_physics({h})"
    done = frame(bodies, "run_physics", h, integrator=integrator, k=k, late=hand)
    for i, (p, v, a, m) in enumerate(bodies):
        push = [a[j] + (hand[j] - k * p[j]) / m for j in range(3)]
        velocity = [v[j] + push[j] * h for j in range(3)]
        way = velocity if integrator == "semi_implicit_euler" else v
        place = [p[j] + way[j] * h for j in range(3)]
        got = done["states"][i]
        name = f"{about.call}; particles[{i}]"
        mistakes = [
            (
                [v[j] + (a[j] + (c * hand[j] - k * d * p[j]) / m) * h for j in range(3)],
                why,
            )
            for c, d, why in (
                (1.0, 0.0, "the forces of the registry are left out: the integrator asks for them "
                 "by the second thing that it is given, self.registry.update_forces"),
                (1.0, 2.0, "the forces of the registry count twice: the integrator asks for them "
                 "itself, so nothing else may"),
                (0.0, 1.0, "the force that was added since start_frame is lost: run_physics does "
                 "not clear"),
                (0.0, 0.0, "no force counts: only the acceleration is there"),
            )
        ]  # fmt: skip
        seen = cause_of(got[1], mistakes, about.cause)
        # A few roundings of numbers of some hundreds.
        expect_close(got[1], velocity, call=f"{name}.velocity", cause=seen, tolerance=1e-11)
        other = [p[j] + v[j] * h for j in range(3)]
        seen = "that is an explicit step: use self.integrator, which is another one here"
        blame(got[0], [(other, seen)])
        expect_close(got[0], place, call=f"{name}.position", tolerance=1e-11)


@pytest.mark.exercise("B8.2")
def test_a_step_forgets_what_was_added_before_it(rng: Random) -> None:
    about.read = f"{WORLD}step"
    h, force = positive_number(rng, 0.05, 0.2), components(rng)
    p, v, a, m = draw_body(rng)
    about.call = f"add_force(Vector3{force}); world.step({h})"
    about.cause = "step is start_frame and then run_physics: the first clears what was there before"
    done = frame([(p, v, a, m)], "step", h, early=force)
    velocity = [v[j] + a[j] * h for j in range(3)]
    got = done["states"][0][1]
    expect_close(got, velocity, then="; particle.velocity", tolerance=1e-12)
    about.call = f"a world whose run_physics only writes down that it is asked; world.step({h})"
    about.cause = "call self.run_physics(duration), once: a world that is made from this one has "
    about.cause += "another"
    expect_exactly(told_frame(h), [("run_physics", h)])
    about.cause = "its run_physics uses the integrator and the registry as well"
    f = components(rng)
    about.call = f"a registry with a force -Vector3{f}; world.step({h})"
    done = frame([(p, v, a, m)], "step", h, f=f)
    velocity = [v[j] + (a[j] - f[j] / m) * h for j in range(3)]
    got = done["states"][0][1]
    expect_close(got, velocity, then="; particle.velocity", tolerance=1e-12)


@pytest.mark.exercise("B8.2")
@pytest.mark.parametrize("integrator", ["semi_implicit_euler", "runge_kutta_4"])
def test_the_integrator_asks_for_forces_itself(rng: Random, integrator: str) -> None:
    about.read = f"{WORLD}run_physics"
    h, k = positive_number(rng, 0.05, 0.2), positive_number(rng)
    bodies = [draw_body(rng) for _ in range(2)]
    evaluations = 4 if integrator == "runge_kutta_4" else 1
    about.call = f"two particles with a generator each, integrator={integrator}; run_physics({h})"
    about.cause = "the integrator is called once, with all particles and the whole duration"
    done = frame(bodies, "run_physics", h, integrator=integrator, k=k)
    asked = [row[1:] for row in done["diary"] if row[0] == "integrator"]
    expect_exactly(asked, [(h, 2)], then=": calls of it, and particles")
    about.cause = "give it registry.update_forces and let it ask: Runge-Kutta does so four times"
    count = sum(row[0] == "force" for row in done["diary"])
    expect_exactly(count, 2 * evaluations, then=": how often the generators were asked")
    asked = [row[1] for row in done["diary"] if row[0] == "force"]
    expect_exactly(asked, [h] * count, then=": the durations that they were told")


@pytest.mark.exercise("B8.2")
def test_contacts_are_those_of_the_new_places(rng: Random) -> None:
    about.read = f"{WORLD}run_physics"
    h = 0.125
    speed = float(rng.randint(8, 16))
    bodies: list[Body] = [
        ((0.0, 0.5, 0.0), (2.0, -speed, 0.0), ZERO, 1.0),
        ((5.0, 9.0, 0.0), (2.0, -speed, 0.0), ZERO, 1.0),
    ]
    about.call = f"a particle 0.5 m above a floor at {-speed} m/s; world.run_physics({h})"
    about.cause = "first the particles move, then the generators are asked, then the resolver ends "
    about.cause += "what they found: it stands on the floor, and no longer falls"
    done = frame(bodies, "run_physics", h, floors=[0.0])
    place, velocity = done["states"][0]
    fallen = 0.5 - speed * h
    mistakes = [
        ((0.25, fallen, 0.0), "it is in the floor: the contacts of the new place are not resolved")
    ]
    seen = cause_of(place, mistakes, about.cause)
    expect_close(place, (0.25, 0.0, 0.0), then="; particle.position", cause=seen, tolerance=1e-12)
    expect_close(velocity, (2.0, 0.0, 0.0), then="; particle.velocity", tolerance=1e-12)
    about.cause = "what is in no contact flies on"
    got = done["states"][1][1]
    expect_close(
        got, (2.0, -speed, 0.0), then="; another particle, far above: velocity", tolerance=1e-12
    )


@pytest.mark.exercise("B8.2")
def test_all_contacts_are_resolved_at_once(rng: Random) -> None:
    about.read = f"{WORLD}run_physics"
    h = 0.125
    low, high = sorted(float(rng.randint(2, 9)) for _ in range(2))
    bodies: list[Body] = [((float(i), 1.0, 0.0), ZERO, ZERO, 1.0) for i in range(3)]
    about.call = f"three particles at a height of 1, floors at {low} and at {high}; "
    about.call += f"run_physics({h})"
    about.cause = "collect the contacts of every generator, once each and in their order, and call "
    about.cause += "resolver.resolve_contacts once, with all of them and the duration"
    done = frame(bodies, "run_physics", h, floors=[low, high], record=True)
    calls = [row for row in done["diary"] if row[0] == "resolve"]
    expect_exactly(len(calls), 1, then=": calls of the resolver")
    depths = [low - 1.0] * 3 + [high - 1.0] * 3
    expect_close(
        (calls[0][1], *calls[0][2]),
        (h, *depths),
        then=": the resolver's duration, and the depths of its contacts",
    )
    asked = [row[1] for row in done["diary"] if row[0] == "contacts"]
    expect_exactly(asked, [low, high], then=": which floors were asked")
    about.call = f"three particles at a height of 1, above a floor at 0.5; run_physics({h})"
    about.cause = "a frame without contacts needs no resolver: model no more than is there"
    done = frame(bodies, "run_physics", h, floors=[0.5], record=True)
    count = sum(row[0] == "resolve" for row in done["diary"])
    expect_exactly(count, 0, then=": calls of the resolver")


@pytest.mark.exercise("B8.2")
def test_no_contact_is_left_out(rng: Random) -> None:
    about.read = f"{WORLD}contacts, and the class: there is no maximum"
    count = rng.randint(30, 60)
    about.call = f"{count} particles fall on the ground at once; their heights after a second"
    about.cause = "all contacts are resolved: the book's world has a maximum, and drops the others"
    heights = rained(count, 0.05, 20)
    expect_close(heights, (0.0,) * count, tolerance=1e-9)


@pytest.mark.exercise("B8.2")
def test_a_world_may_get_more_later(rng: Random) -> None:
    about.read = "the docstring of ParticleWorld: its lists may be appended to"
    h = positive_number(rng, 0.05, 0.2)
    about.call = f"a particle falls for a frame of {h} s, then a second one is appended, and a "
    about.call += "third one on a ground; world.step: their velocities along Y"
    about.cause = "read self.particles and self.contact_generators in every frame"
    got = [velocity[1] for _, velocity in appended(h)]
    wanted = (-20.0 * h, -10.0 * h, 0.0)
    expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B8.2")
@pytest.mark.robust
@pytest.mark.parametrize("method", ["run_physics", "step"])
def test_a_frame_without_a_duration_is_refused(method: str) -> None:
    about.read = f"{WORLD}{method}"
    for duration, error in (
        (0.0, "ValueError"),
        (-0.1, "ValueError"),
        (math.nan, "ValueError"),
        (math.inf, "ValueError"),
        ("0.1", "TypeError"),
    ):
        about.call = f"world.{method}({duration!r})"
        about.cause = "positive() refuses it; call it before anything changes"
        done = refused(method, duration)
        expect_exactly(done["error"], error, then=": the error, '' for none")
        about.cause = "what is refused loses nothing: not a place, not a velocity, not an added "
        about.cause += "force"
        got = tuple(number for part in done["left"] for number in part)
        wanted = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)
        expect_close(got, wanted, then="; position, velocity, force_accumulator", tolerance=0.0)
    done = frame([(ZERO, ZERO, (1.0, 0.0, 0.0), 1.0)], method, 0.5)
    about.call, about.cause = f"world.{method}(0.5)", "what is right must not be refused"
    expect_close(done["states"][0][1], (0.5, 0.0, 0.0), then="; velocity")
