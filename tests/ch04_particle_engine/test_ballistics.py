"""Aiming and firing: mini-project 4.3, first part, and build task B4.2."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch04_particle_engine import ballistics
from ch04_particle_engine.ballistics import BallisticRange
from expect import NoVector, about, blame, cause_of, expect_close, expect_exactly, xyz

# The book's table and our numbers of the grenade: mass, velocity, acceleration, damping.
TABLE = {
    "pistol": (2.0, (0.0, 0.0, 35.0), (0.0, -1.0, 0.0), 0.99),
    "artillery": (200.0, (0.0, 30.0, 40.0), (0.0, -20.0, 0.0), 0.99),
    "fireball": (1.0, (0.0, 0.0, 10.0), (0.0, 0.6, 0.0), 0.9),
    "laser": (0.1, (0.0, 0.0, 100.0), (0.0, 0.0, 0.0), 0.99),
    "grenade": (0.6, (0.0, 12.0, 12.0), (0.0, -10.0, 0.0), 0.9),
}
QUARTER = math.pi / 2.0

ROUNDED = 1e-12  # some rounding errors of numbers up to 100, and of a sine or a root


def types_of(at: Any) -> tuple[str, ...]:
    """Return the types of the shots in flight."""
    return tuple(shot.type for shot in at.shots)


# 4.3a Aiming


@pytest.mark.exercise("4.3a", asks="is the horizontal angle from Z toward X")
def test_the_axes_of_aiming(rng: Random) -> None:
    speed = round(rng.uniform(2.0, 90.0), 3)
    about.read = "the docstring of aim"
    for azimuth, elevation, wanted, cause in (
        (
            0.0,
            0.0,
            (0.0, 0.0, speed),
            "If both angles are 0, the velocity must point along Z, and its length must be the "
            "speed.",
        ),
        (
            QUARTER,
            0.0,
            (speed, 0.0, 0.0),
            "If the azimuth is a quarter turn and the elevation is 0, the velocity must point "
            "along X, and its length must be the speed.",
        ),
        (
            0.0,
            QUARTER,
            (0.0, speed, 0.0),
            "If the elevation is a quarter turn, the velocity must point straight up, along Y.",
        ),
        (
            0.0,
            -QUARTER,
            (0.0, -speed, 0.0),
            "If the elevation is minus a quarter turn, the velocity must point straight down.",
        ),
    ):
        names = {QUARTER: "math.pi / 2", -QUARTER: "-math.pi / 2"}
        shown = [names.get(angle, "0.0") for angle in (azimuth, elevation)]
        about(f"aim(speed={speed}, azimuth={shown[0]}, elevation={shown[1]})", cause=cause)
        got = xyz(ballistics.aim(speed, azimuth, elevation))
        small = math.radians(QUARTER)
        degrees = (
            "You convert the angles with math.radians, but they are already in radians. Pass them "
            "to math.sin and math.cos without converting them."
        )
        vertical = (
            "You measure the elevation from the vertical. Measure it from the ground, so "
            "that a shot with an elevation of 0 is level."
        )
        level_x = 0.0 if isinstance(got, NoVector) else ballistics.aim(speed, QUARTER, 0.0).x
        if abs(level_x - speed) <= 1e-9 * speed:
            vertical = (
                "You have swapped Y and Z. The upward part of the velocity, speed x "
                "sin(elevation), is the Y component."
            )
        mistakes = {
            (0.0, 0.0): [
                (wanted, "Your result is a tuple. Return a Vector3 with these components."),
                (
                    (speed, 0.0, 0.0),
                    "You measure the azimuth from X, so a shot with an azimuth of 0 flies "
                    "along X. Measure it from Z toward X.",
                ),
                ((0.0, speed, 0.0), vertical),
            ],
            (QUARTER, 0.0): [
                (
                    (0.0, speed, 0.0),
                    "You have swapped the two angles. The elevation raises the shot, and the "
                    "azimuth turns it to the side.",
                ),
                (
                    (-speed, 0.0, 0.0),
                    "Your azimuth has the wrong sign. A positive azimuth must rotate the velocity "
                    "from Z toward X.",
                ),
                ((speed * math.sin(small), 0.0, speed * math.cos(small)), degrees),
            ],
            (0.0, QUARTER): [
                (
                    (0.0, speed, speed),
                    "You use the whole speed for the horizontal part of the velocity. Multiply the "
                    "speed by cos(elevation) to get that part.",
                ),
                (
                    (0.0, -speed, 0.0),
                    "Your Y component has the wrong sign. A positive elevation must make the "
                    "velocity point up.",
                ),
                ((0.0, speed * math.sin(small), speed * math.cos(small)), degrees),
            ],
        }
        blame(got, mistakes.get((azimuth, elevation), []))
        # The cosine of a quarter turn is 6e-17 in floats, not 0.
        expect_close(got, wanted, unit="m/s")


@pytest.mark.exercise("4.3a", asks="split the level part of the velocity")
def test_azimuth_and_elevation_together(rng: Random) -> None:
    speed = round(rng.uniform(2.0, 90.0), 3)
    azimuth, elevation = round(rng.uniform(0.4, 1.1), 3), round(rng.uniform(0.4, 1.1), 3)
    about.cause = (
        "The vertical part of the velocity is speed x sin(elevation), and the horizontal part is "
        "speed x cos(elevation). Multiply the horizontal part by sin(azimuth) to get X, and by "
        "cos(azimuth) to get Z."
    )
    about.read = "the docstring of aim"
    turned = ((-azimuth, elevation), (azimuth + math.pi, -elevation), (azimuth, elevation + 1.6))
    for a, e in ((azimuth, elevation), *turned):
        about.call = f"aim(speed={speed}, azimuth={a:.6g}, elevation={e:.6g})"
        got = xyz(ballistics.aim(speed, a, e))
        level = speed * math.cos(e)
        wanted = (level * math.sin(a), speed * math.sin(e), level * math.cos(a))
        expect_close(got, wanted, unit="m/s", tolerance=ROUNDED)


# B4.2 Fire a shot


@pytest.mark.exercise("B4.2", asks="Everything else comes from SHOT_TYPES")
@pytest.mark.parametrize("name", TABLE)
def test_a_shot_starts_as_its_type_says(name: str) -> None:
    mass, velocity, acceleration, damping = TABLE[name]
    about.call = f'r = BallisticRange(); r.fire("{name}"); r.shots'
    about.cause = (
        "Each call of fire must append exactly one Shot to self.shots. The Shot holds the name of "
        "the type and the particle."
    )
    about.read = "the docstring of fire; book 4.1.2"
    at = BallisticRange()
    at.fire(name)
    fired = types_of(at)
    if len(fired) == 1 and not isinstance(fired[0], str):
        about.cause = "Your Shot holds the ShotType itself. Pass the name of the type to Shot."
    expect_exactly(fired, (name,), then="; the types of the shots")
    shot = at.shots[0]
    about.cause = (
        "A new shot has not flown yet, so its age must be 0. Don't change the age in fire."
    )
    expect_close(shot.age, 0.0, then="[0].age")
    p, own = shot.particle, f"{about.call}[0].particle"
    about.cause = (
        "Your shot does not start at MUZZLE, which is (0, 1.5, 0). Pass MUZZLE to the new Particle "
        "as the position."
    )
    expect_close(xyz(p.position), (0.0, 1.5, 0.0), call=f"{own}.position", unit="m")
    _, up, along = velocity
    speed = math.hypot(up, along)
    mistakes = [
        (
            (0.0, 0.0, speed),
            (
                "You fire the shot horizontally if no elevation is given. Use the elevation angle "
                "of the velocity in SHOT_TYPES instead."
            ),
        ),
        (
            (0.0, up * along / speed, along * along / speed),
            "You use only the Z component of the type's velocity as the speed. Use the length of "
            "that velocity instead.",
        ),
        (
            (0.0, up * (up + along) / speed, along * (up + along) / speed),
            "You add up the components of the type's velocity to get the speed. Use the length of "
            "that velocity instead.",
        ),
        (
            (0.0, along, up),
            "You measure the elevation of the type's velocity from the vertical. Compute it with "
            "math.atan2(vy, math.hypot(vx, vz)), where vy comes first.",
        ),
        (
            (up, 0.0, along),
            "You pass the elevation to aim as the azimuth. The arguments of aim are the speed, the "
            "azimuth and the elevation, in this order.",
        ),
    ]
    unaimed = (
        "Without angles, the shot must start with exactly the velocity of its type. Keep the "
        "speed and the angle of that velocity."
    )
    about.cause = cause_of(xyz(p.velocity), mistakes, unaimed)
    expect_close(xyz(p.velocity), velocity, call=f"{own}.velocity", unit="m/s")
    about.cause = "Your shot does not get the acceleration of its type. Pass that acceleration to "
    about.cause += "the new Particle."
    expect_close(xyz(p.acceleration), acceleration, call=f"{own}.acceleration", unit="m/s^2")
    about.cause = "Your shot does not get the mass of its type. Pass that mass to the new Particle."
    expect_close(p.mass, mass, call=f"{own}.mass", unit="kg")
    about.cause = "Your shot does not get the damping of its type. Pass that damping to the new "
    about.cause += "Particle."
    expect_close(p.damping, damping, call=f"{own}.damping")


@pytest.mark.exercise("B4.2", asks="Create a new particle for each shot")
def test_shots_are_in_the_order_of_firing_and_share_nothing(
    rng: Random,
) -> None:
    names = rng.sample(sorted(TABLE), 3)
    names.append(names[0])
    calls = "; ".join(f'r.fire("{name}")' for name in names)
    about(
        f"r = BallisticRange(); {calls}",
        cause="Append each new shot to the end of self.shots, so that the shots stay in the order "
        "in which they were fired.",
    )
    about.read = "the docstring of BallisticRange"
    at = BallisticRange()
    for name in names:
        at.fire(name)
    if types_of(at) == tuple(names[::-1]):
        about.cause = "You put new shots at the front of self.shots. Append each new shot to the "
        about.cause += "end, so that the shots stay in the order in which they were fired."
    expect_exactly(types_of(at), tuple(names), then="; the types of the shots")
    about.cause = (
        "Two of your shots share a vector. Create a new particle with vectors of its own for every "
        "shot."
    )
    at.shots[0].particle.velocity.x = 99.0
    about.call += "; r.shots[0].particle.velocity.x = 99.0; r.shots[3].particle.velocity.x"
    got = at.shots[3].particle.velocity.x
    at.shots[0].particle.damping = 0.25
    if at.shots[3].particle.damping == 0.25:
        about.cause = (
            "You use one particle for several shots, so a change of one shot changes the others. "
            "Create a new particle in each call of fire."
        )
    expect_close(got, 0.0, tolerance=ROUNDED)


@pytest.mark.exercise("B4.2", asks="flies in the direction of the two angles")
def test_an_azimuth_rotates_the_shot_and_keeps_its_elevation(rng: Random) -> None:
    azimuth = round(rng.uniform(0.3, 1.2), 3)
    about.read = "the docstring of fire"
    for name, up, along in (("artillery", 30.0, 40.0), ("pistol", 0.0, 35.0)):
        about.call = (
            f'r = BallisticRange(); r.fire("{name}", azimuth={azimuth}); '
            "r.shots[-1].particle.velocity"
        )
        about.cause = (
            "The azimuth must rotate the type's velocity about the Y axis. Keep its speed and its "
            "Y component."
        )
        at = BallisticRange()
        at.fire(name, azimuth=azimuth)
        wanted = (along * math.sin(azimuth), up, along * math.cos(azimuth))
        got = xyz(at.shots[-1].particle.velocity)
        unaimed = (
            "You ignore the azimuth, so the shot still has the velocity of its type. Pass the "
            "azimuth to aim."
        )
        blame(got, [((0.0, up, along), unaimed)])
        expect_close(got, wanted, unit="m/s", tolerance=ROUNDED)


@pytest.mark.exercise("B4.2", asks="If elevation is None, use the angle of that velocity")
def test_a_given_elevation_replaces_that_of_the_type(rng: Random) -> None:
    about.read = "the docstring of fire"
    for elevation in (round(rng.uniform(0.3, 1.2), 3), 0.0):
        about.cause = (
            "The given elevation must replace the angle of the type, but the speed stays at 50 "
            "m/s. Pass the elevation and the speed to aim."
        )
        if elevation == 0.0:
            about.cause = (
                "You treat an elevation of 0 as if none were given, because Python treats 0 as "
                "false in an if statement. Compare the elevation with None instead."
            )
        about.call = (
            f'r = BallisticRange(); r.fire("artillery", elevation={elevation}); '
            "r.shots[-1].particle.velocity"
        )
        at = BallisticRange()
        at.fire("artillery", elevation=elevation)
        wanted = (0.0, 50.0 * math.sin(elevation), 50.0 * math.cos(elevation))
        got = xyz(at.shots[-1].particle.velocity)
        expect_close(got, wanted, unit="m/s", tolerance=ROUNDED)
        about.cause = (
            "The acceleration must not depend on the angles, because gravity always points down. "
            "Rotate only the velocity."
        )
        about.call = (
            f'r = BallisticRange(); r.fire("artillery", elevation={elevation}); '
            "r.shots[-1].particle.acceleration"
        )
        got = xyz(at.shots[-1].particle.acceleration)
        expect_close(got, (0.0, -20.0, 0.0))


@pytest.mark.exercise("B4.2", asks="flies in the direction of the two angles")
def test_fire_uses_azimuth_and_elevation_together(rng: Random) -> None:
    azimuth, elevation = round(rng.uniform(0.3, 1.2), 3), round(rng.uniform(0.3, 1.2), 3)
    about.call = (
        f'r = BallisticRange(); r.fire("artillery", azimuth={azimuth}, elevation={elevation}); '
        "r.shots[-1].particle.velocity"
    )
    about(
        cause="The velocity must depend on both angles. Pass both of them to aim.",
        read="the docstring of fire",
    )
    at = BallisticRange()
    at.fire("artillery", azimuth, elevation)
    level = 50.0 * math.cos(elevation)
    wanted = (level * math.sin(azimuth), 50.0 * math.sin(elevation), level * math.cos(azimuth))
    got = xyz(at.shots[-1].particle.velocity)
    mistakes = [
        (
            (0.0, 50.0 * math.sin(elevation), level),
            "You ignore the azimuth if an elevation is given, so the shot flies straight down "
            "the range. Pass both angles to aim.",
        ),
        (
            (40.0 * math.sin(azimuth), 30.0, 40.0 * math.cos(azimuth)),
            (
                "You ignore the elevation if an azimuth is given, so the shot keeps the elevation "
                "of its type. Pass both angles to aim."
            ),
        ),
    ]
    blame(got, mistakes)
    expect_close(got, wanted, unit="m/s", tolerance=ROUNDED)
