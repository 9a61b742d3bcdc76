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
    started,
    told_frame,
)
from draw import components, dot, positive_number
from expect import about, blame, cause_of, expect_close, expect_exactly, expect_that

ZERO = (0.0, 0.0, 0.0)
ENERGY = "the docstring of mechanical_energy"
WORLD = "book 8.1, and the docstring of ParticleWorld."


def draw_body(rng: Random) -> Body:
    return components(rng), components(rng), components(rng), positive_number(rng)


@pytest.mark.exercise("B8.1", asks="The result is the sum of m v^2 / 2 - m a . p")
def test_energy_is_kinetic_plus_potential(rng: Random) -> None:
    about.read = ENERGY
    bodies = [draw_body(rng) for _ in range(3)]
    parts = [0.5 * m * dot(v, v) - m * dot(a, p) for p, v, a, m in bodies]
    simple = ((0.0, 3.0, 0.0), (4.0, 0.0, 0.0), (0.0, -10.0, 0.0), 2.0)
    about.call = "a particle of 2 kg at (0, 3, 0) m, with velocity (4, 0, 0) m/s and acceleration "
    about.call += "(0, -10, 0) m/s^2; mechanical_energy([particle])"
    got = energy_of([simple])
    mistakes = [
        (16.0, "You return the kinetic energy alone. Add the potential energy, which is m g y = 60 "
               "J here."),
        (60.0, "You return the potential energy alone. Add the kinetic energy, which is m v^2 / 2 "
               "= 16 J here."),
        (-44.0, "Your potential energy has the wrong sign. It is minus the mass times the scalar "
                "product of acceleration and position."),
        (74.86, "You use 9.81 m/s^2 for gravity, but this particle accelerates at 10 m/s^2. Use "
                "particle.acceleration instead."),
        (92.0, "Your kinetic energy is twice as large as it should be, so you probably left out "
               "the factor 1/2. It is m v^2 / 2."),
        (38.0, "You leave the mass out of both energies. Multiply each of them by the mass."),
        (46.0, "You leave the mass out of the potential energy. Multiply the scalar product of "
               "acceleration and position by the mass."),
    ]  # fmt: skip
    about.cause = "The energy is the sum of m v^2 / 2 and m g y. Here the kinetic energy is 16 J "
    about.cause += "and the potential energy is 60 J."
    blame(got, mistakes)
    expect_close(got, 76.0, unit="J")
    about.cause = "The energy of one particle is m v^2 / 2 - m a . p. Compute it for each "
    about.cause += "particle, and return the sum."
    for name, some, wanted in (
        ("one particle", bodies[:1], parts[0]),
        ("three particles", bodies, math.fsum(parts)),
    ):
        bodies_in_words = "; ".join(
            f"{m} kg at {p} m, with velocity {v} m/s and acceleration {a} m/s^2"
            for p, v, a, m in some
        )
        about.call = f"{name}: {bodies_in_words}; mechanical_energy of all of them"
        got = energy_of(some)
        first = "Your loop returns after the first particle. Return the sum after the loop."
        about.cause = cause_of(got, [(parts[0], first)], about.cause)
        # Rounding of terms of some hundreds of J.
        expect_close(got, wanted, unit="J", tolerance=1e-10)
    p, v, a, m = bodies[0]
    about.call = f"a particle of {m} kg at {p} m, with velocity {v} m/s; its acceleration is {a} "
    about.call += "m/s^2, and a force acts on it as well; mechanical_energy([particle])"
    about.cause = "Your potential energy includes the force that acts on the particle. Use only "
    about.cause += "particle.acceleration, which doesn't include forces."
    got = energy_of(bodies[:1], components(rng))
    expect_close(got, parts[0], unit="J", tolerance=1e-10)


