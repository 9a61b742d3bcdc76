"""Separating velocity and bounce of a contact, build tasks B7.1 and B7.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from draw import Triple, number, positive_number, unit_vector, vector
from expect import expect_close, expect_unchanged

UP = Triple((0.0, 1.0, 0.0))
PART = "book 7.1.3, Eq. 7.4, and the docstring of Contact.separating_velocity"
AFTER = "book 7.1.2, 7.2.3, and the docstring of Contact.velocity_after"
REST = "book 7.2.3, E-26, and the docstring of Contact.velocity_after"
G = 9.81


def along(n: Triple, speed: float, rng: Random) -> Triple:
    """Return a random velocity whose component along the normal is ``speed``."""
    v = vector(rng)
    return v + n * (speed - v @ n)


@pytest.mark.exercise("B7.1", asks="The result is (va - vb) . n", read=PART)
def test_separating_velocity_of_two_moving_particles(rng: Random) -> None:
    p, q, one, two, m = vector(rng), vector(rng), vector(rng), vector(rng), unit_vector(rng)
    for v, w, n, mass in (
        (Triple((2.0, 7.0, 0.0)), Triple((-3.0, 4.0, 0.0)), Triple((-1.0, 0.0, 0.0)), 3.0),
        (one, two, m, 3.0),
        (two, one, m, 3.0),
        (one, two, m, math.inf),
    ):
        with calls(
            "The separating velocity is (va - vb) . n, where n is the contact's normal. It does "
            "not depend on the masses, the positions or the penetration."
        ):
            a = Particle(Vector3(*p), Vector3(*v), mass=2.0)
            b = Particle(Vector3(*q), Vector3(*w), mass=mass)
            c = Contact(a, b, normal=Vector3(*n), restitution=0.5, penetration=-1.0)
            got = c.separating_velocity()
        slips = {
            "You returned the whole relative speed.": abs(v - w),
            "You used only the velocities along Y.": v[1] - w[1],
            "The sign is wrong: your result is positive when the particles approach.": (w - v) @ n,
            "You used only a's velocity, but b is moving too.": v @ n,
            "You added the two velocities.": (v + w) @ n,
            "You measured the velocity along the line between the two positions.":
                (v - w) @ (p - q) / abs(p - q),
        }  # fmt: skip
        # A few roundings of numbers up to 20.
        expect_close(got, (v - w) @ n, slips, tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("B7.1", asks="or 0 if it is None", read=PART)
def test_the_world_does_not_move(rng: Random) -> None:
    v = vector(rng)
    for n in (UP, unit_vector(rng)):
        with calls("self.other is None, so there is no velocity to subtract. Return va . n."):
            a = Particle(velocity=Vector3(*v))
            got = Contact(a, None, normal=Vector3(*n)).separating_velocity()
        slips = {"The sign is wrong: your result is positive on approach.": -(v @ n)}
        expect_close(got, v @ n, slips, tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("B7.1", asks="This method changes nothing", read=PART)
def test_separating_velocity_changes_nothing(rng: Random) -> None:
    v, w, n, m = vector(rng), vector(rng), unit_vector(rng), unit_vector(rng)
    with calls("separating_velocity has changed a vector in place, as -= does. Use va - vb."):
        a, b = Particle(velocity=Vector3(*v)), Particle(velocity=Vector3(*w))
        c = Contact(a, b, normal=Vector3(*n))
        c.separating_velocity()
    expect_unchanged("a.velocity", a.velocity, v)
    expect_unchanged("b.velocity", b.velocity, w)
    expect_unchanged("c.normal", c.normal, n)
    with calls("Use the current velocities and the current normal on every call.", more=True):
        c.normal = Vector3(*m)
        a.velocity = Vector3()
        got = c.separating_velocity()
    expect_close(got, -(w @ m), tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("B7.2", asks="bounces with the restitution c", read=AFTER)
def test_a_closing_contact_bounces(rng: Random) -> None:
    m, middle = unit_vector(rng), round(rng.uniform(0.2, 0.8), 3)
    samples = [(0.5, -4.0, UP, Triple((1.0, -3.0, 2.0)), UP)]
    for restitution, closing in (
        (0.0, -positive_number(rng)),
        (middle, -positive_number(rng)),
        (1.0, -positive_number(rng)),
        (middle, -0.01),
        (middle, -1e-9),
    ):
        w = vector(rng)
        samples.append((restitution, closing, m, along(m, closing + w @ m, rng), w))
    for restitution, closing, n, v, w in samples:
        with calls(
            f"The particles approach at {-closing} m/s. Slow contacts bounce too: return -c v_s, "
            "with the restitution c and the separating velocity v_s before the bounce."
        ):
            a, b = Particle(velocity=Vector3(*v)), Particle(velocity=Vector3(*w), mass=3.0)
            c = Contact(a, b, normal=Vector3(*n), restitution=restitution)
            got = c.velocity_after()
        wanted = -restitution * closing
        slips = {
            "The sign is wrong: the particles still approach after your bounce.": -wanted,
            "You left out the restitution, so the bounce loses no speed.": -closing,
            "You returned the separating velocity before the bounce.": closing,
            "You returned the change in the separating velocity.": wanted - closing,
            "You returned 0.": 0.0,
        }
        slips = slips if closing < -1e-3 else {}  # all of these are near 0
        expect_close(got, wanted, slips, tolerance=1e-12, unit="m/s")


@pytest.mark.exercise("B7.2", asks="is 0 or positive, the result is v_s", read=AFTER)
def test_a_separating_contact_does_not_bounce(rng: Random) -> None:
    n = unit_vector(rng)
    down = n * -G
    for duration, parting in (
        (0.0, positive_number(rng)),
        (0.5, positive_number(rng)),
        (0.5, 0.25),
        (0.0, 1e-6),
    ):
        v = along(n, parting, rng)
        with calls("This contact is already separating. Return its separating velocity."):
            a = Particle(velocity=Vector3(*v), acceleration=Vector3(*down))
            c = Contact(a, None, normal=Vector3(*n), restitution=0.5)
            got = c.velocity_after(duration)
        slips = {
            "You multiplied the separating velocity by the restitution.": 0.5 * parting,
            f"You returned 0, but the particle leaves at {parting:g} m/s.": 0.0,
        }
        slips = slips if parting > 1e-3 else {}  # both of these are near 0
        expect_close(got, v @ n, slips, tolerance=1e-12, unit="m/s")
    with calls("The particle neither approaches nor leaves the ground. Return 0."):
        a = Particle(acceleration=Vector3(0.0, -G, 0.0))
        got = Contact(a, None, normal=Vector3(*UP), restitution=0.5).velocity_after(0.5)
    expect_close(got, 0.0, unit="m/s")


@pytest.mark.exercise("B7.2", asks="return c (a h - v_s), but never less than 0", read=REST)
def test_velocity_added_in_this_step_does_not_bounce(rng: Random) -> None:
    n, h, c = unit_vector(rng), 0.02, round(rng.uniform(0.3, 0.9), 3)
    across = n.cross(unit_vector(rng))
    pull = across * 5.0 - n * G
    for closing, wanted, cause in (
        (G * h, 0.0,
         "The particle is at rest: gravity has added its closing speed of 0.1962 m/s in this "
         "time step. Leave out this part of the speed."),
        (0.4 * G * h, 0.0,
         "The acceleration added 0.1962 m/s in this time step, which is more than the whole "
         "closing speed. Return 0 instead of a negative velocity."),
        (5.0, c * (5.0 - G * h),
         "The acceleration added 0.1962 m/s of 5 m/s. Subtract it, then multiply by c."),
    ):  # fmt: skip
        v = along(n, -closing, rng)
        with calls(cause):
            a = Particle(None, Vector3(*v), Vector3(*pull), mass=3.0, damping=0.25)
            got = Contact(a, None, normal=Vector3(*n), restitution=c).velocity_after(h)
        slips = {
            "Your bounce includes the speed that the acceleration has added in this time step. "
            "Leave it out, or a resting body will jitter.": c * closing,
            "You multiplied by the restitution first. Subtract a h before that.":
                c * closing - G * h,
            "You added a h to the closing speed. Subtract it instead.": c * (closing + G * h),
            "You multiplied the acceleration by the duration twice. Multiply by it once.":
                c * (closing - G * h * h),
            "You used the magnitude of the acceleration instead of acceleration . n.":
                c * (closing - abs(pull) * h),
            "You returned 0, but the acceleration added only 0.1962 m/s. Multiply the acceleration "
            "along the normal by the duration.": 0.0,
        }  # fmt: skip
        expect_close(got, wanted, slips, tolerance=1e-12, unit="m/s")
    with calls("The duration is 0, so the acceleration has added nothing. All 5 m/s bounce."):
        a = Particle(velocity=Vector3(0.0, -5.0, 0.0), acceleration=Vector3(0.0, -G, 0.0))
        got = Contact(a, None, normal=Vector3(*UP), restitution=1.0).velocity_after(0.0)
    expect_close(got, 5.0, unit="m/s")


@pytest.mark.exercise("B7.2", asks="is zero or positive, leave it out", read=REST)
def test_an_acceleration_away_from_the_contact_does_not_count(rng: Random) -> None:
    pull, c = positive_number(rng), round(rng.uniform(0.3, 0.9), 3)
    with calls("You included an acceleration that points away from the contact. Leave it out."):
        a = Particle(velocity=Vector3(0.0, -2.0, 0.0), acceleration=Vector3(3.0, pull, 3.0))
        got = Contact(a, None, normal=Vector3(*UP), restitution=c).velocity_after(0.25)
    expect_close(got, 2.0 * c, unit="m/s")


@pytest.mark.exercise("B7.2", asks="of the particles, which includes forces", read=REST)
def test_accelerations_by_forces_count_too(rng: Random) -> None:
    mass, c, h = positive_number(rng), round(rng.uniform(0.3, 0.9), 3), 0.02
    for own, push, speed, left, cause in (
        (0.0, -G, G * h, 0.0,
         "You left out the force, as the book does (E-26). Use last_acceleration."),
        (-4.0, -5.0, 1.0, 1.0 - 9.0 * h,
         "Use last_acceleration, the sum of both accelerations: -9 m/s^2 along y."),
        (-G, G, 1.0, 1.0,
         "The force cancels gravity, so the whole closing speed of 1 m/s should bounce."),
    ):  # fmt: skip
        with calls(cause):
            a = Particle(acceleration=Vector3(0.0, own, 0.0), mass=mass)
            a.add_force(Vector3(0.0, push * mass, 0.0))
            a.integrate(h)
            a.velocity.y = -speed
            got = Contact(a, None, normal=Vector3(*UP), restitution=c).velocity_after(h)
        expect_close(got, c * left, tolerance=1e-13, unit="m/s")
    with calls(
        "Either you ignored the force that accelerates b, or you added b's acceleration to a's. "
        "Subtract b's last_acceleration, which includes forces, from a's."
    ):
        a, b = Particle(), Particle(mass=mass)
        b.add_force(Vector3(0.0, 7.0 * mass, 0.0))
        b.integrate(h)
        b.velocity.y = 1.0
        got = Contact(a, b, normal=Vector3(*UP), restitution=c).velocity_after(h)
    expect_close(got, c * (1.0 - 7.0 * h), tolerance=1e-12, unit="m/s")


@pytest.mark.exercise("B7.2", asks="Use 0 for an immovable or missing particle", read=REST)
def test_the_difference_of_both_accelerations_counts(rng: Random) -> None:
    pull, other = number(rng), positive_number(rng)
    c, h = round(rng.uniform(0.3, 0.9), 3), 0.02
    immovable = "You used the acceleration of an immovable particle, but it doesn't accelerate."
    for pa, pb, mass_a, mass_b, wanted, cause in (
        (pull, pull, 1.0, 2.0, c * 3.0,
         "Both accelerate alike, which adds nothing. Use the difference of both accelerations."),
        (0.0, other, 1.0, 2.0, c * (3.0 - other * h),
         "Particle b accelerates toward a. Use the difference of both accelerations."),
        (0.0, other, 1.0, math.inf, c * 3.0, immovable),
        (-other, 0.0, 1.0, math.inf, c * (3.0 - other * h),
         "Particle b is immovable, so it doesn't accelerate. Use the whole acceleration of a."),
        (-other, 0.0, math.inf, 1.0, c * 3.0, immovable),
    ):  # fmt: skip
        with calls(cause):
            a = Particle(None, Vector3(0.0, -1.0, 0.0), Vector3(0.0, pa, 0.0), mass=mass_a)
            b = Particle(None, Vector3(0.0, 2.0, 0.0), Vector3(0.0, pb, 0.0), mass=mass_b)
            got = Contact(a, b, normal=Vector3(*UP), restitution=c).velocity_after(h)
        expect_close(got, wanted, tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("B7.2", asks="This method changes nothing", read=AFTER)
def test_velocity_after_changes_nothing(rng: Random) -> None:
    v = Triple((number(rng), -positive_number(rng), number(rng)))
    with calls("velocity_after has changed a vector, but it should only compute a velocity."):
        a = Particle(velocity=Vector3(*v), acceleration=Vector3(0.0, -2.0, 0.0))
        b = Particle(acceleration=Vector3(0.0, -1.0, 0.0))
        c = Contact(a, b, normal=Vector3(*UP), restitution=0.5)
        c.velocity_after(0.5)
    for name, now, before in (
        ("a.velocity", a.velocity, v),
        ("a.acceleration", a.acceleration, (0.0, -2.0, 0.0)),
        ("b.acceleration", b.acceleration, (0.0, -1.0, 0.0)),
        ("b.velocity", b.velocity, (0.0, 0.0, 0.0)),
        ("c.normal", c.normal, UP),
    ):
        expect_unchanged(name, now, before)
    with calls("Read the restitution again on every call, and don't store the result.", more=True):
        c.restitution = 0.25
        got = c.velocity_after(0.0)
    expect_close(got, -0.25 * v[1], unit="m/s")
