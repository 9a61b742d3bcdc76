"""Separating velocity and bounce of a contact, build tasks B7.1 and B7.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from draw import Components, components, direction, dot, number, positive_number
from expect import about, blame, expect_close, expect_error, expect_unchanged, xyz

ZERO = (0.0, 0.0, 0.0)
UP = (0.0, 1.0, 0.0)
PART = "book 7.1.1, Eq. 7.2, and the docstring of Contact.separating_velocity"
AFTER = "book 7.2.3, Eq. 7.3, and the docstring of Contact.velocity_after"
REST = "book 7.2.3, E-26, and the docstring of Contact.velocity_after"
G = 9.81


def along(n: Components, speed: float, rng: Random) -> Components:
    """Return a random velocity whose component along the normal is ``speed``."""
    v = components(rng)
    part = speed - dot(v, n)
    return (v[0] + part * n[0], v[1] + part * n[1], v[2] + part * n[2])


@pytest.mark.exercise("B7.1")
def test_two_part_as_one_sees_the_other(rng: Random) -> None:
    about.read = PART
    p, q, one, two = (components(rng) for _ in range(4))
    m = direction(rng)
    for v, w, n, mass in (
        ((2.0, 7.0, 0.0), (-3.0, 4.0, 0.0), (-1.0, 0.0, 0.0), 3.0),
        (one, two, m, 3.0),
        (two, one, m, 3.0),
        (one, two, m, math.inf),
    ):
        about.call = f"a at {p}, velocity {v}; b of {mass} kg at {q}, velocity {w}; Contact(a, b, "
        about.call += f"Vector3{n}, 0.5, -1.0).separating_velocity()"
        about.cause = "The separating velocity is (va - vb) . n, which is positive while the two "
        about.cause += "particles move apart. Masses and penetration have no effect on it."
        a = Particle(Vector3(*p), Vector3(*v), mass=2.0)
        b = Particle(Vector3(*q), Vector3(*w), mass=mass)
        got = Contact(a, b, Vector3(*n), 0.5, -1.0).separating_velocity()
        wanted = dot(v, n) - dot(w, n)
        line = tuple(x - y for x, y in zip(p, q, strict=True))
        over = sum((x - y) * z for x, y, z in zip(v, w, line, strict=True)) / math.hypot(*line)
        mistakes = [
            (-wanted, "The sign is wrong, so a closing contact looks as if it were separating. "
                      "Compute (va - vb) . n, where va - vb is the velocity of a relative to b."),
            (dot(v, n), "You used only a's velocity, but b is moving too. Subtract b's velocity "
                        "first: compute (va - vb) . n."),
            (dot(v, n) + dot(w, n), "You added the two velocities. How fast the particles separate "
                                    "depends on their difference, so subtract the velocity of b."),
            (over, "You measured the velocity along the line between the two positions. Use the "
                   "contact's normal as the direction."),
        ]  # fmt: skip
        blame(got, mistakes)
        # A few roundings of numbers up to 20.
        expect_close(got, wanted, tolerance=1e-13)


@pytest.mark.exercise("B7.1")
def test_the_world_does_not_move(rng: Random) -> None:
    about.read = PART
    v = components(rng)
    for n in (UP, direction(rng)):
        about.call = f"a with velocity {v}; Contact(a, None, Vector3{n}).separating_velocity()"
        about.cause = (
            "This is a contact with something that doesn't move, so self.other is None and there "
            "is no second velocity. Return va . n."
        )
        got = Contact(Particle(velocity=Vector3(*v)), None, Vector3(*n)).separating_velocity()
        blame(
            got,
            [
                (
                    -dot(v, n),
                    "The sign is wrong, so a closing contact looks as if it were separating. "
                    "Return va . n.",
                )
            ],
        )
        expect_close(got, dot(v, n), tolerance=1e-13)


@pytest.mark.exercise("B7.1")
def test_to_ask_for_it_changes_nothing(rng: Random) -> None:
    about.read = PART
    v, w, n, m = components(rng), components(rng), direction(rng), direction(rng)
    about.call = f"a with velocity {v}, b with {w}; c = Contact(a, b, Vector3{n}); "
    about.call += "c.separating_velocity()"
    about.cause = "Asking for the separating velocity must not change any vector. -= works in "
    about.cause += "place, so compute a - b instead, which creates a new vector."
    a, b = Particle(velocity=Vector3(*v)), Particle(velocity=Vector3(*w))
    c = Contact(a, b, Vector3(*n))
    c.separating_velocity()
    for name, now, before in (
        ("a.velocity", xyz(a.velocity), v),
        ("b.velocity", xyz(b.velocity), w),
        ("c.normal", xyz(c.normal), n),
    ):
        expect_unchanged(name, now, before)
    about.call += f"; c.normal = Vector3{m}; a.velocity = Vector3(); c.separating_velocity()"
    about.cause = "The check has changed the velocity and the normal since the first call. Don't "
    about.cause += "cache the result: compute it from their current values on every call."
    c.normal = Vector3(*m)
    a.velocity = Vector3()
    got = c.separating_velocity()
    expect_close(got, -dot(w, m), tolerance=1e-13)


@pytest.mark.exercise("B7.2")
def test_what_closes_bounces(rng: Random) -> None:
    about.read = AFTER
    m = direction(rng)
    middle = round(rng.uniform(0.2, 0.8), 3)
    w = (0.0, 1.0, 0.0)
    samples = [(0.5, -4.0, UP, (1.0, -3.0, 2.0), w)]
    for restitution, closing in (
        (0.0, -positive_number(rng)),
        (middle, -positive_number(rng)),
        (1.0, -positive_number(rng)),
        (middle, -0.01),
        (middle, -1e-9),
    ):
        w = components(rng)
        samples.append((restitution, closing, m, along(m, closing + dot(w, m), rng), w))
    for restitution, closing, n, v, w in samples:
        about.call = f"a with velocity {v}, b with {w}; Contact(a, b, Vector3{n}, "
        about.call += f"{restitution}).velocity_after()"
        about.cause = f"They approach at {-closing} m/s, so they should separate at the "
        about.cause += "restitution times that speed. The rule holds for slow contacts too."
        a, b = Particle(velocity=Vector3(*v)), Particle(velocity=Vector3(*w), mass=3.0)
        got = Contact(a, b, Vector3(*n), restitution).velocity_after()
        wanted = -restitution * closing
        mistakes = [
            (
                -wanted,
                "The sign is wrong, so the particles would still be approaching after the bounce. "
                "They should separate, so return -c v_s.",
            ),
            (
                -closing,
                "Your result ignores the restitution c, so the bounce loses no speed at all. "
                "Return -c v_s.",
            ),
            (
                closing,
                "This is the separating velocity before the bounce. Return the one after it, which "
                "is -c v_s.",
            ),
            (
                wanted - closing,
                "This is the change in the velocity during the bounce. Return the velocity after "
                "the bounce, which is -c v_s.",
            ),
        ]
        if closing < -1e-3:  # below, all of these are near 0
            blame(got, mistakes)
        expect_close(got, wanted, tolerance=1e-12)


@pytest.mark.exercise("B7.2")
def test_what_parts_goes_on(rng: Random) -> None:
    about.read = AFTER
    n = direction(rng)
    for duration, parting in (
        (0.0, positive_number(rng)),
        (0.5, positive_number(rng)),
        (0.5, 0.25),
        (0.0, 1e-6),
    ):
        v = along(n, parting, rng)
        about.call = f"a with velocity {v}; Contact(a, None, Vector3{n}, "
        about.call += f"0.5).velocity_after({duration})"
        about.cause = "This contact is already separating, so it doesn't bounce. Return its "
        about.cause += "separating velocity, whatever the acceleration is."
        down = Vector3(*n) * -G
        a = Particle(velocity=Vector3(*v), acceleration=down)
        got = Contact(a, None, Vector3(*n), 0.5).velocity_after(duration)
        expect_close(got, dot(v, n), tolerance=1e-12)
    about.call = "a at rest, pulled down; Contact(a, None, Vector3(0, 1, 0), "
    about.call += "0.5).velocity_after(0.5)"
    about.cause = (
        "The two particles are neither approaching nor separating, so there is nothing to bounce. "
        "Return 0."
    )
    a = Particle(acceleration=Vector3(0.0, -G, 0.0))
    got = Contact(a, None, Vector3(*UP), 0.5).velocity_after(0.5)
    expect_close(got, 0.0)


@pytest.mark.exercise("B7.2")
def test_what_a_frame_has_built_up_does_not_bounce(rng: Random) -> None:
    about.read = REST
    n, h, c = direction(rng), 0.02, round(rng.uniform(0.3, 0.9), 3)
    side = Vector3(*n).cross(Vector3(*direction(rng)))  # at right angles to n
    x, y, z = xyz(side)
    pull = (5.0 * x - G * n[0], 5.0 * y - G * n[1], 5.0 * z - G * n[2])
    for closing, wanted, cause in (
        (G * h, 0.0, "This body is at rest. It approaches the ground only at the velocity that "
                     "gravity has added in this time step. Leave that velocity out, so that the "
                     "body doesn't bounce."),
        (0.4 * G * h, 0.0,
         "The time step added more than the whole closing speed, so nothing is left to bounce. "
         "Never return less than 0, or the particles would move into each other."),
        (5.0, c * (5.0 - G * h), "The time step itself added 0.1962 of the 5 m/s. Only the rest "
                                 "should bounce, so return c (-v_s + a . n h)."),
    ):  # fmt: skip
        about.cause = cause
        size = math.hypot(*pull)
        mistakes = [
            (c * closing, "You let the whole velocity bounce. Leave out the part that this time "
                          "step has added, or a resting body will jitter."),
            (c * closing - G * h, "You subtracted the velocity that the step has added only after "
                                  "you multiplied by the restitution. Subtract it first, as in c "
                                  "(-v_s + a . n h)."),
            (c * (closing + G * h),
             "Your bounce got faster, but leaving out the velocity that the step has added should "
             "make it slower. Here a . n is negative, so add a . n h to -v_s."),
            (c * (closing - size * h),
             "You used the magnitude of the acceleration, |a|. Only its component along the "
             "normal, a . n, closes the contact."),
            (0.0, "The contact doesn't bounce, although the time step added only 0.1962 of the 5 "
                  "m/s. Perhaps you forgot to multiply a . n by the duration h. Return c (-v_s + a "
                  ". n h)."),
        ]  # fmt: skip
        v = along(n, -closing, rng)
        about.call = f"a of 3 kg with velocity {v}, acceleration {pull}, damping 0.25; Contact(a, "
        about.call += f"None, Vector3{n}, {c}).velocity_after({h})"
        a = Particle(None, Vector3(*v), Vector3(*pull), mass=3.0, damping=0.25)
        got = Contact(a, None, Vector3(*n), c).velocity_after(h)
        blame(got, mistakes)
        expect_close(got, wanted, tolerance=1e-12)
    about.call = f"a with velocity (0, -5, 0), acceleration (0, -{G}, 0); Contact(a, None, "
    about.call += "Vector3(0, 1, 0), 1.0).velocity_after(0.0)"
    about.cause = (
        "With a duration of 0 no time step has added any velocity, so the whole closing velocity "
        "bounces."
    )
    a = Particle(velocity=Vector3(0.0, -5.0, 0.0), acceleration=Vector3(0.0, -G, 0.0))
    got = Contact(a, None, Vector3(*UP), 1.0).velocity_after(0.0)
    expect_close(got, 5.0)


@pytest.mark.exercise("B7.2")
def test_an_acceleration_that_parts_explains_nothing(rng: Random) -> None:
    about.read = REST
    pull, c = positive_number(rng), round(rng.uniform(0.3, 0.9), 3)
    about.call = f"a with velocity (0, -2, 0), acceleration (3, {pull}, 3); Contact(a, None, "
    about.call += f"Vector3(0, 1, 0), {c}).velocity_after(0.25)"
    about.cause = "This acceleration points away from the contact (a . n > 0), so it didn't help "
    about.cause += "to close the contact. The whole 2 m/s should bounce."
    a = Particle(velocity=Vector3(0.0, -2.0, 0.0), acceleration=Vector3(3.0, pull, 3.0))
    got = Contact(a, None, Vector3(*UP), c).velocity_after(0.25)
    expect_close(got, 2.0 * c)


@pytest.mark.exercise("B7.2")
def test_forces_build_up_as_well(rng: Random) -> None:
    about.read = REST
    mass, c, h = positive_number(rng), round(rng.uniform(0.3, 0.9), 3), 0.02
    about.call = f"a of {mass} kg; a.add_force(Vector3(0, -{mass} * {G}, 0)); a.integrate({h}); "
    about.call += f"Contact(a, None, Vector3(0, 1, 0), {c}).velocity_after({h})"
    about.cause = "The acceleration must include forces as well as gravity. The accumulator is "
    about.cause += "already empty at this point, so use last_acceleration, which includes them. "
    about.cause += "The book uses only the constant acceleration, so its bodies keep bouncing if "
    about.cause += "gravity comes from a force generator (E-26)."
    a = Particle(mass=mass)
    a.add_force(Vector3(0.0, -mass * G, 0.0))
    a.integrate(h)
    got = Contact(a, None, Vector3(*UP), c).velocity_after(h)
    expect_close(got, 0.0, tolerance=1e-13)
    about.call = f"a of {mass} kg with acceleration (0, -4, 0), a.add_force(Vector3(0, "
    about.call += f"{-5.0 * mass}, 0)); a.integrate({h}); a.velocity.y = -1; Contact(a, None, "
    about.call += f"Vector3(0, 1, 0), {c}).velocity_after({h})"
    about.cause = "Both the constant acceleration and the forces accelerate the particle. Use "
    about.cause += "last_acceleration, which combines the two: -9 m/s^2."
    a = Particle(acceleration=Vector3(0.0, -4.0, 0.0), mass=mass)
    a.add_force(Vector3(0.0, -5.0 * mass, 0.0))
    a.integrate(h)
    a.velocity.y = -1.0
    got = Contact(a, None, Vector3(*UP), c).velocity_after(h)
    expect_close(got, c * (1.0 - 9.0 * h), tolerance=1e-12)
    about.call = f"b of {mass} kg, pushed up by {7.0 * mass} N; b.integrate({h}); b.velocity.y = "
    about.call += f"1; Contact(a, b, Vector3(0, 1, 0), {c}).velocity_after({h}), a at rest"
    about.cause = "Forces on the other particle can close the contact too. Use the relative "
    about.cause += "acceleration along the normal, (aa - ab) . n."
    b = Particle(mass=mass)
    b.add_force(Vector3(0.0, 7.0 * mass, 0.0))
    b.integrate(h)
    b.velocity.y = 1.0
    got = Contact(Particle(), b, Vector3(*UP), c).velocity_after(h)
    expect_close(got, c * (1.0 - 7.0 * h), tolerance=1e-12)
    about.call = f"a of {mass} kg with acceleration (0, {-G}, 0), held by a force of its weight; "
    about.call += f"a.velocity.y = -1; Contact(a, None, Vector3(0, 1, 0), {c}).velocity_after({h})"
    about.cause = (
        "The force cancels gravity, so the time step has added no velocity. The whole 1 m/s should "
        "bounce."
    )
    a = Particle(acceleration=Vector3(0.0, -G, 0.0), mass=mass)
    a.add_force(Vector3(0.0, mass * G, 0.0))
    a.integrate(h)
    a.velocity.y = -1.0
    got = Contact(a, None, Vector3(*UP), c).velocity_after(h)
    expect_close(got, c, tolerance=1e-12)


@pytest.mark.exercise("B7.2")
def test_two_that_fall_alike_build_up_nothing(rng: Random) -> None:
    about.read = REST
    pull, other = number(rng), positive_number(rng)
    c, h = round(rng.uniform(0.3, 0.9), 3), 0.02
    immovable = "The other particle is immovable, so it doesn't accelerate, whatever its "
    immovable += "last_acceleration says. Leave its acceleration out."
    for pa, pb, mass_a, mass_b, wanted, cause in (
        (pull, pull, 1.0, 2.0, c * 3.0,
         "Both particles have the same acceleration, so a doesn't accelerate relative to b. Use "
         "the difference between the two accelerations, (aa - ab) . n."),
        (0.0, other, 1.0, 2.0, c * (3.0 - other * h),
         "Here b accelerates toward a, which closes the contact. Use the difference between the "
         "two accelerations, (aa - ab) . n."),
        (0.0, other, 1.0, math.inf, c * 3.0, immovable),
        (-other, 0.0, 1.0, math.inf, c * (3.0 - other * h),
         "The other particle is immovable, so it doesn't accelerate. Use the whole acceleration of "
         "a."),
        (-other, 0.0, math.inf, 1.0, c * 3.0, immovable),
    ):  # fmt: skip
        about.cause = cause
        about.call = f"a of {mass_a} kg, velocity (0, -1, 0), acceleration (0, {pa}, 0); b of "
        about.call += f"{mass_b} kg, velocity (0, 2, 0), acceleration (0, {pb}, 0); Contact(a, b, "
        about.call += f"Vector3(0, 1, 0), {c}).velocity_after({h})"
        a = Particle(None, Vector3(0.0, -1.0, 0.0), Vector3(0.0, pa, 0.0), mass=mass_a)
        b = Particle(None, Vector3(0.0, 2.0, 0.0), Vector3(0.0, pb, 0.0), mass=mass_b)
        got = Contact(a, b, Vector3(*UP), c).velocity_after(h)
        expect_close(got, wanted, tolerance=1e-13)


@pytest.mark.exercise("B7.2")
def test_to_say_how_it_bounces_changes_nothing(rng: Random) -> None:
    about.read = AFTER
    v = components(rng)[0], -positive_number(rng), components(rng)[2]
    about.call = f"a with velocity {v}, acceleration (0, -2, 0); c = Contact(a, b, Vector3(0, 1, "
    about.call += "0), 0.5); c.velocity_after(0.5)"
    about.cause = (
        "The call has changed a velocity. This method only computes the new velocity; "
        "resolve_velocity makes the change."
    )
    a = Particle(velocity=Vector3(*v), acceleration=Vector3(0.0, -2.0, 0.0))
    b = Particle(acceleration=Vector3(0.0, -1.0, 0.0))
    c = Contact(a, b, Vector3(*UP), 0.5)
    c.velocity_after(0.5)
    for name, now, before in (
        ("a.velocity", xyz(a.velocity), v),
        ("a.acceleration", xyz(a.acceleration), (0.0, -2.0, 0.0)),
        ("b.acceleration", xyz(b.acceleration), (0.0, -1.0, 0.0)),
        ("b.velocity", xyz(b.velocity), ZERO),
        ("c.normal", xyz(c.normal), UP),
    ):
        expect_unchanged(name, now, before)
    about.call += "; c.restitution = 0.25; c.velocity_after(0.0)"
    about.cause = "The check has changed the restitution or a velocity since the first call. Read "
    about.cause += "both on every call instead of caching the result."
    c.restitution = 0.25
    got = c.velocity_after(0.0)
    expect_close(got, -0.25 * v[1])


@pytest.mark.exercise("B7.2")
@pytest.mark.robust
def test_a_bounce_needs_a_duration_that_means_something() -> None:
    about.read = AFTER
    for velocity in (-1.0, 1.0):
        for duration, error in (
            (-0.5, ValueError),
            (math.nan, ValueError),
            (math.inf, ValueError),
            ("0.5", TypeError),
        ):
            about.call = f"Contact(a, None, Vector3(0, 1, 0)).velocity_after({duration!r}), a with "
            about.call += f"velocity (0, {velocity}, 0)"
            about.cause = "Reject a duration that is negative or not finite before anything else "
            about.cause += "happens. Call not_negative from arguments.py first."
            a = Particle(velocity=Vector3(0.0, velocity, 0.0))
            contact = Contact(a, None, Vector3(*UP))
            expect_error(
                lambda contact=contact, duration=duration: contact.velocity_after(duration),
                error,
                allowed=lambda contact=contact: contact.velocity_after(0),
            )