@pytest.mark.exercise("B8.1", asks="and neither do immovable particles")
def test_immovable_particles_have_no_energy(rng: Random) -> None:
    about.read = ENERGY
    p, v, a, m = draw_body(rng)
    about.cause = "You count the immovable particle, whose mass is infinite. Skip every particle "
    about.cause += "whose inverse_mass is 0."
    wanted = 0.5 * m * dot(v, v) - m * dot(a, p)
    for first, call in (
        (True, "mechanical_energy([a movable particle, an immovable particle])"),
        (False, "mechanical_energy([an immovable particle, a movable particle])"),
    ):
        about.call = call
        both = [(p, v, a, m), (components(rng), ZERO, components(rng), math.inf)]
        got = energy_of(both if first else both[::-1])
        stops = "Your loop stops at the immovable particle. Skip it and continue with the next one."
        about.cause = cause_of(got, [(0.0, stops)], about.cause)
        expect_close(got, wanted, unit="J", tolerance=1e-10)
    about.call = "mechanical_energy([])"
    about.cause = "There are no particles, so the total energy is 0. Return 0."
    expect_close(energy_of([]), 0.0, tolerance=0.0)


@pytest.mark.exercise("B8.2", asks="the force accumulators of all particles")
def test_starting_a_frame_clears_the_accumulators(rng: Random) -> None:
    about.read = f"{WORLD}start_frame"
    bodies = [draw_body(rng) for _ in range(3)]
    bodies.insert(1, (components(rng), ZERO, ZERO, math.inf))
    force = components(rng)
    about.call = "a world of four particles, of which particles[1] is immovable; "
    about.call += f"add_force(Vector3{force}) for each of them; world.start_frame()"
    about.cause = "start_frame doesn't clear any forces. Call clear_forces() for every particle, "
    about.cause += "with the parentheses, because without them Python doesn't call the method."
    done = started(bodies, force)
    kept = [i for i in range(4) if done["after"][i] != ZERO]
    if 0 < len(kept) < 4:
        about.cause = "start_frame doesn't clear the forces of all particles. Call clear_forces() "
        about.cause += "for every particle."
        if kept == [1]:
            about.cause = "You skip the immovable particle. Call clear_forces() for it too."
    only = "Your start_frame changes the position or the velocity of a particle. It should only "
    only += "call clear_forces() for each particle."
    for i, (place, velocity, *_) in enumerate(bodies):
        name = f"{about.call}; particles[{i}].force_accumulator"
        expect_close(done["after"][i], ZERO, call=name, unit="N", tolerance=0.0)
        name = f"{about.call}; particles[{i}].position"
        got = done["states"][i]
        expect_close(got[0], place, call=name, cause=only, unit="m", tolerance=0.0)
        name = f"{about.call}; particles[{i}].velocity"
        expect_close(got[1], velocity, call=name, cause=only, unit="m/s", tolerance=0.0)


@pytest.mark.exercise("B8.2", asks="in the order of the generators")
def test_contacts_of_every_generator_are_returned(rng: Random) -> None:
    about.read = f"{WORLD}contacts"
    count = rng.randint(150, 300)
    low, high = sorted(float(rng.randint(2, 9)) for _ in range(2))
    about.call = f"{count} particles at a height of 1 m; floors at heights of 0, 1, {low:g} and "
    about.call += f"{high:g} m; world.contacts()"
    wanted = [0.0] * count + [low - 1.0] * count + [high - 1.0] * count
    about.cause = "Call contacts() of each generator, with the parentheses, and put all contacts "
    about.cause += "into one list."
    got = depths_of(count, [0.0, 1.0, low, high])
    nested = "Your contacts() returns a separate list for each floor. Put the contacts of all "
    nested += "floors into one list."
    expect_that("a list" not in got, "a list of lists", "one list of contacts", cause=nested)
    about.cause = f"You return only {len(got)} contacts. The book's world has a maximum number of "
    about.cause += "contacts, but yours should return all of them."
    if len(got) > 3 * count:
        about.cause = "You return some contacts more than once. Call each contacts() once."
    first = "Your loop ends after the first floor, which touches no particle. Continue with the "
    first += "other floors."
    only = f"You return the contacts of only {len(got) // count} of the 3 floors that touch the "
    only += "particles. Collect the contacts of all generators before you return."
    seen = cause_of(len(got), [(0, first), (count, only), (2 * count, only)], about.cause)
    expect_exactly(len(got), 3 * count, unit="contacts", cause=seen)
    order = "Your contacts are in the wrong order. Go through contact_generators from first to "
    order += "last, and append the contacts of each."
    runs = [round(depth, 9) for depth in got[::count]]
    name = "; the penetrations at the floors that touch particles, in list order"
    expect_exactly(runs, [0.0, low - 1.0, high - 1.0], then=name, unit="m", cause=order)
    expect_close(got, wanted)
    about.call = "a world without contact generators; world.contacts()"
    about.cause = "Without generators there are no contacts, so return an empty list."
    expect_exactly(depths_of(count, []), [])


