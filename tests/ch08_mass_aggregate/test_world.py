"""The world: mechanical energy and time steps, B8.1 and B8.2."""

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
VALID = "These arguments are valid, so don't raise an error."


def draw_body(rng: Random) -> Body:
    return components(rng), components(rng), components(rng), positive_number(rng)


@pytest.mark.exercise("B8.1")
def test_energy_is_kinetic_and_that_of_the_acceleration(rng: Random) -> None:
    about.read = ENERGY
    bodies = [draw_body(rng) for _ in range(3)]
    parts = [0.5 * m * dot(v, v) - m * dot(a, p) for p, v, a, m in bodies]
    simple = ((0.0, 3.0, 0.0), (4.0, 0.0, 0.0), (0.0, -10.0, 0.0), 2.0)
    about.call = "mechanical_energy of a particle of 2 kg at (0, 3, 0) with velocity (4, 0, 0) "
    about.call += "and acceleration (0, -10, 0)"
    got = energy_of([simple])
    mistakes = [
        (16.0, "This is the kinetic energy alone. Add the potential energy, which is m g y = 60 J "
               "here."),
        (60.0, "This is the potential energy alone. Add the kinetic energy, which is m v^2 / 2 = "
               "16 J here."),
        (-44.0, "The potential energy has the wrong sign. It grows with height, and since a points "
                "down, that makes it - m a . p."),
        (74.86, "You used 9.81 m/s^2 for gravity. This particle has its own acceleration of 10 "
                "m/s^2, so use particle.acceleration."),
        (92.0, "The kinetic energy is twice as large as it should be. It is m v^2 / 2, so you left "
               "out the factor 1/2."),
        (38.0, "You left the mass out of the potential energy, which is - m a . p. Multiply a . p "
               "by the mass."),
        (46.0, "You left the mass out of the potential energy, which is - m a . p. Multiply a . p "
               "by the mass."),
    ]  # fmt: skip
    about.cause = cause_of(
        got,
        mistakes,
        "The energy is m v^2 / 2 + m g y. Here the kinetic "
        "energy is 16 J and the potential energy is 60 J.",
    )
    expect_close(got, 76.0)
    about.cause = (
        "The energy of one particle is m v^2 / 2 - m a . p. Compute it for each particle, and "
        "return the sum."
    )
    for name, some, wanted in (
        ("one particle", bodies[:1], parts[0]),
        ("three particles", bodies, math.fsum(parts)),
    ):
        bodies_in_words = "; ".join(
            f"{m} kg at {p} with velocity {v} and acceleration {a}" for p, v, a, m in some
        )
        about.call = f"mechanical_energy of {name}: {bodies_in_words}"
        got = energy_of(some)
        # Rounding of terms of some hundreds of J.
        expect_close(got, wanted, tolerance=1e-10)
    about.call = "mechanical_energy of one particle on which a force acts; its position, "
    about.call += f"velocity, acceleration and mass are {bodies[0]}"
    about.cause = "A force in the accumulator has changed the result. Forces don't contribute to "
    about.cause += "this energy, so use only the particle's own acceleration."
    got = energy_of(bodies[:1], components(rng))
    expect_close(got, parts[0], tolerance=1e-10)


@pytest.mark.exercise("B8.1")
def test_what_nothing_moves_has_no_energy(rng: Random) -> None:
    about.read = ENERGY
    p, v, a, m = draw_body(rng)
    about.cause = "An immovable particle has an infinite mass, so its energy would be infinite "
    about.cause += "or NaN. Skip every particle whose inverse_mass is 0."
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
    expect_close(
        energy_of([]),
        0.0,
        cause="There are no particles, so the total energy is 0. Return 0.",
        tolerance=0.0,
    )


