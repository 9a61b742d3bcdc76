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
    expect_error,
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


@pytest.mark.exercise("5.2")
def test_a_brake_works_when_it_is_on(rng: Random) -> None:
    about.read = READ
    v, k = components(rng), round(rng.uniform(0.1, 0.9), 3)
    pulled = tuple(-k * v[i] for i in range(3))
    about.call, switched = f"brake = Airbrake(k={k})", ""
    p, brake = Particle(velocity=Vector3(*v), mass=2.0), Airbrake(k)
    for on, wanted, cause in (
        (
            None,
            ZERO,
            "A new brake is off (brake.on is False), so update_force must add no force. Check "
            "self.on in every call.",
        ),
        (
            True,
            pulled,
            "The brake is on and too weak to stop the particle in one step. Its force must be "
            "-k v, where v is the velocity.",
        ),
        (
            None,
            pulled,
            "The brake was switched on before an earlier call, and it is still on. Only the "
            "player switches it off, so update_force must not change self.on.",
        ),
        (
            False,
            ZERO,
            "The brake was switched off, so update_force must add no force. Check self.on "
            "in every call.",
        ),
        (
            True,
            pulled,
            "The brake was switched on again, so its force must be -k v, where v is the velocity.",
        ),
    ):
        about.cause = cause
        if on is not None:
            brake.on = on
            switched = f"{switched}, {'on' if on else 'off'}".lstrip(", ")
        about.call = f"p = Particle(velocity=Vector3{v}, mass=2.0); brake = Airbrake(k={k}), "
        about.call += f"{f'switched {switched}' if switched else 'not switched on yet'}; "
        about.call += "brake.update_force(p, 0.5)"
        brake.update_force(p, 0.5)
        got = xyz(p.force_accumulator)
        if wanted is pulled:
            slips = {
                "Your force points along the velocity, but a brake must push against it. Add "
                "the missing minus sign.": [-part for part in pulled],
                "Your force is -v m / h, which stops the particle completely in a step of h "
                "seconds. Here -k v is smaller, and update_force must always add the smaller "
                "of the two.": [-4.0 * part for part in v],
                "Your force is -k |v| v, which is quadratic drag. The drag of the brake is "
                "linear, so use -k v.": [part * math.hypot(*v) for part in pulled],
            }
            blame(got, slips)
        expect_close(got, wanted, then="; p.force_accumulator, in N")
        p.clear_forces()
    expect_unchanged("p.velocity", xyz(p.velocity), v, cause=UNCHANGED)


@pytest.mark.exercise("5.2")
def test_a_gentle_brake_is_linear_drag(rng: Random) -> None:
    about.read = READ
    v, f = components(rng), components(rng)
    mass, h = round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.1, 0.5), 3)
    about.cause = "The brake is too weak to stop the particle in a step of h seconds, because k h "
    about.cause += "/ m is below 1. Its force must be -k v, without a limit."
    for share in (0.01, 0.5, 0.98):
        k = share * mass / h
        about.call = f"p = Particle(velocity=Vector3{v}, mass={mass}); p.add_force(Vector3{f}); "
        about.call += f"brake = Airbrake(k={k:.6g}), switched on; brake.update_force(p, {h}); "
        about.call += "p.force_accumulator, in N"
        p = Particle(velocity=Vector3(*v), mass=mass)
        p.add_force(Vector3(*f))
        brake_of(k, on=True).update_force(p, h)
        wanted = tuple(f[i] - k * v[i] for i in range(3))
        got = xyz(p.force_accumulator)
        slips = {
            "You limited the force to -v / h, without the mass. The limit must be -v m / h, "
            "which stops the particle completely in a step of h seconds.": [
                f[i] - v[i] / h for i in range(3)
            ],
            "You limited the force to -v m, without the duration h of the step. The limit must "
            "be -v m / h.": [f[i] - v[i] * mass for i in range(3)],
            "You limited the force to -v m h. Divide by the duration h of the step instead of "
            "multiplying by it, so that the limit is -v m / h.": [
                f[i] - v[i] * mass * h for i in range(3)
            ],
            "You limited the force to half of what stops the particle in this step. The limit "
            "must be the force that stops it completely, -v m / h.": [
                f[i] - 0.5 * v[i] * mass / h for i in range(3)
            ],
        }
        why = named(got, about.cause, slips)
        # A few roundings of numbers up to 900.
        expect_close(got, wanted, cause=why, tolerance=1e-11)