@pytest.mark.exercise("B8.2", asks="First let the integrator move the particles")
@pytest.mark.parametrize("integrator", ["explicit_euler", "semi_implicit_euler"])
def test_a_frame_moves_by_forces_and_gravity(rng: Random, integrator: str) -> None:
    about.read = f"{WORLD}run_physics"
    h, k = positive_number(rng, 0.05, 0.2), positive_number(rng)
    hand = components(rng)
    bodies = [draw_body(rng) for _ in range(2)]
    about.cause = "Call self.integrator(self.particles, self.registry.update_forces, duration). "
    about.cause += "Forces that were added after start_frame must still be there, so don't clear "
    about.cause += "them in run_physics."
    about.call = f"two particles in a world with integrator={integrator}; a force generator in the "
    about.call += f"registry adds -{k} N/m * position to each; world.start_frame(); "
    about.call += f"add_force(Vector3{hand}) for both; world.run_physics({h})"
    done = frame(bodies, "run_physics", h, integrator=integrator, k=k, late=hand)
    given = [row[1] for row in done["diary"] if row[0] == "no function"]
    called = "You called update_forces, and passed on what it returned. Pass the function itself, "
    called += "self.registry.update_forces, without parentheses."
    called = called if given == ["None"] else f"The order of the arguments is wrong. {about.cause}"
    seen, name = f"it is {(*given, '')[0]}", "; the second argument of the integrator"
    expect_that(not given, seen, "it is a function", then=name, cause=called)
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
                (1.0, 0.0, "The registry's forces have no effect. Pass "
                 "self.registry.update_forces to the integrator."),
                (1.0, 2.0, "You call update_forces yourself, so the registry's forces act twice. "
                           "Pass update_forces to the integrator, but don't call it."),
                (0.0, 1.0, "run_physics clears the force that was added after start_frame. Only "
                           "start_frame should clear forces."),
                (0.0, 0.0, "Only the acceleration has an effect, and all forces are lost. Pass "
                           "self.registry.update_forces to the integrator, and don't clear the "
                           "forces in run_physics."),
            )
        ]  # fmt: skip
        twice = "You move the particles twice, with the integrator and with integrate(). Call only "
        twice += "the integrator."
        mistakes.append(([v[j] + (push[j] + a[j]) * h for j in range(3)], twice))
        blame(got[1], mistakes)
        # A few roundings of numbers of some hundreds.
        expect_close(got[1], velocity, call=f"{name}.velocity", unit="m/s", tolerance=1e-11)
        other = [p[j] + v[j] * h for j in range(3)]
        seen = "Your world takes an explicit Euler step, as particle.integrate does. Call "
        seen += f"self.integrator instead, which is {integrator} here."
        blame(got[0], [(other, seen)])
        expect_close(got[0], place, call=f"{name}.position", unit="m", tolerance=1e-11)