@pytest.mark.exercise("B8.2")
def test_starting_a_frame_clears_the_accumulators(rng: Random) -> None:
    about.read = f"{WORLD}start_frame"
    bodies = [draw_body(rng) for _ in range(3)]
    bodies.insert(1, (components(rng), ZERO, ZERO, math.inf))
    force = components(rng)
    about.call = f"add_force(Vector3{force}) for four particles, of which number 1 is immovable; "
    about.call += "world.start_frame()"
    about.cause = "start_frame should call clear_forces() for every particle and change nothing "
    about.cause += "else."
    done = started(bodies, force)
    for i, body in enumerate(bodies):
        name = f"{about.call}; particles[{i}].force_accumulator"
        expect_close(done["after"][i], ZERO, call=name, tolerance=0.0)
        name = f"{about.call}; position and velocity of particles[{i}]"
        expect_close(done["states"][i][0], body[0], call=name, tolerance=0.0)
        expect_close(done["states"][i][1], body[1], call=name, tolerance=0.0)


@pytest.mark.exercise("B8.2")
def test_contacts_are_those_of_every_generator(rng: Random) -> None:
    about.read = f"{WORLD}contacts"
    count = rng.randint(150, 300)
    low, high = sorted(float(rng.randint(2, 9)) for _ in range(2))
    about.call = f"{count} particles at a height of 1, with floors at 0, 1, {low} and {high}: the "
    about.call += "penetrations in world.contacts()"
    about.cause = "Return all contacts of all generators in one list. The book's world stops at a "
    about.cause += "maximum number of contacts and drops the others, but yours should keep them "
    about.cause += "all."
    wanted = [0.0] * count + [low - 1.0] * count + [high - 1.0] * count
    got = depths_of(count, [0.0, 1.0, low, high])
    first = "The first floor has no contacts, and your search stopped there. If a generator "
    first += "returns nothing, continue with the next one."
    only = f"You returned the contacts of only {len(got) // count} of the 3 floors. Collect the "
    only += "contacts of all generators before you return."
    seen = cause_of(len(got), [(0, first), (count, only), (2 * count, only)], about.cause)
    expect_exactly(len(got), 3 * count, then=": how many", cause=seen)
    order = "The contacts are in the wrong order. Go through contact_generators from first to "
    order += "last, and append the contacts of each."
    runs = [round(depth, 9) for depth in got[::count]]
    expect_exactly(
        runs,
        [0.0, low - 1.0, high - 1.0],
        then=": the penetration for each floor, in order",
        cause=order,
    )
    expect_close(got, wanted)
    about(
        "world.contacts() without generators",
        cause="Without generators there are no contacts, so return an empty list.",
    )
    expect_exactly(depths_of(count, []), [])


@pytest.mark.exercise("B8.2")
@pytest.mark.parametrize("integrator", ["explicit_euler", "semi_implicit_euler"])
def test_a_frame_moves_by_forces_and_gravity(rng: Random, integrator: str) -> None:
    about.read = f"{WORLD}run_physics"
    h, k = positive_number(rng, 0.05, 0.2), positive_number(rng)
    hand = components(rng)
    bodies = [draw_body(rng) for _ in range(2)]
    about.cause = "Call self.integrator(self.particles, self.registry.update_forces, duration). "
    about.cause += "Forces that were added after start_frame must still be there, so don't clear "
    about.cause += "them in run_physics."
    about.call = f"a world of two particles with integrator={integrator} and forces of -{k} x: "
    about.call += f"start_frame(); add_force(Vector3{hand}); run_physics({h})"
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
                (1.0, 0.0, "The forces of the registry have no effect. Pass "
                 "self.registry.update_forces to the integrator, which calls it."),
                (1.0, 2.0, "The forces of the registry count twice. The integrator calls "
                           "update_forces itself, so don't call it as well."),
                (0.0, 1.0, "The force that was added after start_frame is gone. Only start_frame "
                           "clears the forces, so don't clear them in run_physics."),
                (0.0, 0.0, "Only the acceleration has an effect, and all forces are gone. Pass "
                           "self.registry.update_forces to the integrator, and don't clear the "
                           "forces in run_physics."),
            )
        ]  # fmt: skip
        seen = cause_of(got[1], mistakes, about.cause)
        # A few roundings of numbers of some hundreds.
        expect_close(got[1], velocity, call=f"{name}.velocity", cause=seen, tolerance=1e-11)
        other = [p[j] + v[j] * h for j in range(3)]
        seen = "Your world took a step of explicit Euler, although it was given a different "
        seen += "integrator. Call self.integrator."
        blame(got[0], [(other, seen)])
        expect_close(got[0], place, call=f"{name}.position", tolerance=1e-11)


