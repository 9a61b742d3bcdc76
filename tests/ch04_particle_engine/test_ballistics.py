"""A slower bullet, B4.1, aiming, 4.3a, and firing, B4.2."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch04_particle_engine.ballistics import BallisticRange, aim
from ch04_particle_engine.scaling import muzzle_energy, slowed_gravity, slowed_mass
from draw import Triple
from expect import about, expect_close, expect_exactly, named, xyz

# The book's table and our numbers of the grenade: mass, velocity, acceleration, damping.
TABLE = {
    "pistol": (2.0, (0.0, 0.0, 35.0), (0.0, -1.0, 0.0), 0.99),
    "artillery": (200.0, (0.0, 30.0, 40.0), (0.0, -20.0, 0.0), 0.99),
    "fireball": (1.0, (0.0, 0.0, 10.0), (0.0, 0.6, 0.0), 0.9),
    "laser": (0.1, (0.0, 0.0, 100.0), (0.0, 0.0, 0.0), 0.99),
    "grenade": (0.6, (0.0, 12.0, 12.0), (0.0, -10.0, 0.0), 0.9),
}
AIM, FIRE = "the docstring of aim", "the docstring of fire"
BULLET = "book 4.1.1; docs/errata.md"
QUARTER = math.pi / 2.0
X, Y, Z = Triple((1.0, 0.0, 0.0)), Triple((0.0, 1.0, 0.0)), Triple((0.0, 0.0, 1.0))

ROUNDED = 1e-12  # some rounding errors of numbers up to 100, and of a sine or a root


def types_of(at: Any) -> tuple[str, ...]:
    """Return the types of the shots in flight."""
    return tuple(shot.type for shot in at.shots)


def aimed(speed: float, azimuth: float, elevation: float) -> Triple:
    """Return the velocity of a shot in this direction."""
    level = math.sin(azimuth) * X + math.cos(azimuth) * Z
    return speed * math.cos(elevation) * level + speed * math.sin(elevation) * Y


# B4.1 A slower bullet


@pytest.mark.exercise("B4.1", asks="the kinetic energy of a shot, m v^2 / 2", read=BULLET)
def test_the_energy_of_a_bullet_is_half_of_m_v_squared(rng: Random) -> None:
    drawn = round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 90.0), 3)
    for mass, speed in ((0.005, 500.0), drawn):
        with calls("The kinetic energy of the bullet is m v^2 / 2."):
            got = muzzle_energy(mass=mass, speed=speed)
        slips = {
            "You leave out the factor 1/2.": mass * speed**2,
            "You don't square the speed.": mass * speed / 2.0,
            "You square the mass as well.": (mass * speed) ** 2 / 2.0,
            "You divide the speed by 2 before you square it.": mass * (speed / 2.0) ** 2,
        }
        expect_close(got, mass * speed**2 / 2.0, slips, unit="J")


@pytest.mark.exercise(
    "B4.1",
    asks="a slowed shot the kinetic energy of the real shot",
    read="book 4.1.1; the docstring in scaling.py, which defines the factor (E-19)",
)
def test_a_slower_shot_gets_the_mass_that_keeps_its_energy(rng: Random) -> None:
    cause = "Multiply the mass by the square of the factor, because the energy depends on v^2."
    for mass, factor in (
        (0.005, 20.0),
        (round(rng.uniform(2.0, 90.0), 3), round(rng.uniform(2.0, 9.0), 3)),
        (round(rng.uniform(2.0, 90.0), 3), 0.25),
    ):
        with calls(
            cause,
            f"slowed_mass(mass={mass}, factor={factor}); the kinetic energy of a shot with this "
            f"mass at {500.0 / factor:.6g} m/s",
        ):
            slow = slowed_mass(mass, factor)
        slips = {
            "You multiply the mass by the factor, which keeps the momentum the same.":
                mass * factor,
            "You divide the mass by the square of the factor, as in the book's footnote (E-19).":
                mass / factor**2,
            "You divide the mass by the factor.": mass / factor,
            "You leave the mass unchanged, so the slower shot has too little energy.": mass,
        }  # fmt: skip
        energy = 0.5 * slow * (500.0 / factor) ** 2
        expect_close(energy, 0.5 * mass * 500.0**2, unit="J", cause=named(slow, cause, slips))


@pytest.mark.exercise("B4.1", asks="a slowed shot the trajectory of the real shot", read=BULLET)
def test_a_slower_shot_gets_the_gravity_that_keeps_its_arc(rng: Random) -> None:
    cause = "Divide gravity by factor^2, because the drop grows with the square of the time."
    for gravity, factor in (
        (10.0, 20.0),
        (-round(rng.uniform(2.0, 20.0), 3), round(rng.uniform(2.0, 9.0), 3)),
        (9.81, 0.5),
    ):
        with calls(
            cause,
            f"slowed_gravity(gravity={gravity}, factor={factor}); how far a shot at "
            f"{500.0 / factor:.6g} m/s drops over 100 m with this gravity",
        ):
            weak = slowed_gravity(gravity, factor)
        slips = {
            "You divide gravity by the factor only once, as in the book (E-2).": gravity / factor,
            "You leave gravity unchanged, so the slow shot drops too far.": gravity,
            "You multiply gravity by the factor.": gravity * factor,
            "You multiply gravity by factor^2.": gravity * factor**2,
        }
        drop = 0.5 * weak * (100.0 * factor / 500.0) ** 2
        expect_close(drop, 0.5 * gravity * 0.2**2, unit="m", cause=named(weak, cause, slips))


# 4.3a Aiming


@pytest.mark.exercise("4.3a", asks="is the horizontal angle from Z toward X", read=AIM)
def test_the_axes_of_aiming(rng: Random) -> None:
    speed, small = round(rng.uniform(2.0, 90.0), 3), math.radians(QUARTER)
    degrees = "You use math.radians, but they are already in radians. Don't convert the angles."
    vertical = "You measure the elevation from the vertical. Measure it from the ground."
    swapped = "You have swapped Y and Z. The upward part, speed x sin(elevation), is Y."
    length = "and its length must be the speed."
    for azimuth, elevation, shown, wanted, cause, slips in (
        (0.0, 0.0, "azimuth=0.0, elevation=0.0", Z,
         f"If both angles are 0, the velocity must point along Z, {length}",
         {"You measure the azimuth from X. Measure it from Z toward X.": X}),
        (QUARTER, 0.0, "azimuth=math.pi / 2, elevation=0.0", X,
         f"If the azimuth is a quarter turn and the elevation is 0, the velocity must point along "
         f"X, {length}",
         {"You have swapped the two angles. The elevation raises the shot, and the azimuth turns "
          "it to the side.": Y,
          "Your azimuth has the wrong sign. It must rotate the velocity from Z toward X.": -X,
          degrees: aimed(1.0, small, 0.0)}),
        (0.0, QUARTER, "azimuth=0.0, elevation=math.pi / 2", Y,
         "If the elevation is a quarter turn, the velocity must point straight up, along Y.",
         {"You use the whole speed for the horizontal part of the velocity. Multiply the speed by "
          "cos(elevation) to get that part.": Y + Z,
          "Your Y component has the wrong sign. A positive elevation must point up.": -Y,
          degrees: aimed(1.0, 0.0, small)}),
        (0.0, -QUARTER, "azimuth=0.0, elevation=-math.pi / 2", -Y,
         "If the elevation is minus a quarter turn, the velocity must point straight down.", {}),
    ):  # fmt: skip
        with calls(cause, f"aim(speed={speed}, {shown})"):
            got = aim(speed, azimuth, elevation)
            if isinstance(got, tuple):
                about(cause="Your result is a tuple. Return a Vector3 with these components.")
            elif azimuth == elevation == 0.0 and xyz(got) == speed * Y:
                level_x = aim(speed, QUARTER, 0.0).x
                is_swapped = abs(level_x - speed) <= 1e-9 * speed
                slips[swapped if is_swapped else vertical] = Y
        # The cosine of a quarter turn is 6e-17 in floats, not 0.
        results = {slip: speed * velocity for slip, velocity in slips.items()}
        expect_close(xyz(got), speed * wanted, results, unit="m/s")


@pytest.mark.exercise("4.3a", asks="split the level part of the velocity", read=AIM)
def test_azimuth_and_elevation_together(rng: Random) -> None:
    speed = round(rng.uniform(2.0, 90.0), 3)
    azimuth, elevation = round(rng.uniform(0.4, 1.1), 3), round(rng.uniform(0.4, 1.1), 3)
    turned = ((-azimuth, elevation), (azimuth + math.pi, -elevation), (azimuth, elevation + 1.6))
    for a, e in ((azimuth, elevation), *turned):
        with calls(
            "The vertical part of the velocity is speed x sin(elevation), and the horizontal part "
            "is speed x cos(elevation). Multiply the horizontal part by sin(azimuth) to get X, and "
            "by cos(azimuth) to get Z."
        ):
            got = aim(speed, azimuth=a, elevation=e)
        expect_close(xyz(got), aimed(speed, a, e), unit="m/s", tolerance=ROUNDED)


# B4.2 Fire a shot


@pytest.mark.exercise(
    "B4.2", asks="Everything else comes from SHOT_TYPES", read=f"{FIRE}; book 4.1.2"
)
@pytest.mark.parametrize("name", TABLE)
def test_a_shot_starts_as_its_type_says(name: str) -> None:
    mass, velocity, acceleration, damping = TABLE[name]
    with calls("Append exactly one Shot to self.shots, with its type's name and its particle."):
        r = BallisticRange()
        r.fire(name)
    fired = types_of(r)
    if len(fired) == 1 and not isinstance(fired[0], str):
        about(cause="Your Shot holds the ShotType itself. Pass the name of the type to Shot.")
    expect_exactly(fired, (name,), then="; the types of the shots in r.shots")
    shot = r.shots[0]
    new = "A new shot has not flown yet, so its age must be 0. Don't change the age in fire."
    expect_close(shot.age, 0.0, then="; r.shots[0].age", cause=new)
    _, up, along = velocity
    speed = math.hypot(up, along)
    slips = {
        "You fire the shot horizontally if no elevation is given. Use the elevation angle of the "
        "velocity in SHOT_TYPES instead.": speed * Z,
        "You use only the Z component of the type's velocity as the speed. Use the length of that "
        "velocity instead.": along / speed * Triple(velocity),
        "You add up the components of the type's velocity to get the speed. Use the length of that "
        "velocity instead.": (up + along) / speed * Triple(velocity),
        "You measure the elevation of the type's velocity from the vertical. Compute it with "
        "math.atan2(vy, math.hypot(vx, vz)), where vy comes first.": (0.0, along, up),
        "You pass the elevation to aim as the azimuth. The arguments of aim are the speed, the "
        "azimuth and the elevation, in this order.": (up, 0.0, along),
    }
    muzzle = "Your shot does not start at MUZZLE. Pass MUZZLE to the new Particle as the position."
    unaimed = "Without angles, the shot must start with exactly the velocity of its type."
    p = shot.particle
    for field, got, wanted, unit, why in (
        ("position", p.position, (0.0, 1.5, 0.0), "m", muzzle),
        ("velocity", p.velocity, velocity, "m/s", named(xyz(p.velocity), unaimed, slips)),
        ("acceleration", p.acceleration, acceleration, "m/s^2", ""),
        ("mass", p.mass, mass, "kg", ""),
        ("damping", p.damping, damping, "", ""),
    ):
        passed = f"Your shot does not get the {field} of its type. Pass it to the new Particle."
        then = f"; r.shots[0].particle.{field}"
        expect_close(got, wanted, then=then, unit=unit, cause=why or passed)


@pytest.mark.exercise(
    "B4.2", asks="Create a new particle for each shot", read="the docstring of BallisticRange"
)
def test_shots_are_in_the_order_of_firing_and_share_nothing(rng: Random) -> None:
    names = rng.sample(sorted(TABLE), 3)
    names.append(names[0])
    cause = "Append each new shot to the end of self.shots, so that they stay in firing order."
    fired = "; ".join(f'r.fire("{name}")' for name in names)
    with calls(cause, f"r = BallisticRange(); {fired}"):
        r = BallisticRange()
        for name in names:
            r.fire(name)
    if types_of(r) == tuple(names[::-1]):
        cause = f"You put new shots at the front of self.shots. {cause}"
    expect_exactly(types_of(r), tuple(names), then="; the types of the shots", cause=cause)
    with calls(
        "Two of your shots share a vector. Create a new particle with vectors of its own for every "
        "shot.",
        "r.shots[0].particle.velocity.x = 99.0; r.shots[3].particle.velocity.x",
        more=True,
    ):
        r.shots[0].particle.velocity.x = 99.0
        got = r.shots[3].particle.velocity.x
        r.shots[0].particle.damping = 0.25
    if r.shots[3].particle.damping == 0.25:
        about(
            cause="You use one particle for several shots, so a change of one shot changes the "
            "others. Create a new particle in each call of fire."
        )
    expect_close(got, 0.0, tolerance=ROUNDED)


@pytest.mark.exercise("B4.2", asks="flies in the direction of the two angles", read=FIRE)
def test_an_azimuth_rotates_the_shot_and_keeps_its_elevation(rng: Random) -> None:
    azimuth = round(rng.uniform(0.3, 1.2), 3)
    unaimed = "You ignore the azimuth. Pass it to aim."
    for name, up, along in (("artillery", 30.0, 40.0), ("pistol", 0.0, 35.0)):
        with calls("The azimuth must rotate the velocity about Y. Keep its speed and Y component."):
            r = BallisticRange()
            r.fire(name, azimuth=azimuth)
            got = r.shots[-1].particle.velocity
        wanted, slips = aimed(along, azimuth, 0.0) + up * Y, {unaimed: (0.0, up, along)}
        expect_close(got, wanted, slips, unit="m/s", tolerance=ROUNDED)


@pytest.mark.exercise(
    "B4.2", asks="If elevation is None, use the angle of that velocity", read=FIRE
)
def test_a_given_elevation_replaces_that_of_the_type(rng: Random) -> None:
    for elevation, cause in (
        (round(rng.uniform(0.3, 1.2), 3),
         "The given elevation must replace the angle of the type, but the speed stays at 50 m/s. "
         "Pass the elevation and the speed to aim."),
        (0.0,
         "You treat an elevation of 0 as if none were given, because Python treats 0 as false in "
         "an if statement. Compare the elevation with None instead."),
    ):  # fmt: skip
        with calls(cause):
            r = BallisticRange()
            r.fire("artillery", elevation=elevation)
        p, wanted = r.shots[-1].particle, aimed(50.0, 0.0, elevation)
        then = "; r.shots[-1].particle.velocity"
        expect_close(p.velocity, wanted, then=then, unit="m/s", tolerance=ROUNDED)
        down = "Gravity always points down, so rotate only the velocity, not the acceleration."
        then = "; r.shots[-1].particle.acceleration"
        expect_close(p.acceleration, (0.0, -20.0, 0.0), then=then, cause=down)


@pytest.mark.exercise("B4.2", asks="flies in the direction of the two angles", read=FIRE)
def test_fire_uses_azimuth_and_elevation_together(rng: Random) -> None:
    azimuth, elevation = round(rng.uniform(0.3, 1.2), 3), round(rng.uniform(0.3, 1.2), 3)
    with calls("The velocity must depend on both angles. Pass both of them to aim."):
        r = BallisticRange()
        r.fire("artillery", azimuth, elevation)
        got = r.shots[-1].particle.velocity
    slips = {
        "You ignore the azimuth if an elevation is given, so the shot flies straight down the "
        "range. Pass both angles to aim.": aimed(50.0, 0.0, elevation),
        "You ignore the elevation if an azimuth is given, so the shot keeps the elevation of its "
        "type. Pass both angles to aim.": aimed(40.0, azimuth, 0.0) + 30.0 * Y,
    }
    expect_close(got, aimed(50.0, azimuth, elevation), slips, unit="m/s", tolerance=ROUNDED)
