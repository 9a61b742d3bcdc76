"""The airbrake, exercise 5.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.forces import Airbrake
from ch05_forces.particle import Particle
from ch05_forces.probes import braked
from draw import Triple, vector
from expect import UNCHANGED, expect_between, expect_close, expect_exactly, expect_unchanged

ZERO = Triple((0.0, 0.0, 0.0))
READ = "book 5, exercise 5.2; the docstring of Airbrake"
WEAK = "This brake is too weak to stop the particle in one step, so its force must be -k v."
STOP = "This brake can stop the particle in one step, so its force must be -v m / h."
LARGER = "Your force is -v m / h. Always add the smaller of the two forces."
LIMIT = "The limit must be -v m / h, where h is the duration."
REVERSED = f"Your brake reverses the motion, because its force is too large. {LIMIT}"


def draw_step(rng: Random) -> tuple[float, float]:
    """Return the mass of a particle and the duration of a step."""
    return round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.1, 0.5), 3)


@pytest.mark.exercise("5.2", asks="Add the force -k v if the brake is on", read=READ)
def test_a_brake_works_when_it_is_on(rng: Random) -> None:
    v, k = vector(rng), round(rng.uniform(0.1, 0.9), 3)
    pull = -k * v
    slips = {
        "Your force points along the velocity, but a brake must push against it.": -pull,
        LARGER: -4.0 * v,
        "Your force is -k v multiplied by 0.5. Either you multiply by the duration, or you divide "
        "by the mass, but a force needs neither. Add -k v.": 0.5 * pull,
        "Your force has the size k at every speed. Multiply the velocity by -k.": pull / abs(v),
        "Your brake is on, but it adds no force. Pass it to particle.add_force.": ZERO,
        "Your force is -k |v| v, which is quadratic drag.": pull * abs(v),
    }
    with calls(WEAK):
        p, brake = Particle(velocity=Vector3(*v), mass=2.0), Airbrake(k=k)
    for on, wanted, cause in (
        (None, ZERO, "A new brake is off. Add a force only if self.on is True."),
        (True, pull, WEAK),
        (None, pull,
         "Your brake switches itself off after one call. Don't change self.on in update_force."),
        (False, ZERO, "The brake was switched off. Check self.on in every call."),
        (True, pull, "The brake was switched on again. Check self.on in every call."),
    ):  # fmt: skip
        switch = "" if on is None else f"brake.on = {on}; "
        shown = f"p.clear_forces(); {switch}brake.update_force(p, 0.5); p.force_accumulator"
        with calls(cause, shown, more=True):
            p.clear_forces()
            if on is not None:
                brake.on = on
            brake.update_force(p, 0.5)
            got = p.force_accumulator
        expect_close(got, wanted, slips if cause is WEAK else {}, unit="N")
    expect_unchanged("p.velocity", p.velocity, v, cause=UNCHANGED)


@pytest.mark.exercise("5.2", asks="A brake with the force -k v", read=READ)
def test_a_weak_brake_is_linear_drag(rng: Random) -> None:
    v, f, (mass, h) = vector(rng), vector(rng), draw_step(rng)
    slips = {
        LARGER: f - v * mass / h,
        f"You limit the force to -v / h, without the mass m. {LIMIT}": f - v / h,
        f"You limit the force to -v m, without the duration h of the step. {LIMIT}": f - v * mass,
        f"You limit the force to -v m h. {LIMIT}": f - v * mass * h,
        f"You limit the force to half of -v m / h. {LIMIT}": f - 0.5 * v * mass / h,
    }
    for share in (0.01, 0.5, 0.98):
        k = share * mass / h
        with calls(WEAK):
            p, brake = Particle(velocity=Vector3(*v), mass=mass), Airbrake(k=k)
            p.add_force(Vector3(*f))
            brake.on = True
            brake.update_force(p, h)
            got = p.force_accumulator
        # A few roundings of numbers up to 900.
        expect_close(got, f - k * v, slips, tolerance=1e-11, unit="N")


@pytest.mark.exercise("5.2", asks="it may stop the particle, but not reverse its motion", read=READ)
def test_a_strong_brake_stops_the_particle_without_reversing_it(rng: Random) -> None:
    v, (mass, h) = vector(rng), draw_step(rng)
    for share in (1.02, 2.02, 1e3, 1e12):
        k = share * mass / h
        with calls(STOP):
            p, brake = Particle(velocity=Vector3(*v), mass=mass), Airbrake(k=k)
            brake.on = True
            brake.update_force(p, h)
        adds = "update_force changed the velocity itself. It must only add a force."
        expect_unchanged("p.velocity", p.velocity, v, cause=adds)
        with calls(STOP, more=True):
            p.integrate(h)
            got = p.velocity
        slips = {
            REVERSED: v * (1.0 - share),
            "You add no force if the brake is strong enough to reverse the motion.": v,
        }
        # What FULL, or rounding, leaves of 10 m/s.
        expect_close(got, ZERO, slips, tolerance=1e-9, unit="m/s")


@pytest.mark.exercise("5.2", asks="Add the force to the others on particle", read=READ)
def test_a_strong_brake_keeps_earlier_forces(rng: Random) -> None:
    v, f, mass = vector(rng), vector(rng), round(rng.uniform(2.0, 9.0), 3)
    with calls(STOP):
        p = Particle(velocity=Vector3(*v), acceleration=Vector3(1, 2, 3), mass=mass)
        brake = Airbrake(k=1e6)
        brake.on = True
    for h in (0.5, 0.25):
        with calls(STOP, more=True):
            p.clear_forces()
            p.add_force(Vector3(*f))
            brake.update_force(p, h)
        stop = -v * mass / h
        slips = {
            "The earlier force is missing. Don't clear it. Add the force of the brake with add_force.": stop
        }
        total, then = p.force_accumulator, "; p.force_accumulator"
        # Up to a part in 1e12 of 400 N, as FULL says.
        expect_close(total, f + stop, slips, then=then, unit="N", tolerance=1e-9)
        cause = "update_force has changed brake.on or brake.k, which only the player sets."
        expect_exactly((brake.on, brake.k), (True, 1e6), then="; (brake.on, brake.k)", cause=cause)
    with calls("Your brake changes an immovable particle. It must only add a force."):
        p, brake = Particle(velocity=Vector3(*v), mass=math.inf), Airbrake(k=1e6)
        brake.on = True
        brake.update_force(p, 0.5)
        p.integrate(0.5)
    expect_unchanged("p.velocity", p.velocity, v)


@pytest.mark.exercise("5.2", asks="at most the fraction FULL of the velocity", read=READ)
def test_no_brake_reverses_the_motion(rng: Random) -> None:
    tries = 400
    loose = "Your brake does not slow the particle enough. Each of these can stop it."
    with calls(
        "Rounding makes your limit -v m / h too large. Multiply it by FULL, slightly below 1.",
        f"{tries} particles p that move along X, each with its own brake; every brake is on and "
        "has k > m / h; brake.update_force(p, h); p.integrate(h)",
    ):
        shares = braked(rng.randrange(10**6), tries)
    least, most = min(shares, default=math.nan), max(shares, default=math.nan)
    then = "; the {} ratio of a new velocity to the old one"
    if least < -1e-9:
        expect_between(least, 0.0, 1e-9, then=then.format("smallest"), cause=REVERSED)
    expect_between(least, 0.0, math.inf, then=then.format("smallest"))
    expect_between(most, 0.0, 1e-9, then=then.format("largest"), cause=loose)
    cause = "The number of results is wrong. Each step must give exactly one number."
    expect_close(len(shares), tries, then="; the number of results", cause=cause)