@pytest.mark.exercise("B8.2")
def test_a_step_forgets_what_was_added_before_it(rng: Random) -> None:
    h, force = positive_number(rng, 0.05, 0.2), components(rng)
    p, v, a, m = draw_body(rng)
    about(f"add_force(Vector3{force}); world.step({h})", read=f"{WORLD}step")
    about.cause = "A step consists of two calls: first start_frame, which clears the forces that "
    about.cause += "were added earlier, and then run_physics."
    done = frame([(p, v, a, m)], "step", h, early=force)
    velocity = [v[j] + a[j] * h for j in range(3)]
    got = done["states"][0][1]
    expect_close(got, velocity, then="; particle.velocity", tolerance=1e-12)
    about.call = (
        f"world.step({h}) in a subclass that replaces run_physics: the calls of run_physics"
    )
    about.cause = "step should call self.run_physics(duration) once. Don't repeat its code in "
    about.cause += "step, because a subclass such as SleepingWorld has its own run_physics."
    expect_exactly(told_frame(h), [("run_physics", h)])
    about.cause = "run_physics should call the integrator and pass it the forces of the registry."
    f = components(rng)
    about.call = f"a world whose registry adds a force of -Vector3{f}; world.step({h})"
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
    about.call = f"two particles with one generator each, integrator={integrator}; run_physics({h})"
    about.cause = (
        "Call self.integrator only once, and pass it all particles and the whole duration."
    )
    done = frame(bodies, "run_physics", h, integrator=integrator, k=k)
    asked = [row[1:] for row in done["diary"] if row[0] == "integrator"]
    expect_exactly(asked, [(h, 2)], then=": duration and number of particles of each call of it")
    about.cause = "Pass self.registry.update_forces to the integrator, but don't call it "
    about.cause += "yourself. The integrator decides how often it needs the forces, and "
    about.cause += "Runge-Kutta evaluates them four times per step."
    count = sum(row[0] == "force" for row in done["diary"])
    expect_exactly(count, 2 * evaluations, then=": the number of calls of update_force")
    asked = [row[1] for row in done["diary"] if row[0] == "force"]
    expect_exactly(asked, [h] * count, then=": the durations passed to update_force")