@pytest.mark.exercise("B8.2", asks="Clear all forces, and move the world")
def test_a_step_clears_earlier_forces(rng: Random) -> None:
    h, force = positive_number(rng, 0.05, 0.2), components(rng)
    p, v, a, m = draw_body(rng)
    about(
        f"a particle with velocity {v} m/s and acceleration {a} m/s^2; "
        f"particle.add_force(Vector3{force}); world.step({h})",
        read=f"{WORLD}step",
    )
    about.cause = "Call start_frame and then run_physics, with the whole duration."
    done = frame([(p, v, a, m)], "step", h, early=force)
    velocity = [v[j] + a[j] * h for j in range(3)]
    got = done["states"][0][1]
    pushed = [v[j] + (a[j] + force[j] / m) * h for j in range(3)]
    seen = "Your step doesn't clear the force that was added earlier. Call start_frame before "
    blame(got, [(pushed, f"{seen}run_physics.")])
    expect_close(got, velocity, then="; particle.velocity", unit="m/s", tolerance=1e-12)
    about.call = "a subclass of ParticleWorld that only records calls of run_physics; "
    about.call += f"world.step({h})"
    about.cause = "Your step does the work of run_physics itself. Call self.run_physics(duration) "
    about.cause += "instead, because a subclass can replace it."
    calls = told_frame(h)
    seen = f"calls of {calls}" if calls else "step does not call run_physics"
    if calls:
        about.cause = "Call self.run_physics(duration) once, with the whole duration."
    expect_that(calls == [("run_physics", h)], seen, f"step calls run_physics({h})")
    about.cause = "run_physics should call the integrator and pass it the forces of the registry."
    f = components(rng)
    about.call = f"a particle of {m} kg with velocity {v} m/s and acceleration {a} m/s^2, to which "
    about.call += f"the registry adds the force -Vector3{f}; world.step({h})"
    done = frame([(p, v, a, m)], "step", h, f=f)
    velocity = [v[j] + (a[j] - f[j] / m) * h for j in range(3)]
    got = done["states"][0][1]
    expect_close(got, velocity, then="; particle.velocity", unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("B8.2", asks="Whenever it needs the forces")
@pytest.mark.parametrize("integrator", ["semi_implicit_euler", "runge_kutta_4"])
def test_the_integrator_asks_for_forces_itself(rng: Random, integrator: str) -> None:
    about.read = f"{WORLD}run_physics"
    h, k = positive_number(rng, 0.05, 0.2), positive_number(rng)
    bodies = [draw_body(rng) for _ in range(2)]
    evaluations = 4 if integrator == "runge_kutta_4" else 1
    about.call = "two particles with one force generator each, in a world with "
    about.call += f"integrator={integrator}; world.run_physics({h})"
    about.cause = "Call self.integrator exactly once in each step. Pass it all particles and the "
    about.cause += "whole duration."
    done = frame(bodies, "run_physics", h, integrator=integrator, k=k)
    asked = [row[1:] for row in done["diary"] if row[0] == "integrator"]
    name = f"{about.call}: duration and number of particles in each call of the integrator"
    expect_exactly(asked, [(h, 2)], call=name)
    about.cause = "The forces are evaluated at the wrong times. Only pass update_forces to the "
    about.cause += "integrator, which calls it as often as it needs the forces."
    count = sum(row[0] == "force" for row in done["diary"])
    expect_exactly(count, 2 * evaluations, then="; the calls of update_force", unit="calls")
    asked = [row[1] for row in done["diary"] if row[0] == "force"]
    expect_exactly(asked, [h] * count, then="; the durations passed to update_force")


@pytest.mark.exercise("B8.2", asks="to find the contacts at the new positions")
def test_contacts_are_found_after_the_motion(rng: Random) -> None:
    about.read = f"{WORLD}run_physics"
    h = 0.125
    speed = float(rng.randint(8, 16))
    bodies: list[Body] = [
        ((0.0, 0.5, 0.0), (2.0, -speed, 0.0), ZERO, 1.0),
        ((5.0, 9.0, 0.0), (2.0, -speed, 0.0), ZERO, 1.0),
    ]
    about.call = f"a particle that is 0.5 m above a floor, falls at {speed:g} m/s and moves along "
    about.call += f"X at 2 m/s; world.run_physics({h})"
    about.cause = "The particle should end up on the floor, without its vertical velocity. Collect "
    about.cause += "and resolve the contacts after the integrator has moved the particles."
    done = frame(bodies, "run_physics", h, floors=[0.0])
    place, velocity = done["states"][0]
    fallen = 0.5 - speed * h
    inside = "The particle stays inside the floor, because you don't resolve the contacts. Pass "
    inside += "them to self.resolver.resolve_contacts."
    if any(row[0] == "contacts" and row[2][0] == (0.0, 0.5, 0.0) for row in done["diary"]):
        inside = "You collect the contacts before the particles move, so you miss the one with the "
        inside += "floor. Collect them after the integrator has moved the particles."
    seen = cause_of(place, [((0.25, fallen, 0.0), inside)], about.cause)
    name = f"{about.call}; particle.position"
    expect_close(place, (0.25, 0.0, 0.0), call=name, cause=seen, unit="m", tolerance=1e-12)
    name = f"{about.call}; particle.velocity"
    expect_close(velocity, (2.0, 0.0, 0.0), call=name, unit="m/s", tolerance=1e-12)
    about.cause = "Your step changes the velocity of a particle that has no contact. Resolve only "
    about.cause += "the contacts, and leave all other particles alone."
    got = done["states"][1][1]
    name = f"{about.call}; the velocity of a second particle, far above"
    expect_close(got, (2.0, -speed, 0.0), call=name, unit="m/s", tolerance=1e-12)


@pytest.mark.exercise("B8.2", asks="all contacts with one call to the resolver")
def test_all_contacts_are_resolved_at_once(rng: Random) -> None:
    about.read = f"{WORLD}run_physics"
    h = 0.125
    low, high = sorted(float(rng.randint(2, 9)) for _ in range(2))
    bodies: list[Body] = [((float(i), 1.0, 0.0), ZERO, ZERO, 1.0) for i in range(3)]
    about.call = f"three particles at a height of 1 m; floors at heights of {low:g} and {high:g} "
    about.call += f"m; world.run_physics({h})"
    about.cause = "You call resolve_contacts several times. Collect all contacts in one list, and "
    about.cause += "pass this list in a single call."
    done = frame(bodies, "run_physics", h, floors=[low, high], record=True)
    calls = [row for row in done["diary"] if row[0] == "resolve"]
    if not calls:
        about.cause = "You don't call self.resolver.resolve_contacts. Pass it all contacts."
    expect_exactly(len(calls), 1, then="; the number of calls to resolve_contacts", unit="calls")
    depths = [low - 1.0] * 3 + [high - 1.0] * 3
    about.cause = f"You pass {calls[0][1]} s to resolve_contacts, but the step takes {h} s. Pass "
    about.cause += "the whole duration."
    name = f"{about.call}; the duration passed to resolve_contacts"
    expect_close(calls[0][1], h, call=name, unit="s", tolerance=1e-13 * (high - 1.0))
    about.cause = "You pass the wrong contacts to the resolver. Pass those of all generators."
    name = f"{about.call}; the penetrations of the contacts passed to resolve_contacts"
    expect_close(calls[0][2], depths, call=name, unit="m")
    about.cause = "Call contacts() of each generator exactly once in a step."
    asked = [row[1] for row in done["diary"] if row[0] == "contacts"]
    name = "; the heights of the floors whose contacts() was called"
    expect_exactly(asked, [low, high], then=name)
    about.call = "three particles at a height of 1 m, above a floor at 0.5 m; "
    about.call += f"world.run_physics({h})"
    about.cause = "You call the resolver although there are no contacts. Call resolve_contacts "
    about.cause += "only if the list of contacts is not empty."
    done = frame(bodies, "run_physics", h, floors=[0.5], record=True)
    count = sum(row[0] == "resolve" for row in done["diary"])
    expect_exactly(count, 0, then="; the number of calls to resolve_contacts", unit="calls")


@pytest.mark.exercise("B8.2", asks="no contact is left out")
def test_no_contact_is_left_out(rng: Random) -> None:
    about.read = f"{WORLD}contacts, and the class: there is no maximum"
    count = rng.randint(30, 60)
    about.call = f"{count} particles that fall on the ground at the same time; 20 steps of 0.05 s; "
    about.call += "the lowest and the largest height of the particles"
    about.cause = "Some particles fell through the ground, because your world doesn't resolve "
    about.cause += "every contact. The book's world stops at a maximum number of contacts, but "
    about.cause += "yours should resolve them all."
    heights = rained(count, 0.05, 20)
    expect_close((min(heights), max(heights)), (0.0, 0.0), unit="m", tolerance=1e-9)


@pytest.mark.exercise("B8.2", asks="to which you may add later")
def test_a_world_may_get_more_later(rng: Random) -> None:
    about.read = "the docstring of ParticleWorld: its lists may be appended to"
    h = positive_number(rng, 0.05, 0.2)
    about.call = f"a world with one falling particle; world.step({h}); then two more particles are "
    about.call += "appended to world.particles, and a ground below the third one to "
    about.call += f"world.contact_generators; world.step({h}); the vertical velocities of the "
    about.call += "three particles"
    about.cause = "Your world ignores the particles or the ground that were appended to its lists. "
    about.cause += "Read self.particles and self.contact_generators again in every step, and "
    about.cause += "resolve the contacts."
    got = [velocity[1] for _, velocity in appended(h)]
    wanted = (-20.0 * h, -10.0 * h, 0.0)
    expect_close(got, wanted, tolerance=1e-12)
