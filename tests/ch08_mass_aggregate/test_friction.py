"""Going further, G8.3: Coulomb friction in contacts of particles."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch08_mass_aggregate.rough_probes import bounced, impulse, slid, sliding
from draw import Components, components, direction, dot, number, positive_number, rounded
from expect import about, blame, expect_between, expect_close, expect_unchanged

SLIDING = "the docstring of FrictionContact.sliding_velocity"
IMPULSE = "the docstring of FrictionContact.friction_impulse"
G = 9.81  # m/s^2
ZERO = (0.0, 0.0, 0.0)
# Velocities and impulses are below 200, and are rounded in about twenty operations.
NEAR = 1e-11
Body = tuple[float, Components]


def plus(a: Components, b: Components, share: float = 1.0) -> Components:
    """Return a + share b."""
    x, y, z = (p + share * q for p, q in zip(a, b, strict=True))
    return x, y, z


def along(v: Components, n: Components) -> Components:
    """Return the part of v at a right angle to the unit vector n."""
    return plus(v, n, -dot(v, n))


def draw_body(rng: Random) -> Body:
    return positive_number(rng, 0.5, 5.0), components(rng)


def called(a: Body, b: Body | None, n: Components) -> str:
    """Return what is called, up to the method: a contact of these bodies."""
    first = f"a particle of {a[0]:g} kg at {rounded(a[1])} m/s, and "
    second = f"other of {b[0]:g} kg at {rounded(b[1])} m/s" if b else "no other"
    return f"{first}{second}; the normal is {rounded(n)}; "


@pytest.mark.exercise("G8.3", asks="the part of the relative velocity")
@pytest.mark.parametrize("pair", [False, True], ids=["ground", "pair"])
def test_the_sliding_velocity_is_along_the_surface(rng: Random, pair: bool) -> None:
    about.read = SLIDING
    for _ in range(3):
        n, a, b = direction(rng), draw_body(rng), draw_body(rng)
        v = plus(a[1], b[1], -1.0) if pair else a[1]
        wanted = along(v, n)
        about.call = called(a, b if pair else None, n) + "contact.sliding_velocity()"
        about.cause = "Subtract the part along the normal: v - (v . n) n."
        if not pair:
            about.cause += " Here other is None, so v is the velocity of particle."
        got, after = sliding(a, b if pair else None, n)
        mistakes = [
            (v, "You return the whole relative velocity. Subtract its part along the normal."),
            (plus(v, n, -1.0), "You subtract the normal itself. Multiply it by v . n first."),
            (plus(ZERO, n, dot(v, n)), "You return the part along the normal. Subtract it from v."),
            (plus(v, n, dot(v, n)), "You add the part along the normal instead of subtracting it."),
            (along(a[1], n), "You leave out the velocity of other."),
            (plus(ZERO, wanted, -1.0), "You compute vb - va. The relative velocity is va - vb."),
        ]
        blame(got, mistakes)
        expect_close(got, wanted, unit="m/s", tolerance=NEAR)
        about.cause = "The method changes a velocity. Work on a copy, and return a new vector."
        for name, (_, before), now in zip(("particle", "other"), (a, b), after, strict=False):
            expect_unchanged(f"the velocity of {name}", now, before)


@pytest.mark.exercise("G8.3", asks="Its size is the smaller one of")
@pytest.mark.parametrize("kind", ["ground", "pair", "immovable other"])
def test_the_friction_impulse_is_limited(rng: Random, kind: str) -> None:
    about.read = IMPULSE
    for much in (0.1, 0.7, 99.0, 1.5):  # the limit, as a fraction of the impulse that stops
        n, a, b = direction(rng), draw_body(rng), draw_body(rng)
        if kind == "immovable other":
            b = math.inf, b[1]
        other = None if kind == "ground" else b
        whole = plus(a[1], b[1], -1.0) if other else a[1]
        v, fast = along(whole, n), math.hypot(*whole)
        speed, inverse = math.hypot(*v), 1.0 / a[0] + (1.0 / b[0] if other else 0.0)
        stop, mu = speed / inverse, positive_number(rng, 0.2, 1.2)
        j = much * stop / mu
        size = min(mu * j, stop)
        wanted = plus(ZERO, v, -size / speed)
        about.call = called(a, other, n) + f"{mu=}; contact.friction_impulse({j!r})"
        about.cause = "The impulse points against the sliding velocity. Its size is the smaller "
        about.cause += "one of mu j and the impulse that stops the sliding."
        if not other:
            about.cause += " Here other is None, so leave out 1/mb."
        got, after = impulse(a, other, n, mu, j)
        either = max(mu * j, stop)
        too_much = (
            "This impulse is mu j, the most that friction can do. But friction never does more "
            "than stop the sliding, which takes less here. Return the smaller one of the two."
            if much > 1.0
            else "This impulse stops the sliding at once. But friction can do no more than mu j, "
            "which is less here. Return the smaller one of the two."
        )
        mistakes = [
            (plus(ZERO, wanted, -1.0), "Your friction pushes the particle in the direction in "
                                       "which it slides. It must point against the sliding."),
            (plus(ZERO, v, -either / speed), too_much),
            (plus(ZERO, v, -min(j, stop) / speed), "You leave out the coefficient of friction."),
            (plus(ZERO, v, -mu * min(j, stop) / speed),
             "You multiply both impulses by mu. Only the normal impulse is multiplied by it."),
            (plus(ZERO, whole, -min(mu * j, fast / inverse) / fast),
             "You use the whole relative velocity. Friction acts only along the surface, so use "
             "sliding_velocity()."),
            (plus(ZERO, v, -min(mu * j, fast / inverse) / speed),
             "You use the whole relative speed to stop the body. Use the sliding speed, the "
             "magnitude of sliding_velocity()."),
            (plus(ZERO, v, -min(mu * j, fast / inverse) / fast),
             "You use the whole relative speed. Use the sliding speed, the magnitude of "
             "sliding_velocity()."),
            (plus(ZERO, v, -mu * j), "You multiply by the sliding velocity. Multiply by its "
                                     "direction, a unit vector."),
            (plus(ZERO, v, -min(mu * j, speed) / speed),
             "You compare an impulse with a velocity. The impulse that stops the sliding is the "
             "sliding speed divided by 1/ma + 1/mb."),
            (plus(ZERO, v, -min(mu * j, a[0] * speed) / speed),
             "You use only the mass of particle. If other can move too, the impulse that stops the "
             "sliding is s / (1/ma + 1/mb)."),
            (plus(ZERO, v, -min(mu * j, speed * inverse) / speed),
             "You multiply the speed by 1/ma + 1/mb. Divide by it."),
        ]  # fmt: skip
        blame(got, mistakes)
        expect_close(got, wanted, unit="N s", tolerance=NEAR)
        about.cause = "friction_impulse() changes a velocity. It should only compute the impulse."
        for name, (_, before), now in zip(("particle", "other"), (a, b), after, strict=False):
            expect_unchanged(f"the velocity of {name}", now, before)


@pytest.mark.exercise("G8.3", asks="Return zero if the bodies do not slide")
def test_when_there_is_no_friction(rng: Random) -> None:
    about.read = IMPULSE
    n, (mass, v), j = (0.0, 1.0, 0.0), draw_body(rng), positive_number(rng)
    for a, b, mu, cause in (
        ((mass, v), None, 0.0, "With mu = 0 there is no friction, so return a zero vector."),
        ((mass, ZERO), None, 0.5, "A body that does not slide gets no impulse. Don't divide by its "
                                  "speed of 0."),
        ((mass, (0.0, -3.0, 0.0)), None, 0.5, "The body moves only along the normal, so it does "
                                              "not slide. Return a zero vector."),
        ((mass, v), (mass, v), 0.5, "Both bodies move together, so they do not slide."),
        ((math.inf, v), (math.inf, ZERO), 0.5, "Neither body can move, so 1/ma + 1/mb is 0. Return "
                                               "a zero vector instead of dividing by it."),
        ((math.inf, v), None, 0.5, "The particle is immovable, so return a zero vector."),
    ):  # fmt: skip
        about(called(a, b, n) + f"{mu=}; contact.friction_impulse({j})", cause=cause)
        got, _ = impulse(a, b, n, mu, j)
        expect_close(got, ZERO, unit="N s", tolerance=0.0)
    about(called((mass, v), None, n) + "mu=0.5; contact.friction_impulse(0.0)")
    about.cause = "Without a normal impulse there is no friction."
    got, _ = impulse((mass, v), None, n, 0.5, 0.0)
    expect_close(got, ZERO, unit="N s", tolerance=0.0)


@pytest.mark.exercise("G8.3", asks="A body at rest therefore sticks")
@pytest.mark.parametrize("tilted", ["gravity", "plane"])
def test_a_slope_holds_up_to_the_angle_of_friction(rng: Random, tilted: str) -> None:
    about.read = IMPULSE
    mu, mass = positive_number(rng, 0.2, 0.9), positive_number(rng, 0.5, 5.0)
    limit = math.degrees(math.atan(mu))
    for degrees in (limit - 8.0, limit - 0.5, limit + 0.5, limit + 12.0):
        angle, h, steps = math.radians(degrees), 1.0 / 60.0, 90
        sin, cos = math.sin(angle), math.cos(angle)
        normal, down = (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)
        gravity = (G * sin, -G * cos, 0.0)
        if tilted == "plane":
            normal, down, gravity = (sin, cos, 0.0), (cos, -sin, 0.0), (0.0, -G, 0.0)
        about.call = f"a body of {mass:g} kg starts at rest on a slope of {degrees:.4g} degrees, "
        about.call += f"with {mu=}, whose angle of friction is {limit:.4g} degrees; 90 steps"
        where, velocity = slid(normal, gravity, ZERO, mass, mu, steps, h)[-1]
        rate = max(0.0, G * (sin - mu * cos))
        about.cause = "The slope is less steep than the angle of friction, so the body must stick."
        if rate:
            about.cause = "The slope is steeper than the angle of friction, so the body must slide "
            about.cause += "with the acceleration g (sin(theta) - mu cos(theta))."
        blame(dot(velocity, down), [
            (G * sin * steps * h, "The body slides as if there were no friction."),
            (G * (sin + mu * cos) * steps * h, "Your friction pushes the body down the slope."),
        ])  # fmt: skip
        # 90 steps of rounding, at speeds below 15 m/s.
        name = "; its speed down the slope"
        expect_close(dot(velocity, down), rate * steps * h, then=name, unit="m/s", tolerance=NEAR)
        # Semi-implicit Euler moves by rate h^2 (1 + 2 + ... + steps).
        far = rate * h * h * steps * (steps + 1) / 2.0
        expect_close(dot(where, down), far, then="; its displacement", unit="m", tolerance=NEAR)


@pytest.mark.exercise("G8.3", asks="never does more than stop the sliding")
def test_friction_stops_a_body_on_level_ground(rng: Random) -> None:
    about.read = IMPULSE
    mu, speed, h = positive_number(rng, 0.3, 0.8), positive_number(rng, 2.0, 5.0), 1.0 / 60.0
    across = rng.uniform(0.0, math.tau)
    way = (math.cos(across), 0.0, math.sin(across))
    steps = math.ceil(speed / (mu * G * h)) + 10
    about.call = f"a body slides at {speed:g} m/s on level ground, with {mu=}; its velocity along "
    about.call += "its direction"
    mass = positive_number(rng, 0.5, 5.0)
    seen = slid((0.0, 1.0, 0.0), (0.0, -G, 0.0), plus(ZERO, way, speed), mass, mu, steps, h)
    for i, (_, velocity) in enumerate(seen, 1):
        wanted = max(0.0, speed - mu * G * i * h)
        about.cause = "On level ground, friction slows a body down by mu g, whatever its mass."
        if not wanted:
            about.cause = "Friction stops a body, but must not push it back."
        name = f" after step {i}"
        expect_close(dot(velocity, way), wanted, then=name, unit="m/s", tolerance=NEAR)


@pytest.mark.exercise("G8.3", asks="at most mu times the normal impulse")
def test_an_impact_of_two_bodies_with_friction(rng: Random) -> None:
    about.read = IMPULSE
    for mu in (0.0, 0.1, 3.0):
        n, c = direction(rng), positive_number(rng, 0.1, 0.9)
        a, b = draw_body(rng), draw_body(rng)
        closing = -abs(number(rng, 1.0, 5.0))
        relative = plus(a[1], b[1], -1.0)
        a = a[0], plus(a[1], n, closing - dot(relative, n))  # they approach at this speed
        total = 1.0 / a[0] + 1.0 / b[0]
        j = -(1.0 + c) * closing / total
        slip = along(relative, n)
        speed = math.hypot(*slip)
        about.call = called(a, b, n) + f"the restitution is {c}, {mu=}; contact.resolve_velocity()"
        about.cause = "The friction impulse acts on particle, and its opposite on other."
        one, two = bounced(a, b, n, mu, c)
        before = plus(plus(ZERO, a[1], a[0]), b[1], b[0])
        after = plus(plus(ZERO, one, a[0]), two, b[0])
        expect_close(after, before, then="; the momentum of both", unit="kg m/s", tolerance=NEAR)
        apart = plus(one, two, -1.0)
        left = max(0.0, speed - mu * j * total)
        about.cause = "An impact reduces the sliding speed by mu j (1/ma + 1/mb), but not below 0."
        got = dot(apart, plus(ZERO, slip, 1.0 / speed))
        expect_close(got, left, then="; the sliding speed", unit="m/s", tolerance=NEAR)
        about.cause = "Friction must not change the velocity along the normal."
        name = "; the separating velocity"
        expect_close(dot(apart, n), -c * closing, then=name, unit="m/s", tolerance=NEAR)
        energies = [
            0.5 * a[0] * dot(v, v) + 0.5 * b[0] * dot(w, w) for v, w in ((a[1], b[1]), (one, two))
        ]
        about.cause = "Friction must not add kinetic energy."
        gain = energies[1] - energies[0]
        expect_between(gain, -math.inf, NEAR, then="; the gain of kinetic energy", unit="J")
