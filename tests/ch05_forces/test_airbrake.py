"""The airbrake, exercise 5.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import Airbrake
from ch05_forces.particle import Particle
from ch05_forces.probes import braked
from draw import components
from expect import (
    UNCHANGED,
    about,
    blame,
    expect_between,
    expect_close,
    expect_exactly,
    expect_unchanged,
    named,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)
READ = "book 5, exercise 5.2; the docstring of Airbrake"


def brake_of(k: float, *, on: bool) -> Airbrake:
    brake = Airbrake(k)
    brake.on = on
    return brake


@pytest.mark.exercise("5.2", asks="Add the force -k v if the brake is on")
def test_a_brake_works_when_it_is_on(rng: Random) -> None:
    about.read = READ
    v, k = components(rng), round(rng.uniform(0.1, 0.9), 3)
    pulled = tuple(-k * v[i] for i in range(3))
    calls = f"p = Particle(velocity=Vector3{v}, mass=2.0); brake = Airbrake(k={k})"
    p, brake = Particle(velocity=Vector3(*v), mass=2.0), Airbrake(k)
    for on, wanted, cause in (
        (
            None,
            ZERO,
            "A new brake is off, but yours still adds a force. Add the force only if self.on is "
            "True.",
        ),
        (
            True,
            pulled,
            "The force is wrong. This brake is too weak to stop the particle in one step, so its "
            "force must be -k v.",
        ),
        (
            None,
            pulled,
            "Your brake switches itself off after one call. Only the player switches it on or "
            "off, so don't change self.on in update_force.",
        ),
        (
            False,
            ZERO,
            "The brake was switched off, but it still adds a force. Check self.on in every call.",
        ),
        (
            True,
            pulled,
            "The brake does not work after it is switched on again. Check self.on in every call.",
        ),
    ):
        about.cause = cause
        if on is not None:
            brake.on = on
            calls += f"; brake.on = {on}"
        calls += "; brake.update_force(p, 0.5)"
        about.call = calls
        brake.update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        if wanted is pulled:
            slips = {
                "Your force points along the velocity, but a brake must push against it. Add "
                "the missing minus sign.": [-part for part in pulled],
                "Your force is -v m / h, although -k v is smaller here. Always add the smaller "
                "of the two forces.": [-4.0 * part for part in v],
                "Your force is -k v multiplied by 0.5. Either you multiply by the duration, or you "
                "divide by the mass, but a force needs neither. Add -k v.": [
                    0.5 * part for part in pulled
                ],
                "Your force has the size k at every speed, because you use a unit vector. Multiply "
                "the velocity itself by -k.": [part / math.hypot(*v) for part in pulled],
                "Your brake is on, but it adds no force. Pass its force to particle.add_force if "
                "self.on is True.": ZERO,
                "Your force is -k |v| v, which is quadratic drag. The drag of the brake is "
                "linear, so use -k v.": [part * math.hypot(*v) for part in pulled],
            }
            blame(got, slips)
        expect_close(got, wanted, then="; p.force_accumulator", unit="N")
        p.clear_forces()
        calls += "; p.clear_forces()"
    expect_unchanged("p.velocity", xyz(p.velocity), v, cause=UNCHANGED)


@pytest.mark.exercise("5.2", asks="A brake with the force -k v")
def test_a_weak_brake_is_linear_drag(rng: Random) -> None:
    about.read = READ
    v, f = components(rng), components(rng)
    mass, h = round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.1, 0.5), 3)
    about.cause = "The force is wrong. This brake is too weak to stop the particle in one "
    about.cause += "step, so its force must be -k v."
    for share in (0.01, 0.5, 0.98):
        k = share * mass / h
        about.call = f"p = Particle(velocity=Vector3{v}, mass={mass}); p.add_force(Vector3{f}); "
        about.call += f"brake = Airbrake(k={k:.6g}); brake.on = True; "
        about.call += f"brake.update_force(p, {h}); p.force_accumulator"
        p = Particle(velocity=Vector3(*v), mass=mass)
        p.add_force(Vector3(*f))
        brake_of(k, on=True).update_force(p, h)
        wanted = tuple(f[i] - k * v[i] for i in range(3))
        got = xyz(p.force_accumulator)
        slips = {
            "Your force is -v m / h, although -k v is smaller here. Always add the smaller of the "
            "two forces.": [f[i] - v[i] * mass / h for i in range(3)],
            "You limit the force to -v / h, without the mass m. The limit must be -v m / h, where "
            "h is the duration.": [f[i] - v[i] / h for i in range(3)],
            "You limit the force to -v m, without the duration h of the step. The limit must be "
            "-v m / h.": [f[i] - v[i] * mass for i in range(3)],
            "You limit the force to -v m h. Divide by the duration h of the step instead of "
            "multiplying, so that the limit is -v m / h.": [
                f[i] - v[i] * mass * h for i in range(3)
            ],
            "You limit the force to half of -v m / h, which removes only half of the velocity. "
            "The limit must be -v m / h, where h is the duration.": [
                f[i] - 0.5 * v[i] * mass / h for i in range(3)
            ],
        }
        why = named(got, about.cause, slips)
        # A few roundings of numbers up to 900.
        expect_close(got, wanted, cause=why, tolerance=1e-11, unit="N")


@pytest.mark.exercise("5.2", asks="it may stop the particle, but not reverse its motion")
def test_a_strong_brake_stops_the_particle_without_reversing_it(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    mass, h = round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.1, 0.5), 3)
    about.cause = "Your brake does not stop the particle. Its force must be -v m / h, which stops "
    about.cause += "the particle completely in a step of h seconds."
    for share in (1.02, 2.02, 1e3, 1e12):
        k = share * mass / h
        about.call = f"p = Particle(velocity=Vector3{v}, mass={mass}); brake = "
        about.call += f"Airbrake(k={k:.6g}); brake.on = True; brake.update_force(p, {h})"
        p = Particle(velocity=Vector3(*v), mass=mass)
        brake_of(k, on=True).update_force(p, h)
        got = xyz(p.velocity)
        adds = "update_force changed the velocity itself. It must only add a force."
        expect_unchanged("p.velocity", got, v, cause=adds)
        p.integrate(h)
        got = xyz(p.velocity)
        slips = {
            "Your brake reverses the motion, because its force is too large. Limit the force to "
            "-v m / h, where h is the duration.": [part * (1.0 - share) for part in v],
            "You add no force if the brake is strong enough to reverse the motion. In this case, "
            "add -v m / h, where h is the duration.": v,
        }
        why = named(got, about.cause, slips)
        # What FULL, or rounding, leaves of 10 m/s.
        then = f"; p.integrate({h}); p.velocity"
        expect_close(got, ZERO, cause=why, then=then, tolerance=1e-9, unit="m/s")


@pytest.mark.exercise("5.2", asks="Add the force to the others on particle")
def test_a_strong_brake_keeps_earlier_forces(rng: Random) -> None:
    about.read = READ
    v, f, mass = components(rng), components(rng), round(rng.uniform(2.0, 9.0), 3)
    about.call = f"p = Particle(velocity=Vector3{v}, acceleration=Vector3(1, 2, 3), mass={mass}); "
    about.call += f"p.add_force(Vector3{f}); brake = Airbrake(k=1e6); brake.on = True; "
    about.call += "brake.update_force(p, 0.5)"
    vectors = {"velocity": Vector3(*v), "acceleration": Vector3(1, 2, 3)}
    p, brake = Particle(**vectors, mass=mass), brake_of(1e6, on=True)
    for h in (0.5, 0.25):
        about.cause = "The force is wrong. This brake is strong enough to stop the particle "
        about.cause += "in one step, so its force must be -v m / h."
        p.clear_forces()
        p.add_force(Vector3(*f))
        brake.update_force(p, h)
        got = xyz(p.force_accumulator)
        wanted = tuple(f[i] - v[i] * mass / h for i in range(3))
        cleared = "The earlier force is missing, because you clear the sum of the forces. Add the "
        cleared += "force of the brake to this sum with add_force instead."
        blame(got, {cleared: [-v[i] * mass / h for i in range(3)]})
        # Up to a part in 1e12 of 400 N, as FULL says.
        expect_close(got, wanted, then="; p.force_accumulator", unit="N", tolerance=1e-9)
        about.cause = "update_force has changed brake.on or brake.k. Don't change them, because "
        about.cause += "only the player sets them."
        expect_exactly((brake.on, brake.k), (True, 1e6), then="; (brake.on, brake.k)")
        about.call += f"; p.clear_forces(); p.add_force(Vector3{f}); brake.update_force(p, 0.25)"
    about.call = f"p = Particle(velocity=Vector3{v}, mass=math.inf); brake.update_force(p, 0.5); "
    about.call += "p.integrate(0.5)"
    about.cause = "Your brake changes the velocity of an immovable particle. It must only add a "
    about.cause += "force, which has no effect on such a particle."
    p = Particle(velocity=Vector3(*v), mass=math.inf)
    brake.update_force(p, 0.5)
    p.integrate(0.5)
    expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise("5.2", asks="at most the fraction FULL of the velocity")
def test_no_brake_reverses_the_motion(rng: Random) -> None:
    about.read = READ
    about.cause = "Rounding makes your limit -v m / h slightly too large, so the step reverses the "
    about.cause += "motion. Multiply the limit by FULL, which is slightly below 1."
    tries = 400
    about.call = f"{tries} particles p that move along X, each with its own brake; every brake is "
    about.call += "on and has k > m / h; brake.update_force(p, h); p.integrate(h); the smallest "
    about.call += "ratio of the new velocity to the old one"
    shares = braked(rng.randrange(10**6), tries)
    least = min(shares, default=math.nan)
    most = max(shares, default=math.nan)
    loose = "Your brake does not slow the particle enough. Each of these brakes is strong enough "
    loose += "to stop its particle in one step."
    if least < -1e-9:
        about.cause = "Your brake reverses the motion, because its force is too large. Limit the "
        about.cause += "force to -v m / h, where h is the duration."
    elif least > 1e-9:
        about.cause = loose
    expect_between(least, 0.0, 1e-9)
    about.cause = loose
    name = about.call.replace("smallest", "largest")
    expect_between(most, 0.0, 1e-9, call=name)
    expect_close(
        len(shares),
        tries,
        call="how many steps",
        cause="The number of results is wrong. Each step must give exactly one number.",
    )
