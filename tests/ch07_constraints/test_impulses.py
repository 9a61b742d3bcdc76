"""The impulse of a single contact, build task B7.3."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from draw import Components, components, direction, dot, number, positive_number
from expect import (
    about,
    cause_of,
    expect_close,
    expect_unchanged,
    xyz,
)
from impacts import of_mass

ZERO = (0.0, 0.0, 0.0)
UP = (0.0, 1.0, 0.0)
IMPULSE = "book 7.1.4, and the docstring of Contact.resolve_velocity"


def along(
    v: Components, n: Components, mistakes: Sequence[tuple[float, str]]
) -> list[tuple[Components, str]]:
    """Return the mistakes with v + s n in place of each number s."""
    return [((v[0] + s * n[0], v[1] + s * n[1], v[2] + s * n[2]), name) for s, name in mistakes]


def closing_velocities(rng: Random, n: Components) -> tuple[Components, Components]:
    """Draw two velocities that approach each other along n at 1 m/s or more."""
    v, w = components(rng), components(rng)
    while dot(w, n) - dot(v, n) < 1.0:
        v, w = components(rng), components(rng)
    return v, w


@pytest.mark.exercise("B7.3", asks="impulse that changes the separating velocity")
def test_two_balls_bounce(rng: Random) -> None:
    about.read = IMPULSE
    n = direction(rng)
    v, w = closing_velocities(rng, n)
    samples = [
        ((3.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), 1.0, 4.0, 0.5),
        (v, w, n, positive_number(rng), positive_number(rng), round(rng.uniform(0.1, 0.9), 3)),
    ]
    for v, w, n, ma, mb, c in samples:
        about.call = f"particle a ({ma} kg) with velocity {v}; particle b ({mb} kg) with velocity "
        about.call += f"{w}; Contact(a, b, normal=Vector3{n}, restitution={c}).resolve_velocity()"
        a = Particle(velocity=Vector3(*v), mass=ma)
        b = Particle(velocity=Vector3(*w), mass=mb)
        about.cause = "The separating velocity must change from v_s to -c v_s. The impulse g is "
        about.cause += "that change divided by 1 / ma + 1 / mb, and it changes the velocity of a "
        about.cause += "by n g / ma."
        Contact(a, b, Vector3(*n), c).resolve_velocity()
        closing = dot(v, n) - dot(w, n)
        change = -(1.0 + c) * closing
        wanted_a = tuple(p + mb / (ma + mb) * change * q for p, q in zip(v, n, strict=True))
        wanted_b = tuple(p - ma / (ma + mb) * change * q for p, q in zip(w, n, strict=True))
        got = xyz(a.velocity)
        impulse = change * ma * mb / (ma + mb)
        momentum = "You added the impulse g to the velocity, but an impulse is a change in "
        momentum += "momentum (E-24). Add"
        unlike = -c * closing * impulse / change  # as if it had been at rest before
        mistakes = [
            (change / ma, "You used the change in the separating velocity as the impulse. Divide "
                          "that change by 1 / ma + 1 / mb to get the impulse."),
            (change * (1.0 / ma + 1.0 / mb) / ma,
             "You multiplied the change in the separating velocity by 1 / ma + 1 / mb. Divide it "
             "by this sum to get the impulse."),
            (impulse / mb, "The masses are swapped: you divided the impulse on a by the mass of b. "
                           "Divide it by the mass of a."),
            (-impulse / ma, "Your impulse has the wrong sign: it pushes a toward b. Push a away "
                            "from b, along +n."),
            (unlike / ma,
             "You computed the impulse as if the separating velocity had been 0 before the "
             "bounce. With a restitution c, it changes from v_s to -c v_s, so the change is -c "
             "v_s - v_s."),
            (0.5 * change,
             "You gave each body half of the change in velocity, which is right only for equal "
             "masses. The lighter body changes its velocity more: add n g / ma."),
            ((1.0 - c) * closing * impulse / change,
             "You added v_s to the separating velocity after the bounce. The change is the new "
             "separating velocity minus v_s."),
            (impulse, f"{momentum} n g / ma instead."),
            (impulse * ma, "You multiplied the impulse by the mass of a. Divide it by the mass of "
                           "a, or multiply by the inverse mass."),
        ]  # fmt: skip
        seen = cause_of(got, along(v, n, mistakes), about.cause)
        # A few roundings of numbers up to 40.
        expect_close(got, wanted_a, then="; a.velocity", cause=seen, tolerance=1e-12, unit="m/s")
        got = xyz(b.velocity)
        twice = (
            "You computed the impulse again for b, after the velocity of a had changed. Compute "
        )
        twice += "it once, before you change a velocity, and use it for both."
        new = closing + impulse / ma  # the separating velocity when only a has its impulse
        mistakes = [
            (0.0,
             "The velocity of b didn't change. The impulse on b is opposite to the impulse g on a, "
             "so add -n g / mb to the velocity of b."),
            (-(-c * closing - new) * impulse / change / mb, twice),
            ((1.0 + c) * new * impulse / change / mb, twice),
            (impulse / mb,
             "You pushed b in the same direction as a. The impulse on b is opposite to the impulse "
             "g on a, so add -n g / mb to the velocity of b."),
            (-impulse, f"{momentum} -n g / mb instead."),
            (-impulse * mb, "You multiplied the impulse by the mass of b. Divide it by the mass of "
                            "b, or multiply by the inverse mass."),
        ]  # fmt: skip
        otherwise = "The velocity of a is right, but that of b is wrong. The impulse on b is "
        otherwise += "opposite to the impulse g on a, so add -n g / mb to the velocity of b."
        about.cause = cause_of(got, along(w, n, mistakes), otherwise)
        expect_close(got, wanted_b, then="; b.velocity", tolerance=1e-12, unit="m/s")


@pytest.mark.exercise("B7.3", asks="This conserves momentum")
def test_momentum_is_kept_and_energy_lost(rng: Random) -> None:
    about.read = "book 7.1.2 and E-7"
    n, ma, mb = direction(rng), positive_number(rng), positive_number(rng)
    for c in (0.0, 0.5, 1.0):
        v, w = closing_velocities(rng, n)
        about.call = f"particle a ({ma} kg) with velocity {v}; particle b ({mb} kg) with velocity "
        about.call += f"{w}; Contact(a, b, normal=Vector3{n}, restitution={c}).resolve_velocity()"
        about.cause = "The total momentum has changed, but a collision conserves it. Give b the "
        about.cause += "opposite of the impulse that you give a."
        a = Particle(velocity=Vector3(*v), mass=ma)
        b = Particle(velocity=Vector3(*w), mass=mb)
        Contact(a, b, Vector3(*n), c).resolve_velocity()
        va, vb = xyz(a.velocity), xyz(b.velocity)
        got = tuple(ma * p + mb * q for p, q in zip(va, vb, strict=True))
        wanted = tuple(ma * p + mb * q for p, q in zip(v, w, strict=True))
        name = f"{about.call}; the total momentum of a and b"
        # Some roundings of numbers up to 200.
        expect_close(got, wanted, call=name, tolerance=1e-11, unit="kg m/s")
        lost = 0.5 * ma * (dot(v, v) - dot(va, va)) + 0.5 * mb * (dot(w, w) - dot(vb, vb))
        closing = dot(w, n) - dot(v, n)
        wanted = 0.5 * ma * mb / (ma + mb) * (1.0 - c * c) * closing * closing
        name = f"{about.call}; the kinetic energy that was lost"
        about.cause = "The bounce loses the wrong amount of energy (E-7). The separating velocity "
        about.cause += "after it must be minus the restitution times the one before."
        expect_close(lost, wanted, call=name, tolerance=1e-10, unit="J")


@pytest.mark.exercise("B7.3", asks="no special case for bodies that cannot move")
def test_a_wall_takes_any_impulse(rng: Random) -> None:
    about.read = IMPULSE
    n, c, mass = direction(rng), round(rng.uniform(0.1, 0.9), 3), positive_number(rng)
    v = components(rng)
    if dot(v, n) > 0.0:
        v = (-v[0], -v[1], -v[2])
    wanted = tuple(p - (1.0 + c) * dot(v, n) * q for p, q in zip(v, n, strict=True))
    turned = tuple(-part for part in n)
    for told, normal in (("Contact(a, None", n), ("Contact(a, w", n), ("Contact(w, a", turned)):
        wall = "" if "None" in told else "particle w (immovable) at rest; "
        about.call = f"particle a ({mass} kg) with velocity {v}; {wall}{told}, "
        about.call += f"normal=Vector3{normal}, restitution={c}).resolve_velocity()"
        about.cause = "Only a can move, so it takes the whole change in the separating velocity. "
        about.cause += "Use 0 as the inverse mass of None and of an immovable particle."
        a, w = Particle(velocity=Vector3(*v), mass=mass), Particle(mass=math.inf)
        ends = {"Contact(a, None": (a, None), "Contact(a, w": (a, w), "Contact(w, a": (w, a)}[told]
        Contact(*ends, Vector3(*normal), c).resolve_velocity()
        got = xyz(a.velocity)
        expect_close(got, wanted, then="; a.velocity", tolerance=1e-12, unit="m/s")
        about.cause = "You changed the velocity of the immovable particle w. Its inverse mass is "
        about.cause += "0, so the impulse must not change its velocity."
        got = xyz(w.velocity)
        expect_close(got, ZERO, then="; w.velocity", unit="m/s")


@pytest.mark.exercise("B7.3", asks="or if neither particle can move")
def test_separating_or_immovable_particles_get_no_impulse(rng: Random) -> None:
    about.read = IMPULSE
    v, w, n = components(rng), components(rng), direction(rng)
    if dot(v, n) < dot(w, n):
        v, w = w, v
    for mass, first, second, cause in (
        (2.0, v, w,
         "You changed a velocity, although the particles are already separating and need no "
         "impulse. Return before you change anything."),
        (math.inf, w, v, "Both particles are immovable, so the sum of their inverse masses is 0. "
                         "Return before you divide by this sum."),
    ):  # fmt: skip
        about(cause=cause)
        about.call = f"particle a ({of_mass(mass)}) with velocity {first}; particle b "
        about.call += f"({of_mass(mass)}) with velocity {second}; c = Contact(a, b, "
        about.call += f"normal=Vector3{n}, restitution=0.5, penetration=1.0); "
        about.call += "c.resolve_velocity(0.5)"
        a, b = (Particle(velocity=Vector3(*u), mass=mass) for u in (first, second))
        Contact(a, b, Vector3(*n), 0.5, 1.0).resolve_velocity(0.5)
        got = xyz(a.velocity)
        expect_unchanged("a.velocity", got, first)
        got = xyz(b.velocity)
        expect_unchanged("b.velocity", got, second)
    about.call = f"particle a with velocity {w}, particle b with velocity {v}; "
    about.call += f"a.add_force(Vector3(1, 2, 3)); c = Contact(a, b, normal=Vector3{n}, "
    about.call += "restitution=0.0, penetration=-1.0); c.resolve_velocity(0.5)"
    about.cause = "With a restitution of 0, the separating velocity of a closing contact should "
    about.cause += "become 0. Don't check the penetration, although it is negative here."
    a, b = (Particle(velocity=Vector3(*u)) for u in (w, v))
    a.add_force(Vector3(1.0, 2.0, 3.0))
    c = Contact(a, b, Vector3(*n), 0.0, -1.0)
    c.resolve_velocity(0.5)
    got = dot(xyz(a.velocity), n) - dot(xyz(b.velocity), n)
    expect_close(got, 0.0, tolerance=1e-13, then="; the separating velocity", unit="m/s")
    for name, now, before in (
        ("c.normal", xyz(c.normal), n),
        ("c.restitution and c.penetration", (c.restitution, c.penetration), (0.0, -1.0)),
        ("a.force_accumulator", xyz(a.force_accumulator), (1.0, 2.0, 3.0)),
    ):
        about.cause = f"resolve_velocity has changed {name}. It should change only the velocities "
        about.cause += "of the two particles."
        expect_unchanged(name, now, before)


@pytest.mark.exercise("B7.3", asks="the separating velocity to velocity_after(duration)")
def test_a_resting_particle_does_not_bounce(rng: Random) -> None:
    about.read = "book 7.2.3, and the docstring of Contact.resolve_velocity"
    h, c, side = 0.02, round(rng.uniform(0.3, 0.9), 3), number(rng)
    about.call = f"particle a with velocity ({side}, {-9.0 * h}, 0) and acceleration (0, -9, 0); c "
    about.call += f"= Contact(a, None, normal=Vector3(0, 1, 0), restitution={c}, "
    about.call += f"penetration=0.125); c.resolve_velocity({h})"
    about.cause = "Your bounce includes the velocity that gravity has added in this time step. "
    about.cause += "Pass the duration to velocity_after, which leaves this velocity out."
    a = Particle(None, Vector3(side, -9.0 * h, 0.0), Vector3(0.0, -9.0, 0.0), mass=3.0)
    Contact(a, None, Vector3(*UP), c, 0.125).resolve_velocity(h)
    got = xyz(a.velocity)
    expect_close(got, (side, 0.0, 0.0), then="; a.velocity", unit="m/s")
    about.cause = "resolve_velocity has moved the particle. It should change only velocities, and "
    about.cause += "leave positions to resolve_penetration."
    got = xyz(a.position)
    expect_close(got, ZERO, then="; a.position", unit="m")
