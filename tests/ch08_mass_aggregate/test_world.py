"""The world: mechanical energy and time steps, B8.1 and B8.2."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch08_mass_aggregate.probes import Floor, add, depths_of, energy_of, frame
from ch08_mass_aggregate.world import ParticleWorld
from draw import Triple, positive_number, vector
from expect import expect_close, expect_exactly, expect_that, named, xyz

ZERO = Triple((0.0, 0.0, 0.0))
ENERGY = "the docstring of mechanical_energy"
WORLD = "book 8.1, and the docstring of ParticleWorld."
START, CONTACTS, RUN, STEP = (
    f"{WORLD}{name}" for name in ("start_frame", "contacts", "run_physics", "step")
)
LATER = "the docstring of ParticleWorld: its lists may be appended to"
Body = tuple[Triple, Triple, Triple, float]  # position, velocity, acceleration, mass


def draw_body(rng: Random) -> Body:
    return vector(rng), vector(rng), vector(rng), positive_number(rng)


def energy(bodies: Sequence[Body], cause: str, force: Triple = ZERO) -> Any:
    """Return the mechanical energy of bodies on each of which a force acts."""
    told = ", ".join(f"Particle({p}, {v}, {a}, mass={m})" for p, v, a, m in bodies)
    acts = ", on which a force acts as well" if any(force) else ""
    with calls(cause, f"mechanical_energy([{told.replace('inf', 'math.inf')}]){acts}"):
        return energy_of(bodies, force)


@pytest.mark.exercise("B8.1", asks="The result is the sum of m v^2 / 2 - m a . p", read=ENERGY)
def test_energy_is_kinetic_plus_potential(rng: Random) -> None:
    bodies = [draw_body(rng) for _ in range(3)]
    parts = [0.5 * m * (v @ v) - m * (a @ p) for p, v, a, m in bodies]
    rise, run, fall = map(Triple, ((0.0, 3.0, 0.0), (4.0, 0.0, 0.0), (0.0, -10.0, 0.0)))
    both = "The energy is the sum of m v^2 / 2 and m g y, which are 16 J and 60 J here."
    got = energy([(rise, run, fall, 2.0)], both)
    slips = {
        "You return the kinetic energy alone.": 16.0,
        "You return the potential energy alone.": 60.0,
        "Your potential energy has the wrong sign. It is -m a . p.": -44.0,
        "You use 9.81 m/s^2 instead of particle.acceleration, which is 10 m/s^2 here.": 74.86,
        "Your kinetic energy is twice as large, as if you left out the factor 1/2.": 92.0,
        "You leave the mass out of both energies.": 38.0,
        "You leave the mass out of the potential energy, which is -m a . p.": 46.0,
    }
    expect_close(got, 76.0, slips, unit="J")
    first = "Your loop returns after the first particle. Return the sum after the loop."
    for some, force, wanted, cause in (
        (bodies[:1], ZERO, parts[0], "The energy of a particle is m v^2 / 2 - m a . p."),
        (bodies, ZERO, math.fsum(parts), "The energy of one particle is m v^2 / 2 - m a . p. "
         "Compute it for each particle, and return the sum."),
        (bodies[:1], vector(rng), parts[0], "Your potential energy includes the force that acts on "
         "the particle. Use only particle.acceleration, which doesn't include forces."),
    ):  # fmt: skip
        got = energy(some, cause, force)
        # Rounding of terms of some hundreds of J.
        slips = {first: parts[0]} if len(some) > 1 else {}
        expect_close(got, wanted, slips, unit="J", tolerance=1e-10)


@pytest.mark.exercise("B8.1", asks="and neither do immovable particles", read=ENERGY)
def test_immovable_particles_have_no_energy(rng: Random) -> None:
    p, v, a, m = draw_body(rng)
    both = [(p, v, a, m), (vector(rng), ZERO, vector(rng), math.inf)]
    stops = "Your loop stops at the immovable particle. Skip it and continue with the next one."
    skip = "You count the immovable particle. Skip every particle whose inverse_mass is 0."
    for some in (both, both[::-1]):
        got, wanted = energy(some, skip), 0.5 * m * (v @ v) - m * (a @ p)
        expect_close(got, wanted, {stops: 0.0}, unit="J", tolerance=1e-10)
    got = energy([], "There are no particles, so the total energy is 0. Return 0.")
    expect_close(got, 0.0, tolerance=0.0)


@pytest.mark.exercise("B8.2", asks="the force accumulators of all particles", read=START)
def test_starting_a_frame_clears_the_accumulators(rng: Random) -> None:
    bodies, force = [draw_body(rng) for _ in range(3)], vector(rng)
    bodies.insert(1, (vector(rng), ZERO, ZERO, math.inf))
    why = "Call clear_forces() for every particle, with the parentheses."
    with calls(
        f"start_frame doesn't clear any forces. {why}",
        "a world of four particles, of which particles[1] is immovable; "
        f"add_force(Vector3{force}) for each of them; world.start_frame()",
    ):
        particles = [
            Particle(Vector3(*p), Vector3(*v), Vector3(*a), mass=m) for p, v, a, m in bodies
        ]
        world = ParticleWorld(particles)
        for particle in particles:
            particle.add_force(Vector3(*force))
        world.start_frame()
    kept = [i for i in range(4) if any(xyz(particles[i].force_accumulator))]
    why = f"start_frame doesn't clear {'any forces' if len(kept) == 4 else 'all forces'}. {why}"
    if kept == [1]:
        why = "You skip the immovable particle. Call clear_forces() for it too."
    only = "Your start_frame changes the position or the velocity. Only call clear_forces()."
    for i, (place, velocity, *_) in enumerate(bodies):
        for name, wanted, unit, cause in (
            ("force_accumulator", ZERO, "N", why),
            ("position", place, "m", only),
            ("velocity", velocity, "m/s", only),
        ):
            got, then = getattr(particles[i], name), f"; particles[{i}].{name}"
            expect_close(got, wanted, then=then, cause=cause, unit=unit, tolerance=0.0)


@pytest.mark.exercise("B8.2", asks="in the order of the generators", read=CONTACTS)
def test_contacts_of_every_generator_are_returned(rng: Random) -> None:
    count = rng.randint(150, 300)
    low, high = sorted(float(rng.randint(2, 9)) for _ in range(2))
    every = "Put the contacts of all generators into one list before you return it."
    text = f"{count} particles at a height of 1 m; floors at heights of 0, 1, {low:g} and {high:g} "
    text += "m; world.contacts()"
    with calls("Call contacts() of each generator, and put all contacts into one list.", text):
        got = depths_of(count, [0.0, 1.0, low, high])
    nested = f"Your contacts() returns a separate list for each floor. {every}"
    expect_that("a list" not in got, "a list of lists", "one list of contacts", cause=nested)
    why = "The book's world has a maximum number of contacts, but yours should return all of them."
    if len(got) > 3 * count:
        why = "You return some contacts more than once. Call each contacts() once."
    only = f"You return the contacts of only {len(got) // count} of the 3 floors that touch the "
    only += f"particles. {every}"
    why = named(len(got), f"You return {len(got)} contacts. {why}", {
        "Your loop ends after the first floor. Continue with the other floors.": 0,
        only: len(got) if len(got) in (count, 2 * count) else -1,
    })  # fmt: skip
    expect_exactly(len(got), 3 * count, unit="contacts", cause=why)
    order = "Your contacts are in the wrong order. Go through contact_generators in order."
    runs = [round(depth, 9) for depth in got[::count]]
    name = "; the penetrations at the floors that touch particles, in list order"
    expect_exactly(runs, [0.0, low - 1.0, high - 1.0], then=name, unit="m", cause=order)
    wanted = [0.0] * count + [low - 1.0] * count + [high - 1.0] * count
    expect_close(got, wanted)
    likely = "Without generators there are no contacts, so return an empty list."
    with calls(likely, "a world without contact generators; world.contacts()"):
        got = depths_of(count, [])
    expect_exactly(got, [])


@pytest.mark.exercise("B8.2", asks="First let the integrator move the particles", read=RUN)
@pytest.mark.parametrize("integrator", ["explicit_euler", "semi_implicit_euler"])
def test_a_frame_moves_by_forces_and_gravity(rng: Random, integrator: str) -> None:
    h, k, hand = positive_number(rng, 0.05, 0.2), positive_number(rng), vector(rng)
    bodies = [draw_body(rng) for _ in range(2)]
    why = "Call self.integrator(self.particles, self.registry.update_forces, duration). Clear no "
    why += "forces."
    text = f"two particles in a world with integrator={integrator}; a force generator in the "
    text += f"registry adds -{k} N/m * position to each; world.start_frame(); "
    text += f"add_force(Vector3{hand}) for both; world.run_physics({h})"
    with calls(why, text):
        done = frame(bodies, "run_physics", h, integrator=integrator, k=k, late=hand)
    given = [row[1] for row in done["diary"] if row[0] == "no function"]
    called = "You called update_forces. Pass the function itself, without parentheses."
    if given != ["None"]:
        called = f"The order of the arguments is wrong. {why}"
    seen, name = f"it is {(*given, '')[0]}", "; the second argument of the integrator"
    expect_that(not given, seen, "it is a function", then=name, cause=called)
    for i, (p, v, a, m) in enumerate(bodies):
        pull = p * -k
        velocity = v + h * (a + (hand + pull) / m)
        slips = {
            "The registry's forces have no effect.": v + h * (a + hand / m),
            "You call update_forces yourself, so the registry's forces act twice.":
                v + h * (a + (hand + 2.0 * pull) / m),
            "Your run_physics clears a force. Only start_frame should clear forces.":
                v + h * (a + pull / m),
            "Only the acceleration has an effect, and all forces are lost.": v + h * a,
            "You move the particles twice. Call only the integrator, not integrate().":
                velocity + h * a,
        }  # fmt: skip
        explicit = "Your world takes an explicit Euler step. Call self.integrator, not integrate()."
        way = velocity if integrator == "semi_implicit_euler" else v
        # A few roundings of numbers of some hundreds.
        for (name, unit), got, wanted, some in zip(
            (("velocity", "m/s"), ("position", "m")),
            done["states"][i][::-1],
            (velocity, p + h * way),
            (slips, {explicit: p + h * v}),
            strict=True,
        ):
            then = f"; particles[{i}].{name}"
            expect_close(got, wanted, some, then=then, unit=unit, tolerance=1e-11)


@pytest.mark.exercise("B8.2", asks="Clear all forces, and move the world", read=STEP)
def test_a_step_clears_earlier_forces(rng: Random) -> None:
    h, force, f = positive_number(rng, 0.05, 0.2), vector(rng), vector(rng)
    p, v, a, m = draw_body(rng)
    with calls("Call start_frame and then run_physics, with the whole duration."):
        particle = Particle(Vector3(*p), Vector3(*v), Vector3(*a), mass=m)
        particle.add_force(Vector3(*force))
        world = ParticleWorld([particle])
        world.step(h)
        got = particle.velocity
    pushed = "Your step doesn't clear the force that was added earlier. Call start_frame before "
    slips = {f"{pushed}run_physics.": v + h * (a + force / m)}
    expect_close(got, v + h * a, slips, unit="m/s", tolerance=1e-12)
    made: list[float] = []
    likely = "Your step does the work of run_physics itself. Call self.run_physics(duration) once "
    likely += "instead, with the whole duration, because a subclass can replace it."
    with calls(likely, f"a world whose run_physics only records the duration; world.step({h})"):
        world = ParticleWorld([Particle()])
        world.run_physics = made.append
        world.step(h)
    seen = f"run_physics is called with {made}" if made else "step does not call run_physics"
    expect_that(made == [h], seen, f"step calls run_physics({h})")
    with calls(
        "run_physics should call the integrator and pass it the forces of the registry.",
        f"a particle of {m} kg with velocity {v} m/s and acceleration {a} m/s^2, to which the "
        f"registry adds the force -Vector3{f}; world.step({h}); particle.velocity",
    ):
        got = frame([(p, v, a, m)], "step", h, f=f)["states"][0][1]
    expect_close(got, v + h * (a - f / m), unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("B8.2", asks="Whenever it needs the forces", read=RUN)
@pytest.mark.parametrize("integrator", ["semi_implicit_euler", "runge_kutta_4"])
def test_the_integrator_asks_for_forces_itself(rng: Random, integrator: str) -> None:
    h, k = positive_number(rng, 0.05, 0.2), positive_number(rng)
    once = "Call self.integrator once in each step, with all particles and the duration."
    text = f"two particles with one force generator each, in a world with integrator={integrator}; "
    text += f"world.run_physics({h})"
    with calls(once, text):
        bodies = [draw_body(rng) for _ in range(2)]
        diary = frame(bodies, "run_physics", h, integrator=integrator, k=k)["diary"]
    asked = [row[1] for row in diary if row[0] == "force"]
    count = 2 * (4 if integrator == "runge_kutta_4" else 1)
    often = "Only pass update_forces to the integrator, which calls it as often as it needs to."
    for name, got, wanted, cause in (
        ("duration and number of particles in each call of the integrator",
         [row[1:] for row in diary if row[0] == "integrator"], [(h, 2)], once),
        ("the number of calls of update_force", len(asked), count, often),
        ("the durations passed to update_force", asked, [h] * count, often),
    ):  # fmt: skip
        expect_exactly(got, wanted, then=f"; {name}", cause=cause)


@pytest.mark.exercise("B8.2", asks="to find the contacts at the new positions", read=RUN)
def test_contacts_are_found_after_the_motion(rng: Random) -> None:
    h, speed = 0.125, float(rng.randint(8, 16))
    v = Triple((2.0, -speed, 0.0))
    why = "The particle should end up on the floor, without its vertical velocity. Collect and "
    why += "resolve the contacts after the integrator has moved the particles."
    text = f"a particle that is 0.5 m above a floor, falls at {speed:g} m/s and moves along X at 2 "
    text += f"m/s; a second one far above; world.run_physics({h})"
    with calls(why, text):
        places = Triple((0.0, 0.5, 0.0)), Triple((5.0, 9.0, 0.0))
        bodies = [(place, v, ZERO, 1.0) for place in places]
        done = frame(bodies, "run_physics", h, floors=[0.0])
    (place, velocity), (_, other) = done["states"]
    inside = "The particle stays inside the floor, because you don't resolve the contacts."
    if any(row[0] == "contacts" and row[2][0] == places[0] for row in done["diary"]):
        inside = "You collect the contacts before the particles move. Collect them afterward."
    alone = "Your step changes the velocity of a particle that has no contact."
    for name, got, wanted, unit, cause in (
        ("particle.position", place, (0.25, 0.0, 0.0), "m",
         named(place, why, {inside: places[0] + h * v})),
        ("particle.velocity", velocity, (2.0, 0.0, 0.0), "m/s", why),
        ("the velocity of the second particle", other, v, "m/s", alone),
    ):  # fmt: skip
        expect_close(got, wanted, then=f"; {name}", unit=unit, cause=cause, tolerance=1e-12)


@pytest.mark.exercise("B8.2", asks="all contacts with one call to the resolver", read=RUN)
def test_all_contacts_are_resolved_at_once(rng: Random) -> None:
    h, (low, high) = 0.125, sorted(float(rng.randint(2, 9)) for _ in range(2))
    bodies = [(Triple((float(i), 1.0, 0.0)), ZERO, ZERO, 1.0) for i in range(3)]
    once = "Collect all contacts in one list, and pass it to a single resolve_contacts."
    text = f"three particles at a height of 1 m; floors at heights of {low:g} and {high:g} m; "
    text += f"world.run_physics({h})"
    with calls(once, text):
        diary = frame(bodies, "run_physics", h, floors=[low, high], record=True)["diary"]
    made = [row for row in diary if row[0] == "resolve"]
    name = "; the number of calls to resolve_contacts"
    expect_exactly(len(made), 1, then=name, unit="calls", cause=once)
    _, duration, depths = made[0]
    whole = f"You pass {duration} s to resolve_contacts. Pass the whole duration."
    then = "; the duration passed to resolve_contacts"
    expect_close(duration, h, then=then, unit="s", tolerance=1e-13 * (high - 1.0), cause=whole)
    then, wanted = "; the penetrations of these contacts", [low - 1.0] * 3 + [high - 1.0] * 3
    expect_close(depths, wanted, then=then, unit="m", cause="Pass those of all generators.")
    asked = [row[1] for row in diary if row[0] == "contacts"]
    then = "; the heights of the floors whose contacts() was called"
    each = "Call contacts() of each generator exactly once in a step."
    expect_exactly(asked, [low, high], then=then, cause=each)
    text = f"three particles at a height of 1 m, above a floor at 0.5 m; world.run_physics({h})"
    with calls("You call the resolver although there are no contacts. Check for that first.", text):
        diary = frame(bodies, "run_physics", h, floors=[0.5], record=True)["diary"]
    count = sum(row[0] == "resolve" for row in diary)
    expect_exactly(count, 0, then=name, unit="calls")


@pytest.mark.exercise(
    "B8.2", asks="no contact is left out", read=f"{CONTACTS}, and the class: there is no maximum"
)
def test_no_contact_is_left_out(rng: Random) -> None:
    count = rng.randint(30, 60)
    with calls(
        "Some particles fell through the ground, because your world doesn't resolve every contact. "
        "The book's world has a maximum number of contacts, but yours has none.",
        f"{count} particles that fall on the ground at the same time; 20 steps of 0.05 s; the "
        "lowest and the largest height of the particles",
    ):
        down = Vector3(0.0, -10.0, 0.0)
        balls = [Particle(Vector3(float(i), 0.25), acceleration=down) for i in range(count)]
        world = ParticleWorld(balls, [Floor(balls, 0.0, [])])
        for _ in range(20):
            world.step(0.05)
        heights = [ball.position.y for ball in balls]
    expect_close((min(heights), max(heights)), (0.0, 0.0), unit="m", tolerance=1e-9)


@pytest.mark.exercise("B8.2", asks="to which you may add later", read=LATER)
def test_a_world_may_get_more_later(rng: Random) -> None:
    h = positive_number(rng, 0.05, 0.2)
    with calls(
        "Your world ignores the particles or the ground that were appended to its lists. Read "
        "self.particles and self.contact_generators again in every step, and resolve the contacts."
    ):
        a, b, c = (Particle(acceleration=Vector3(0.0, -10.0, 0.0)) for _ in range(3))
        world = ParticleWorld([a])
        world.step(h)
        add(world, [b, c], generators=[Floor([c], height=0.0, diary=[])])
        world.step(h)
        got = a.velocity.y, b.velocity.y, c.velocity.y
    expect_close(got, (-20.0 * h, -10.0 * h, 0.0), tolerance=1e-12)
