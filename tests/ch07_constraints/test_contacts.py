"""Separating velocity and bounce of a contact, build tasks B7.1 and B7.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from draw import Components, components, direction, dot, number, positive_number
from expect import about, blame, expect_close, expect_unchanged, xyz
from impacts import of_mass

ZERO = (0.0, 0.0, 0.0)
UP = (0.0, 1.0, 0.0)
PART = "book 7.1.3, Eq. 7.4, and the docstring of Contact.separating_velocity"
AFTER = "book 7.1.2, 7.2.3, and the docstring of Contact.velocity_after"
REST = "book 7.2.3, E-26, and the docstring of Contact.velocity_after"
G = 9.81


def along(n: Components, speed: float, rng: Random) -> Components:
    """Return a random velocity whose component along the normal is ``speed``."""
    v = components(rng)
    part = speed - dot(v, n)
    return (v[0] + part * n[0], v[1] + part * n[1], v[2] + part * n[2])


@pytest.mark.exercise("B7.1", asks="The result is (va - vb) . n")
def test_separating_velocity_of_two_moving_particles(rng: Random) -> None:
    about.read = PART
    p, q, one, two = (components(rng) for _ in range(4))
    m = direction(rng)
    for v, w, n, mass in (
        ((2.0, 7.0, 0.0), (-3.0, 4.0, 0.0), (-1.0, 0.0, 0.0), 3.0),
        (one, two, m, 3.0),
        (two, one, m, 3.0),
        (one, two, m, math.inf),
    ):
        about.call = f"particle a at {p} with velocity {v}; particle b ({of_mass(mass)}) at {q} "
        about.call += f"with velocity {w}; c = Contact(a, b, normal=Vector3{n}, restitution=0.5, "
        about.call += "penetration=-1.0); c.separating_velocity()"
        about.cause = "The separating velocity is (va - vb) . n, where n is the contact's normal. "
        about.cause += "It does not depend on the masses, the positions or the penetration."
        a = Particle(Vector3(*p), Vector3(*v), mass=2.0)
        b = Particle(Vector3(*q), Vector3(*w), mass=mass)
        got = Contact(a, b, Vector3(*n), 0.5, -1.0).separating_velocity()
        wanted = dot(v, n) - dot(w, n)
        line = tuple(x - y for x, y in zip(p, q, strict=True))
        over = sum((x - y) * z for x, y, z in zip(v, w, line, strict=True)) / math.hypot(*line)
        whole = math.dist(v, w)
        mistakes = [
            (whole, "You returned the whole relative speed. Only its part along the contact's "
                    "normal n counts, so compute (va - vb) . n."),
            (v[1] - w[1], "You used only the velocities along Y. The contact's normal n can point "
                          "in any direction, so compute (va - vb) . n."),
            (-wanted, "The sign is wrong: your result is positive when the particles approach. "
                      "Compute (va - vb) . n, where n is the contact's normal."),
            (dot(v, n), "You used only a's velocity, but b is moving too. Subtract the velocity of "
                        "b before you multiply by the normal n, as in (va - vb) . n."),
            (dot(v, n) + dot(w, n), "You added the two velocities. How fast the particles separate "
                                    "depends on their difference, so compute (va - vb) . n with "
                                    "the contact's normal n."),
            (over, "You measured the velocity along the line between the two positions. Measure it "
                   "along the contact's normal instead."),
        ]  # fmt: skip
        blame(got, mistakes)
        # A few roundings of numbers up to 20.
        expect_close(got, wanted, tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("B7.1", asks="or 0 if it is None")
def test_the_world_does_not_move(rng: Random) -> None:
    about.read = PART
    v = components(rng)
    for n in (UP, direction(rng)):
        about.call = f"particle a with velocity {v}; "
        about.call += f"Contact(a, None, normal=Vector3{n}).separating_velocity()"
        about.cause = "In a contact with the immovable world, self.other is None, so there is no "
        about.cause += "second velocity to subtract. Return va . n, where n is the contact's "
        about.cause += "normal."
        got = Contact(Particle(velocity=Vector3(*v)), None, Vector3(*n)).separating_velocity()
        why = "The sign is wrong: your result is positive when the particle approaches. Return va "
        why += ". n, where n is the contact's normal."
        blame(got, [(-dot(v, n), why)])
        expect_close(got, dot(v, n), tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("B7.1", asks="This method changes nothing")
def test_separating_velocity_changes_nothing(rng: Random) -> None:
    about.read = PART
    v, w, n, m = components(rng), components(rng), direction(rng), direction(rng)
    about.call = f"particle a with velocity {v}; particle b with velocity {w}; c = Contact(a, b, "
    about.call += f"normal=Vector3{n}); c.separating_velocity()"
    about.cause = "separating_velocity has changed a vector in place, as -= does. Use va - vb "
    about.cause += "instead, which creates a new vector."
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
    about.cause = "The velocity of a and the normal have changed since the first call. Don't store "
    about.cause += "the result: compute it from their current values on every call."
    c.normal = Vector3(*m)
    a.velocity = Vector3()
    got = c.separating_velocity()
    expect_close(got, -dot(w, m), tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("B7.2", asks="bounces with the restitution c")
def test_a_closing_contact_bounces(rng: Random) -> None:
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
        about.call = f"particle a with velocity {v}; particle b with velocity {w}; Contact(a, b, "
        about.call += f"normal=Vector3{n}, restitution={restitution}).velocity_after()"
        about.cause = f"The particles approach at {-closing} m/s, so they should separate at the "
        about.cause += "restitution times that speed. Slow contacts bounce too."
        a, b = Particle(velocity=Vector3(*v)), Particle(velocity=Vector3(*w), mass=3.0)
        got = Contact(a, b, Vector3(*n), restitution).velocity_after()
        wanted = -restitution * closing
        mistakes = [
            (-wanted,
             "The sign is wrong: the particles still approach after your bounce. Return -c v_s, "
             "where c is the restitution and v_s the separating velocity before the bounce."),
            (-closing, "You left out the restitution c, so the bounce loses no speed. Return -c "
                       "v_s, where v_s is the separating velocity before the bounce."),
            (closing, "You returned v_s, the separating velocity before the bounce. Return the one "
                      "after it, which is -c v_s with the restitution c."),
            (wanted - closing,
             "You returned the change in the separating velocity. Return its value after the "
             "bounce, which is minus the restitution times its value before."),
            (0.0, f"You returned 0, but the particles approach at {-closing} m/s. Slow contacts "
                  "bounce too: return -c v_s with the restitution c."),
        ]  # fmt: skip
        if closing < -1e-3:  # below, all of these are near 0
            blame(got, mistakes)
        expect_close(got, wanted, tolerance=1e-12, unit="m/s")


@pytest.mark.exercise("B7.2", asks="is 0 or positive, the result is v_s")
def test_a_separating_contact_does_not_bounce(rng: Random) -> None:
    about.read = AFTER
    n = direction(rng)
    for duration, parting in (
        (0.0, positive_number(rng)),
        (0.5, positive_number(rng)),
        (0.5, 0.25),
        (0.0, 1e-6),
    ):
        v = along(n, parting, rng)
        about.call = f"particle a with velocity {v}; c = Contact(a, None, normal=Vector3{n}, "
        about.call += f"restitution=0.5); c.velocity_after({duration})"
        about.cause = "This contact is already separating, so it doesn't bounce. Return its "
        about.cause += "separating velocity unchanged."
        down = Vector3(*n) * -G
        a = Particle(velocity=Vector3(*v), acceleration=down)
        got = Contact(a, None, Vector3(*n), 0.5).velocity_after(duration)
        scaled = "You multiplied the separating velocity by the restitution, but this contact is "
        scaled += "already separating and doesn't bounce. Return the separating velocity itself."
        stopped = f"You returned 0, but this contact is already separating at {parting:g} m/s. "
        stopped += "Return its separating velocity unchanged."
        if parting > 1e-3:  # below, both of these are near 0
            blame(got, [(0.5 * parting, scaled), (0.0, stopped)])
        expect_close(got, dot(v, n), tolerance=1e-12, unit="m/s")
    about.call = "particle a at rest, with gravity pulling it down; Contact(a, None, "
    about.call += "normal=Vector3(0, 1, 0), restitution=0.5).velocity_after(0.5)"
    about.cause = "The separating velocity is 0, so the particle neither approaches nor leaves the "
    about.cause += "ground, and it doesn't bounce. Return 0."
    a = Particle(acceleration=Vector3(0.0, -G, 0.0))
    got = Contact(a, None, Vector3(*UP), 0.5).velocity_after(0.5)
    expect_close(got, 0.0, unit="m/s")


@pytest.mark.exercise("B7.2", asks="return c (a h - v_s), but never less than 0")
def test_velocity_added_in_this_step_does_not_bounce(rng: Random) -> None:
    about.read = REST
    n, h, c = direction(rng), 0.02, round(rng.uniform(0.3, 0.9), 3)
    side = Vector3(*n).cross(Vector3(*direction(rng)))  # at right angles to n
    x, y, z = xyz(side)
    pull = (5.0 * x - G * n[0], 5.0 * y - G * n[1], 5.0 * z - G * n[2])
    for closing, wanted, cause in (
        (G * h, 0.0,
         "The particle is at rest: gravity has added its closing speed of 0.1962 m/s in this "
         "time step. Leave out this part of the speed."),
        (0.4 * G * h, 0.0,
         "The acceleration added 0.1962 m/s in this time step, which is more than the whole "
         "closing speed. Return 0 instead of a negative velocity."),
        (5.0, c * (5.0 - G * h),
         "The acceleration added 0.1962 m/s of the closing speed of 5 m/s. Subtract this part "
         "before you multiply by the restitution."),
    ):  # fmt: skip
        about.cause = cause
        size = math.hypot(*pull)
        mistakes = [
            (c * closing, "Your bounce includes the speed that the acceleration has added in this "
                          "time step. Leave it out, or a resting body will jitter."),
            (c * closing - G * h,
             "You multiplied by the restitution first and then subtracted the velocity that "
             "this time step has added. Subtract it before you multiply by the restitution."),
            (c * (closing + G * h),
             "You added the velocity that this time step has built up to the closing speed. "
             "Subtract it instead."),
            (c * (closing - G * h * h),
             "You multiplied the acceleration by the duration twice. The velocity that it adds in "
             "this time step is the acceleration times the duration."),
            (c * (closing - size * h),
             "You used the magnitude of the acceleration. Use only its component along the "
             "normal, which is the scalar product of the acceleration and the normal."),
            (0.0,
             "You returned 0, but the acceleration added only 0.1962 m/s of the closing speed of 5 "
             "m/s. Multiply the acceleration along the normal by the duration, and subtract the "
             "result."),
        ]  # fmt: skip
        v = along(n, -closing, rng)
        about.call = f"particle a (3 kg, damping 0.25) with velocity {v}; its acceleration is "
        about.call += f"{pull}; c = Contact(a, None, normal=Vector3{n}, restitution={c}); "
        about.call += f"c.velocity_after({h})"
        a = Particle(None, Vector3(*v), Vector3(*pull), mass=3.0, damping=0.25)
        got = Contact(a, None, Vector3(*n), c).velocity_after(h)
        blame(got, mistakes)
        expect_close(got, wanted, tolerance=1e-12, unit="m/s")
    about.call = f"particle a with velocity (0, -5, 0) and acceleration (0, -{G}, 0); Contact(a, "
    about.call += "None, normal=Vector3(0, 1, 0), restitution=1.0).velocity_after(0.0)"
    about.cause = "The duration is 0, so the acceleration has not added any velocity. The whole "
    about.cause += "closing speed of 5 m/s bounces."
    a = Particle(velocity=Vector3(0.0, -5.0, 0.0), acceleration=Vector3(0.0, -G, 0.0))
    got = Contact(a, None, Vector3(*UP), 1.0).velocity_after(0.0)
    expect_close(got, 5.0, unit="m/s")


@pytest.mark.exercise("B7.2", asks="is zero or positive, leave it out")
def test_an_acceleration_away_from_the_contact_does_not_count(rng: Random) -> None:
    about.read = REST
    pull, c = positive_number(rng), round(rng.uniform(0.3, 0.9), 3)
    about.call = f"particle a with velocity (0, -2, 0) and acceleration (3, {pull}, 3); Contact(a, "
    about.call += f"None, normal=Vector3(0, 1, 0), restitution={c}).velocity_after(0.25)"
    about.cause = "You included an acceleration that points away from the contact. This "
    about.cause += "acceleration doesn't add to the closing speed, so use all of the 2 m/s."
    a = Particle(velocity=Vector3(0.0, -2.0, 0.0), acceleration=Vector3(3.0, pull, 3.0))
    got = Contact(a, None, Vector3(*UP), c).velocity_after(0.25)
    expect_close(got, 2.0 * c, unit="m/s")


@pytest.mark.exercise("B7.2", asks="of the particles, which includes forces")
def test_accelerations_by_forces_count_too(rng: Random) -> None:
    about.read = REST
    mass, c, h = positive_number(rng), round(rng.uniform(0.3, 0.9), 3), 0.02
    about.call = f"particle a of {mass} kg, initially at rest; a.add_force(Vector3(0, -{mass} * "
    about.call += f"{G}, 0)); a.integrate({h}); Contact(a, None, normal=Vector3(0, 1, 0), "
    about.call += f"restitution={c}).velocity_after({h})"
    about.cause = "You used only the constant acceleration of particle a and left out the force, "
    about.cause += "as the book does (E-26). Use last_acceleration, which includes all forces."
    a = Particle(mass=mass)
    a.add_force(Vector3(0.0, -mass * G, 0.0))
    a.integrate(h)
    got = Contact(a, None, Vector3(*UP), c).velocity_after(h)
    expect_close(got, 0.0, tolerance=1e-13, unit="m/s")
    about.call = f"particle a of {mass} kg with acceleration (0, -4, 0); a.add_force(Vector3(0, "
    about.call += f"{-5.0 * mass}, 0)); a.integrate({h}); a.velocity.y = -1; Contact(a, None, "
    about.call += f"normal=Vector3(0, 1, 0), restitution={c}).velocity_after({h})"
    about.cause = "Both the constant acceleration and the force accelerate the particle. Use "
    about.cause += "last_acceleration, which is their sum: -9 m/s^2 along y."
    a = Particle(acceleration=Vector3(0.0, -4.0, 0.0), mass=mass)
    a.add_force(Vector3(0.0, -5.0 * mass, 0.0))
    a.integrate(h)
    a.velocity.y = -1.0
    got = Contact(a, None, Vector3(*UP), c).velocity_after(h)
    expect_close(got, c * (1.0 - 9.0 * h), tolerance=1e-12, unit="m/s")
    about.call = f"particle a at rest; particle b of {mass} kg; b.add_force(Vector3(0, 7 * {mass}, "
    about.call += f"0)); b.integrate({h}); b.velocity.y = 1; Contact(a, b, normal=Vector3(0, 1, "
    about.call += f"0), restitution={c}).velocity_after({h})"
    about.cause = "Either you ignored the force that accelerates b, or you added b's acceleration "
    about.cause += "to a's. Subtract b's last_acceleration, which includes forces, from a's."
    b = Particle(mass=mass)
    b.add_force(Vector3(0.0, 7.0 * mass, 0.0))
    b.integrate(h)
    b.velocity.y = 1.0
    got = Contact(Particle(), b, Vector3(*UP), c).velocity_after(h)
    expect_close(got, c * (1.0 - 7.0 * h), tolerance=1e-12, unit="m/s")
    about.call = (
        f"particle a of {mass} kg with acceleration (0, {-G}, 0) and an upward force equal "
    )
    about.call += f"to its weight; a.integrate({h}); a.velocity.y = -1; Contact(a, None, "
    about.call += f"normal=Vector3(0, 1, 0), restitution={c}).velocity_after({h})"
    about.cause = "The force cancels gravity, so the time step has added no velocity. The whole "
    about.cause += "closing speed of 1 m/s should bounce."
    a = Particle(acceleration=Vector3(0.0, -G, 0.0), mass=mass)
    a.add_force(Vector3(0.0, mass * G, 0.0))
    a.integrate(h)
    a.velocity.y = -1.0
    got = Contact(a, None, Vector3(*UP), c).velocity_after(h)
    expect_close(got, c, tolerance=1e-12, unit="m/s")


@pytest.mark.exercise("B7.2", asks="Use 0 for an immovable or missing particle")
def test_the_difference_of_both_accelerations_counts(rng: Random) -> None:
    about.read = REST
    pull, other = number(rng), positive_number(rng)
    c, h = round(rng.uniform(0.3, 0.9), 3), 0.02
    immovable = "You included the last_acceleration of the immovable particle, but it doesn't "
    immovable += "accelerate. Use 0 as its acceleration."
    for pa, pb, mass_a, mass_b, wanted, cause in (
        (pull, pull, 1.0, 2.0, c * 3.0,
         "Both particles have the same acceleration, so it adds nothing to their closing speed. "
         "Subtract the acceleration of b from that of a, and use this difference."),
        (0.0, other, 1.0, 2.0, c * (3.0 - other * h),
         "Particle b accelerates toward a, which adds to the closing speed. Subtract the "
         "acceleration of b from that of a, and use this difference."),
        (0.0, other, 1.0, math.inf, c * 3.0, immovable),
        (-other, 0.0, 1.0, math.inf, c * (3.0 - other * h),
         "Particle b is immovable, so it doesn't accelerate. Use the whole acceleration of a."),
        (-other, 0.0, math.inf, 1.0, c * 3.0, immovable),
    ):  # fmt: skip
        about.cause = cause
        about.call = f"particle a ({of_mass(mass_a)}) with velocity (0, -1, 0) and acceleration "
        about.call += f"(0, {pa:g}, 0); particle b ({of_mass(mass_b)}) with velocity (0, 2, 0) and "
        about.call += f"acceleration (0, {pb:g}, 0); Contact(a, b, normal=Vector3(0, 1, 0), "
        about.call += f"restitution={c}).velocity_after({h})"
        a = Particle(None, Vector3(0.0, -1.0, 0.0), Vector3(0.0, pa, 0.0), mass=mass_a)
        b = Particle(None, Vector3(0.0, 2.0, 0.0), Vector3(0.0, pb, 0.0), mass=mass_b)
        got = Contact(a, b, Vector3(*UP), c).velocity_after(h)
        expect_close(got, wanted, tolerance=1e-13, unit="m/s")


@pytest.mark.exercise("B7.2", asks="This method changes nothing")
def test_velocity_after_changes_nothing(rng: Random) -> None:
    about.read = AFTER
    v = components(rng)[0], -positive_number(rng), components(rng)[2]
    about.call = f"particle a with velocity {v} and acceleration (0, -2, 0); particle b at rest; c "
    about.call += "= Contact(a, b, normal=Vector3(0, 1, 0), restitution=0.5); c.velocity_after(0.5)"
    about.cause = "velocity_after has changed a vector, but it should only compute a velocity. "
    about.cause += "Work on new vectors."
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
    about.cause = "The restitution has changed since the first call, and this duration is 0. Read "
    about.cause += "the restitution on every call, and don't store the result."
    c.restitution = 0.25
    got = c.velocity_after(0.0)
    expect_close(got, -0.25 * v[1], unit="m/s")
