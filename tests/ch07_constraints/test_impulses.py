"""The impulse of a single contact, build task B7.3."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from draw import Triple, number, positive_number, unit_vector, vector
from expect import expect_close, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)
IMPULSE = "book 7.1.4, and the docstring of Contact.resolve_velocity"
REST = "book 7.2.3, and the docstring of Contact.resolve_velocity"


def closing_velocities(rng: Random, n: Triple) -> tuple[Triple, Triple]:
    """Draw two velocities that approach each other along n at 1 m/s or more."""
    v, w = vector(rng), vector(rng)
    while (w - v) @ n < 1.0:
        v, w = vector(rng), vector(rng)
    return v, w


@pytest.mark.exercise("B7.3", asks="impulse that changes the separating velocity", read=IMPULSE)
def test_two_balls_bounce(rng: Random) -> None:
    m, left = unit_vector(rng), Triple((-1.0, 0.0, 0.0))
    for v, w, n, ma, mb, c in (
        (Triple((3.0, 0.0, 0.0)), left, left, 1.0, 4.0, 0.5),
        (*closing_velocities(rng, m), m, positive_number(rng), positive_number(rng),
         round(rng.uniform(0.1, 0.9), 3)),
    ):  # fmt: skip
        with calls(
            "The separating velocity must change from v_s to -c v_s. The impulse g is that change "
            "divided by 1 / ma + 1 / mb, and it changes the velocity of a by n g / ma."
        ):
            a, b = Particle(velocity=Vector3(*v), mass=ma), Particle(velocity=Vector3(*w), mass=mb)
            Contact(a, b, normal=Vector3(*n), restitution=c).resolve_velocity()
        closing, share = (v - w) @ n, ma * mb / (ma + mb)
        change = -(1.0 + c) * closing
        impulse = change * share
        momentum = "You added the impulse g to the velocity, but an impulse is a change in "
        momentum += "momentum (E-24). Add"
        slips = {
            "You used the change in the separating velocity as the impulse.": v + n * (change / ma),
            "You multiplied the change in the separating velocity by 1 / ma + 1 / mb.":
                v + n * (change / share / ma),
            "The masses are swapped: you divided g by the mass of b.": v + n * (impulse / mb),
            "Your impulse has the wrong sign: it pushes a toward b. Push a away from b, along +n.":
                v - n * (impulse / ma),
            "You computed the impulse as if the separating velocity had been 0 before the bounce. "
            "The change is -c v_s - v_s.": v - n * (c * closing * share / ma),
            "You gave each body half of the change in velocity, which is right only for equal "
            "masses. The lighter body changes its velocity more: add n g / ma.":
                v + n * (0.5 * change),
            "You added v_s to the new separating velocity instead of subtracting it.":
                v + n * ((1.0 - c) * closing * share),
            f"{momentum} n g / ma instead.": v + n * impulse,
            "You multiplied the impulse by the mass of a.": v + n * (impulse * ma),
        }  # fmt: skip
        # A few roundings of numbers up to 40.
        wanted, name = v + n * (impulse / ma), "; a.velocity"
        expect_close(xyz(a.velocity), wanted, slips, then=name, tolerance=1e-12, unit="m/s")
        twice = "You computed the impulse again for b. Compute it once, before you change a, for"
        new = closing + impulse / ma  # the separating velocity when only a has its impulse
        slips = {
            "The velocity of b didn't change.": w,
            f"{twice} both.": w + n * ((c * closing + new) * share / mb),
            f"{twice} a and b.": w + n * ((1.0 + c) * new * share / mb),
            "You pushed b in the same direction as a.": w + n * (impulse / mb),
            f"{momentum} -n g / mb instead.": w - n * impulse,
            "You multiplied the impulse by the mass of b.": w - n * (impulse * mb),
        }  # fmt: skip
        why = "The impulse on b is opposite to g, so add -n g / mb to the velocity of b."
        got, wanted, name = xyz(b.velocity), w - n * (impulse / mb), "; b.velocity"
        expect_close(got, wanted, slips, then=name, cause=why, tolerance=1e-12, unit="m/s")


@pytest.mark.exercise("B7.3", asks="This conserves momentum", read="book 7.1.2 and E-7")
def test_momentum_is_kept_and_energy_lost(rng: Random) -> None:
    n, ma, mb = unit_vector(rng), positive_number(rng), positive_number(rng)
    for c in (0.0, 0.5, 1.0):
        v, w = closing_velocities(rng, n)
        with calls("A collision conserves the momentum. Give b the opposite of a's impulse."):
            a, b = Particle(velocity=Vector3(*v), mass=ma), Particle(velocity=Vector3(*w), mass=mb)
            Contact(a, b, normal=Vector3(*n), restitution=c).resolve_velocity()
        va, vb = Triple(xyz(a.velocity)), Triple(xyz(b.velocity))
        # Some roundings of numbers up to 200.
        got, wanted, name = ma * va + mb * vb, ma * v + mb * w, "; the total momentum of a and b"
        expect_close(got, wanted, then=name, tolerance=1e-11, unit="kg m/s")
        lost = 0.5 * ma * (v @ v - va @ va) + 0.5 * mb * (w @ w - vb @ vb)
        wanted = 0.5 * ma * mb / (ma + mb) * (1.0 - c * c) * ((w - v) @ n) ** 2
        why = "v_s after the bounce must be minus the restitution times v_s before (E-7)."
        name = "; the kinetic energy that was lost"
        expect_close(lost, wanted, then=name, cause=why, tolerance=1e-10, unit="J")


@pytest.mark.exercise("B7.3", asks="no special case for bodies that cannot move", read=IMPULSE)
def test_a_wall_takes_any_impulse(rng: Random) -> None:
    n, c, mass = unit_vector(rng), round(rng.uniform(0.1, 0.9), 3), positive_number(rng)
    v = vector(rng)
    v = -v if v @ n > 0.0 else v
    for ends, normal in (("a, None", n), ("a, w", n), ("w, a", -n)):
        with calls(
            "Only a can move, so it takes the whole change in the separating velocity. Use 0 as "
            "the inverse mass of None and of an immovable particle.",
            f"particle a ({mass} kg) with velocity {v}; particle w (immovable) at rest; "
            f"Contact({ends}, normal=Vector3{normal}, restitution={c}).resolve_velocity()",
        ):
            a, w = Particle(velocity=Vector3(*v), mass=mass), Particle(mass=math.inf)
            one, other = {"a, None": (a, None), "a, w": (a, w), "w, a": (w, a)}[ends]
            Contact(one, other, Vector3(*normal), c).resolve_velocity()
        wanted, name = v - n * ((1.0 + c) * (v @ n)), "; a.velocity"
        expect_close(xyz(a.velocity), wanted, then=name, tolerance=1e-12, unit="m/s")
        why = "The inverse mass of w is 0, so the impulse must not change its velocity."
        expect_close(xyz(w.velocity), ZERO, then="; w.velocity", cause=why, unit="m/s")


@pytest.mark.exercise("B7.3", asks="or if neither particle can move", read=IMPULSE)
def test_separating_or_immovable_particles_get_no_impulse(rng: Random) -> None:
    n = unit_vector(rng)
    w, v = closing_velocities(rng, n)
    for mass, first, second, cause in (
        (2.0, v, w,
         "The particles are already separating. Return before you change a velocity."),
        (math.inf, w, v,
         "The sum of their inverse masses is 0. Return before you divide by this sum."),
    ):  # fmt: skip
        with calls(cause):
            a = Particle(velocity=Vector3(*first), mass=mass)
            b = Particle(velocity=Vector3(*second), mass=mass)
            Contact(a, b, Vector3(*n), restitution=0.5, penetration=1.0).resolve_velocity(0.5)
        expect_unchanged("a.velocity", a.velocity, first)
        expect_unchanged("b.velocity", b.velocity, second)
    with calls("With a restitution of 0, v_s must become 0, whatever the penetration is."):
        a, b = Particle(velocity=Vector3(*w)), Particle(velocity=Vector3(*v))
        a.add_force(Vector3(1.0, 2.0, 3.0))
        c = Contact(a, b, normal=Vector3(*n), restitution=0.0, penetration=-1.0)
        c.resolve_velocity(0.5)
    got = n @ xyz(a.velocity) - n @ xyz(b.velocity)
    expect_close(got, 0.0, tolerance=1e-13, then="; the separating velocity", unit="m/s")
    for name, now, before in (
        ("c.normal", c.normal, n),
        ("c.restitution and c.penetration", (c.restitution, c.penetration), (0.0, -1.0)),
        ("a.force_accumulator", a.force_accumulator, (1.0, 2.0, 3.0)),
    ):
        why = f"resolve_velocity has changed {name}. It should change only the velocities of the "
        expect_unchanged(name, now, before, cause=f"{why}two particles.")


@pytest.mark.exercise("B7.3", asks="the separating velocity to velocity_after(duration)", read=REST)
def test_a_resting_particle_does_not_bounce(rng: Random) -> None:
    h, e, side = 0.02, round(rng.uniform(0.3, 0.9), 3), number(rng)
    with calls("Pass the duration to velocity_after, so that gravity's velocity doesn't bounce."):
        a = Particle(None, Vector3(side, -9.0 * h, 0.0), Vector3(0.0, -9.0, 0.0), mass=3.0)
        c = Contact(a, None, Vector3(0.0, 1.0, 0.0), restitution=e, penetration=0.125)
        c.resolve_velocity(h)
    expect_close(xyz(a.velocity), (side, 0.0, 0.0), then="; a.velocity", unit="m/s")
    why = "Change only velocities here, and leave positions to resolve_penetration."
    expect_close(xyz(a.position), ZERO, then="; a.position", cause=why, unit="m")
