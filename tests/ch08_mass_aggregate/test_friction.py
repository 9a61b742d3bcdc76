"""Going further, G8.3: Coulomb friction in contacts of particles."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch08_mass_aggregate.friction import FrictionContact
from draw import Triple, number, positive_number, unit_vector, vector
from expect import expect_between, expect_close, expect_unchanged, xyz

SLIDING = "the docstring of FrictionContact.sliding_velocity"
IMPULSE = "the docstring of FrictionContact.friction_impulse"
G, FRAME = 9.81, 1.0 / 60.0
ZERO, UP = Triple((0.0, 0.0, 0.0)), Triple((0.0, 1.0, 0.0))
# Velocities and impulses are below 200, and are rounded in about twenty operations.
NEAR = 1e-11
NO_OTHER = " Here other is None, so leave out vb and 1/mb."
Body = tuple[float, Triple]  # mass, velocity


def draw_body(rng: Random) -> Body:
    return positive_number(rng, 0.5, 5.0), vector(rng)


def contact_of(
    a: Body, b: Body | None, n: Triple, mu: float, cause: str, c: float = 0.0
) -> tuple[Any, list[Any]]:
    """Return a contact of two bodies, or of one and the ground, and its particles."""
    some = [("a", *a), ("b", *b)] if b else [("a", *a)]
    told = "".join(f"{name} = Particle(velocity=Vector3{v}, mass={m}); " for name, m, v in some)
    numbers = f"normal=Vector3{n}, restitution={c}, friction={mu}"
    text = f"{told.replace('=inf', '=math.inf')}contact = FrictionContact(a, {'b' if b else None}, "
    text += f"{numbers})"
    with calls(cause, text):
        made = [Particle(velocity=Vector3(*v), mass=m) for _, m, v in some]
        other = made[1] if b else None
        return FrictionContact(made[0], other, Vector3(*n), c, 0.0, mu), made


@pytest.mark.exercise("G8.3", asks="the part of the relative velocity", read=SLIDING)
@pytest.mark.parametrize("pair", [False, True], ids=["ground", "pair"])
def test_the_sliding_velocity_is_along_the_surface(rng: Random, pair: bool) -> None:
    cause = "Subtract the part along the normal: v - (v . n) n." + NO_OTHER * (not pair)
    for _ in range(3):
        n, a, b = unit_vector(rng), draw_body(rng), draw_body(rng)
        contact, made = contact_of(a, b if pair else None, n, 0.5, cause)
        with calls(cause, more=True):
            got = contact.sliding_velocity()
        v = a[1] - b[1] if pair else a[1]
        wanted = v - n * (v @ n)
        slips = {
            "You return the whole relative velocity. Subtract its part along the normal.": v,
            "You subtract the normal itself. Multiply it by v . n first.": v - n,
            "You return the part along the normal. Subtract it from v.": n * (v @ n),
            "You add the part along the normal instead of subtracting it.": v + n * (v @ n),
            "You leave out the velocity of other. Use va - vb.": a[1] - n * (a[1] @ n),
            "You compute vb - va. The relative velocity is va - vb.": -wanted,
        }
        expect_close(got, wanted, slips, unit="m/s", tolerance=NEAR)
        got.x += 1.0  # a new vector: nothing else may change
        expect_kept(made, (a, b), "Work on a copy, and return a new vector.")


def expect_kept(made: list[Any], bodies: tuple[Body, Body], cause: str) -> None:
    """Expect that the particles have kept their velocities."""
    for name, particle, (_, before) in zip(("particle", "other"), made, bodies, strict=False):
        why = f"The method changes a velocity. {cause}"
        expect_unchanged(f"the velocity of {name}", particle.velocity, before, cause=why)


@pytest.mark.exercise("G8.3", asks="Its size is the smaller one of", read=IMPULSE)
@pytest.mark.parametrize("kind", ["ground", "pair", "immovable other"])
def test_the_friction_impulse_is_limited(rng: Random, kind: str) -> None:
    cause = "The impulse points against the sliding velocity. Its size is the smaller one of mu j "
    cause += "and the impulse that stops the sliding." + NO_OTHER * (kind == "ground")
    for much in (0.1, 0.7, 99.0, 1.5):  # the limit, as a fraction of the impulse that stops
        n, a, b = unit_vector(rng), draw_body(rng), draw_body(rng)
        if kind == "immovable other":
            b = math.inf, b[1]
        other = None if kind == "ground" else b
        whole = a[1] - b[1] if other else a[1]
        v, fast = whole - n * (whole @ n), abs(whole)
        speed, inverse = abs(v), 1.0 / a[0] + (1.0 / b[0] if other else 0.0)
        stop, mu = speed / inverse, positive_number(rng, 0.2, 1.2)
        j, way = much * stop / mu, v / speed
        contact, made = contact_of(a, other, n, mu, cause)
        with calls(cause, more=True):
            got = contact.friction_impulse(j)
        too_much = (
            "This impulse is mu j, the most that friction can do. But friction never does more "
            "than stop the sliding, which takes less here."
            if much > 1.0
            else "This impulse stops the sliding at once. But friction can do no more than mu j, "
            "which is less here."
        )
        wanted, most = way * -min(mu * j, stop), min(mu * j, fast / inverse)
        slips = {
            "Your friction points along the sliding. It must point against the sliding.": -wanted,
            f"{too_much} Return the smaller one of the two.": way * -max(mu * j, stop),
            "You leave out the coefficient of friction. Multiply by mu.": way * -min(j, stop),
            "You multiply both impulses by mu. Only the normal impulse is multiplied by it.":
                way * -mu * min(j, stop),
            "You use the whole relative velocity. Use sliding_velocity().": whole * -most / fast,
            "You use the whole relative speed to stop the body. Use the sliding speed.":
                way * -most,
            "You use the whole relative speed. Use the sliding speed.": v * -most / fast,
            "You multiply by the sliding velocity. Multiply by its direction, a unit vector.":
                v * -mu * j,
            "You compare an impulse with a velocity. Divide the sliding speed by 1/ma + 1/mb.":
                way * -min(mu * j, speed),
            "You use only the mass of particle. Divide s by 1/ma + 1/mb.":
                way * -min(mu * j, a[0] * speed),
            "You multiply the speed by 1/ma + 1/mb. Divide by it.":
                way * -min(mu * j, speed * inverse),
        }  # fmt: skip
        expect_close(got, wanted, slips, unit="N s", tolerance=NEAR)
        expect_kept(made, (a, b), "It should only compute the impulse.")


@pytest.mark.exercise("G8.3", asks="Return zero if the bodies do not slide", read=IMPULSE)
def test_when_there_is_no_friction(rng: Random) -> None:
    (mass, v), size = draw_body(rng), positive_number(rng)
    for a, b, mu, j, cause in (
        ((mass, v), None, 0.0, size, "With mu = 0 there is no friction, so return a zero vector."),
        ((mass, ZERO), None, 0.5, size, "Don't divide by a sliding speed of 0."),
        ((mass, -3.0 * UP), None, 0.5, size, "The body moves only along the normal."),
        ((mass, v), (mass, v), 0.5, size, "Both bodies move together, so they do not slide."),
        ((math.inf, v), (math.inf, ZERO), 0.5, size, "Neither body can move, so 1/ma + 1/mb is 0. "
         "Return a zero vector instead of dividing by it."),
        ((math.inf, v), None, 0.5, size, "The particle is immovable, so return a zero vector."),
        ((mass, v), None, 0.5, 0.0, "Without a normal impulse there is no friction."),
    ):  # fmt: skip
        contact, _ = contact_of(a, b, UP, mu, cause)
        with calls(cause, more=True):
            got = contact.friction_impulse(j)
        expect_close(got, ZERO, unit="N s", tolerance=0.0)


def slid(n: Triple, gravity: Triple, v: Triple, mass: float, mu: float, steps: int) -> Any:
    """Return position and velocity after each step of a particle that slides on a plane."""
    seen, particle = [], Particle(velocity=Vector3(*v), acceleration=Vector3(*gravity), mass=mass)
    for _ in range(steps):
        semi_implicit_euler([particle], lambda _: None, FRAME)
        depth = -(n @ xyz(particle.position))
        if depth >= 0.0:
            FrictionContact(particle, None, Vector3(*n), 0.0, depth, mu).resolve(FRAME)
        seen.append((Triple(xyz(particle.position)), Triple(xyz(particle.velocity))))
    return seen


@pytest.mark.exercise("G8.3", asks="A body at rest therefore sticks", read=IMPULSE)
@pytest.mark.parametrize("tilted", ["gravity", "plane"])
def test_a_slope_holds_up_to_the_angle_of_friction(rng: Random, tilted: str) -> None:
    mu, mass = positive_number(rng, 0.2, 0.9), positive_number(rng, 0.5, 5.0)
    limit, h, steps = math.degrees(math.atan(mu)), FRAME, 90
    for degrees in (limit - 8.0, limit - 0.5, limit + 0.5, limit + 12.0):
        sin, cos = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
        normal, down, gravity = UP, Triple((1.0, 0.0, 0.0)), G * Triple((sin, -cos, 0.0))
        if tilted == "plane":
            normal, down, gravity = Triple((sin, cos, 0.0)), Triple((cos, -sin, 0.0)), -G * UP
        rate = max(0.0, G * (sin - mu * cos))
        with calls(
            "The slope is steeper than the angle of friction, so the body must slide with the "
            "acceleration g (sin(theta) - mu cos(theta))."
            if rate
            else "The slope is less steep than the angle of friction, so the body must stick.",
            f"a body of {mass:g} kg starts at rest on a slope of {degrees:.4g} degrees, with "
            f"{mu=}, whose angle of friction is {limit:.4g} degrees; 90 steps",
        ):
            where, velocity = slid(normal, gravity, ZERO, mass, mu, steps)[-1]
        slips = {
            "The body slides as if there were no friction.": G * sin * steps * h,
            "Your friction pushes the body down the slope.": G * (sin + mu * cos) * steps * h,
        }
        # 90 steps of rounding, at speeds below 15 m/s.
        name = "; its speed down the slope"
        wanted = rate * steps * h
        expect_close(velocity @ down, wanted, slips, then=name, unit="m/s", tolerance=NEAR)
        # Semi-implicit Euler moves by rate h^2 (1 + 2 + ... + steps).
        far = rate * h * h * steps * (steps + 1) / 2.0
        expect_close(where @ down, far, then="; its displacement", unit="m", tolerance=NEAR)


@pytest.mark.exercise("G8.3", asks="never does more than stop the sliding", read=IMPULSE)
def test_friction_stops_a_body_on_level_ground(rng: Random) -> None:
    """Only here friction must bring a moving body to rest at the right time, and leave it there."""
    mu, speed, h = positive_number(rng, 0.3, 0.8), positive_number(rng, 2.0, 5.0), FRAME
    across, mass = rng.uniform(0.0, math.tau), positive_number(rng, 0.5, 5.0)
    way = Triple((math.cos(across), 0.0, math.sin(across)))
    steps = math.ceil(speed / (mu * G * h)) + 10
    slows = "On level ground, friction slows a body down by mu g, whatever its mass."
    text = f"a body slides at {speed:g} m/s on level ground, with {mu=}; its velocity along its "
    text += "direction"
    with calls(slows, text):
        seen = slid(UP, -G * UP, way * speed, mass, mu, steps)
    for i, (_, velocity) in enumerate(seen, 1):
        wanted = max(0.0, speed - mu * G * i * h)
        why = slows if wanted else "Friction stops a body, but must not push it back."
        name = f" after step {i}"
        expect_close(way @ velocity, wanted, then=name, cause=why, unit="m/s", tolerance=NEAR)


@pytest.mark.exercise("G8.3", asks="at most mu times the normal impulse", read=IMPULSE)
def test_an_impact_of_two_bodies_with_friction(rng: Random) -> None:
    """Only here two bodies get both impulses, and must keep their momentum."""
    for mu in (0.0, 0.1, 3.0):
        n, c = unit_vector(rng), positive_number(rng, 0.1, 0.9)
        (ma, v), (mb, w), closing = draw_body(rng), draw_body(rng), -abs(number(rng, 1.0, 5.0))
        slip = (v - w) - n * ((v - w) @ n)
        v = w + slip + n * closing  # they approach at this speed
        both = "The friction impulse acts on particle, and its opposite on other."
        contact, made = contact_of((ma, v), (mb, w), n, mu, both, c)
        with calls(both, more=True):
            contact.resolve_velocity()
        one, two = (Triple(xyz(particle.velocity)) for particle in made)
        apart, slowed = one - two, mu * -(1.0 + c) * closing
        for name, got, wanted, unit, cause in (
            ("the momentum of both", ma * one + mb * two, ma * v + mb * w, "kg m/s", both),
            ("the sliding speed", apart @ slip / abs(slip), max(0.0, abs(slip) - slowed), "m/s",
             "An impact reduces the sliding speed by mu j (1/ma + 1/mb), but not below 0."),
            ("the separating velocity", apart @ n, -c * closing, "m/s",
             "Friction must not change the velocity along the normal."),
        ):  # fmt: skip
            expect_close(got, wanted, then=f"; {name}", cause=cause, unit=unit, tolerance=NEAR)
        before, after = (0.5 * ma * (p @ p) + 0.5 * mb * (q @ q) for p, q in ((v, w), (one, two)))
        name, why = "; the gain of kinetic energy", "Friction must not add kinetic energy."
        expect_between(after - before, -math.inf, NEAR, then=name, unit="J", cause=why)