@pytest.mark.exercise("B8.2")
def test_contacts_are_those_of_the_new_places(rng: Random) -> None:
    about.read = f"{WORLD}run_physics"
    h = 0.125
    speed = float(rng.randint(8, 16))
    bodies: list[Body] = [
        ((0.0, 0.5, 0.0), (2.0, -speed, 0.0), ZERO, 1.0),
        ((5.0, 9.0, 0.0), (2.0, -speed, 0.0), ZERO, 1.0),
    ]
    about.call = (
        f"a particle that is 0.5 m above a floor and moves at {-speed} m/s; world.run_physics({h})"
    )
    about.cause = "Move the particles first, then collect the contacts, and then resolve them, so "
    about.cause += "that the particle ends up at rest on the floor."
    done = frame(bodies, "run_physics", h, floors=[0.0])
    place, velocity = done["states"][0]
    fallen = 0.5 - speed * h
    inside = "The particle ends up inside the floor, because you collected the contacts before it "
    inside += "moved. Collect them after the integrator has moved the particles, and then resolve "
    inside += "them."
    seen = cause_of(place, [((0.25, fallen, 0.0), inside)], about.cause)
    name = f"{about.call}; particle.position"
    expect_close(place, (0.25, 0.0, 0.0), call=name, cause=seen, tolerance=1e-12)
    name = f"{about.call}; particle.velocity"
    expect_close(velocity, (2.0, 0.0, 0.0), call=name, tolerance=1e-12)
    about.cause = (
        "You changed the velocity of a particle that has no contact. Resolve only the contacts, "
        "and leave all other particles alone."
    )
    name = f"{about.call}; another particle, far above: velocity"
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
    about.call = (
        f"three particles at a height of 1, with floors at {low} and at {high}; run_physics({h})"
    )
    about.cause = "Collect the contacts of all generators once. Then call "
    about.cause += "resolver.resolve_contacts once, with all of them and the duration."
    done = frame(bodies, "run_physics", h, floors=[low, high], record=True)
    calls = [row for row in done["diary"] if row[0] == "resolve"]
    expect_exactly(len(calls), 1, then=": the number of calls of the resolver")
    depths = [low - 1.0] * 3 + [high - 1.0] * 3
    expect_close(
        (calls[0][1], *calls[0][2]),
        (h, *depths),
        then=": the duration passed to the resolver, and the penetrations",
    )
    asked = [row[1] for row in done["diary"] if row[0] == "contacts"]
    expect_exactly(asked, [low, high], then=": the floors whose contacts() was called")
    about.call = f"three particles at a height of 1, above a floor at 0.5; run_physics({h})"
    about.cause = "You called the resolver although there are no contacts. Call it only if there "
    about.cause += "are some, which saves time in every step without any."
    done = frame(bodies, "run_physics", h, floors=[0.5], record=True)
    count = sum(row[0] == "resolve" for row in done["diary"])
    expect_exactly(count, 0, then=": the number of calls of the resolver")


@pytest.mark.exercise("B8.2")
def test_no_contact_is_left_out(rng: Random) -> None:
    about.read = f"{WORLD}contacts, and the class: there is no maximum"
    count = rng.randint(30, 60)
    about.call = f"{count} particles fall on the ground at once; their heights after a second"
    about.cause = "You didn't resolve every contact, so some particles have fallen through the "
    about.cause += "ground. The book's world stops at a maximum number of contacts and drops the "
    about.cause += "others, but yours should resolve them all."
    heights = rained(count, 0.05, 20)
    expect_close(heights, (0.0,) * count, tolerance=1e-9)


@pytest.mark.exercise("B8.2")
def test_a_world_may_get_more_later(rng: Random) -> None:
    about.read = "the docstring of ParticleWorld: its lists may be appended to"
    h = positive_number(rng, 0.05, 0.2)
    about.call = f"a particle falls for {h} s, then two more particles and a ground below the "
    about.call += "third one are appended; world.step: the vertical velocities"
    about.cause = "The world should notice what gets appended to its lists. Read self.particles "
    about.cause += "and self.contact_generators again in every step instead of keeping a copy, and "
    about.cause += "resolve the contacts."
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
        about(
            f"world.{method}({duration!r})",
            cause='The duration must be positive and finite. Check it with positive("duration", '
            "duration) before you do anything else.",
        )
        done = refused(method, duration)
        expect_exactly(done["error"], error, then=": the name of the error ('' if there was none)")
        about.cause = "The call raised an error, but only after it had changed the world. Check "
        about.cause += "the duration before you clear forces or move anything."
        got = tuple(number for part in done["left"] for number in part)
        wanted = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0)
        expect_close(got, wanted, then="; position, velocity, force_accumulator", tolerance=0.0)
    done = frame([(ZERO, ZERO, (1.0, 0.0, 0.0), 1.0)], method, 0.5)
    about(f"world.{method}(0.5)", cause=VALID)
    expect_close(done["states"][0][1], (0.5, 0.0, 0.0), then="; velocity")