@pytest.mark.exercise("5.2")
def test_a_hard_brake_stops_the_motion_and_does_not_turn_it_round(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    mass, h = round(rng.uniform(2.0, 9.0), 3), round(rng.uniform(0.1, 0.5), 3)
    about.cause = "In a step of h seconds a force f changes the velocity by f h / m, so -v m / h "
    about.cause += "stops the particle completely. Never add a larger force than that."
    for share in (1.02, 2.02, 1e3, 1e12):
        k = share * mass / h
        about.call = f"p = Particle(velocity=Vector3{v}, mass={mass}); brake = "
        about.call += f"Airbrake(k={k:.6g}), switched on; brake.update_force(p, {h}); "
        about.call += f"p.integrate({h}); p.velocity in m/s"
        p = Particle(velocity=Vector3(*v), mass=mass)
        brake_of(k, on=True).update_force(p, h)
        got = xyz(p.velocity)
        adds = "update_force changed the velocity itself. It must only add a force, and then the "
        adds += "step changes the velocity."
        expect_unchanged("p.velocity", got, v, cause=adds)
        p.integrate(h)
        got = xyz(p.velocity)
        slips = {
            "Your brake reverses the motion, because its force is too large. Limit it to -v m "
            "/ h, which stops the particle in a step of h seconds.": [
                part * (1.0 - share) for part in v
            ],
            "The velocity did not change, so your brake added no force. If the brake is this "
            "strong, add -v m / h, which stops the particle in a step of h seconds.": v,
        }
        why = named(got, about.cause, slips)
        # What FULL, or rounding, leaves of 10 m/s.
        expect_close(got, ZERO, cause=why, tolerance=1e-9)


@pytest.mark.exercise("5.2")
def test_a_hard_brake_leaves_other_forces_and_itself_alone(rng: Random) -> None:
    about.read = READ
    v, f, mass = components(rng), components(rng), round(rng.uniform(2.0, 9.0), 3)
    about.call = f"p = Particle(velocity=Vector3{v}, acceleration=Vector3(1, 2, 3), mass={mass}); "
    about.call += f"p.add_force(Vector3{f}); brake = Airbrake(k=1e6), switched on; "
    about.call += "brake.update_force(p, 0.5)"
    vectors = {"velocity": Vector3(*v), "acceleration": Vector3(1, 2, 3)}
    p, brake = Particle(**vectors, mass=mass), brake_of(1e6, on=True)
    for h in (0.5, 0.25):
        about.cause = "The brake is strong enough to stop the particle in one step, so its force "
        about.cause += "is -v m / h. Add this force to the earlier ones, and don't clear them."
        p.clear_forces()
        p.add_force(Vector3(*f))
        brake.update_force(p, h)
        got = xyz(p.force_accumulator)
        wanted = tuple(f[i] - v[i] * mass / h for i in range(3))
        # Up to a part in 1e12 of 400 N, as FULL says.
        expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-9)
        about.cause = "update_force has changed brake.on or brake.k. Leave both alone, because "
        about.cause += "only the player sets them."
        expect_exactly((brake.on, brake.k), (True, 1e6), then="; (brake.on, brake.k)")
        about.call += "; in the next step, brake.update_force(p, 0.25)"
    about.call = f"p = Particle(velocity=Vector3{v}, mass=math.inf); brake.update_force(p, 0.5); "
    about.call += "p.integrate(0.5)"
    about.cause = "No force can stop an immovable particle, so its velocity must stay the same. "
    about.cause += "Don't add a force, and don't raise an error."
    p = Particle(velocity=Vector3(*v), mass=math.inf)
    brake.update_force(p, 0.5)
    p.integrate(0.5)
    expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise("5.2")
def test_no_brake_turns_any_motion_round(rng: Random) -> None:
    about.read = READ
    about.cause = "Because of rounding, the force -v m / h can be slightly too large, and then "
    about.cause += "the step reverses the motion. Multiply this limit by FULL, which is slightly "
    about.cause += "below 1."
    tries = 400
    about.call = f"{tries} particles with different speeds and masses, each braked for one step; "
    about.call += "the k of each Airbrake is above m / h, with the mass m and the duration h; the "
    about.call += "smallest fraction of a velocity that is left"
    shares = braked(rng.randrange(10**6), tries)
    least = min(shares, default=math.nan)
    most = max(shares, default=math.nan)
    expect_between(least, 0.0, 1e-9)
    about.cause = "Each brake is strong enough to stop its particle in one step, so at most a "
    about.cause += "rounding error of the velocity may be left."
    name = about.call.replace("smallest", "largest")
    expect_between(most, 0.0, 1e-9, call=name)
    expect_close(
        len(shares),
        tries,
        call="how many steps",
        cause="The number of results is wrong. Each step must give exactly one number.",
    )


@pytest.mark.exercise("5.2")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan, "0.5"])
def test_a_brake_needs_a_positive_and_finite_duration(duration: float) -> None:
    about.read = READ
    for on in (True, False):
        about.call = f"brake = Airbrake(k=2.0); brake.on = {on}; brake.update_force(p, "
        about.call += f"{duration!r})"
        about.cause = "The duration must be positive and finite, even if the brake is off. Check "
        about.cause += "it first, with the function positive from arguments.py."
        p, brake = Particle(velocity=Vector3(1, 2, 3)), brake_of(2.0, on=on)
        expect_error(
            lambda brake=brake, p=p: brake.update_force(p, duration),
            TypeError if isinstance(duration, str) else ValueError,
            allowed=lambda brake=brake: brake.update_force(Particle(), 0.5),
        )
        got = xyz(p.force_accumulator)
        about.cause = "update_force raised an error because of the duration, but it added a force "
        about.cause += "anyway. Check the duration before you add a force."
        expect_close(got, ZERO, then="; p.force_accumulator, in N")
