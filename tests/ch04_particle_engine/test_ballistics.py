"""Aiming and firing: mini-project 4.3, first part, and build task B4.2."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch04_particle_engine import ballistics
from ch04_particle_engine.ballistics import BallisticRange
from expect import about, blame, cause_of, expect_close, expect_error, expect_exactly, xyz

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


@pytest.mark.exercise("4.3a")
def test_the_axes_of_aiming(rng: Random) -> None:
    speed = round(rng.uniform(2.0, 90.0), 3)
    about.read = "the docstring of aim"
    for azimuth, elevation, wanted, cause in (
        (0.0, 0.0, (0.0, 0.0, speed), "If both angles are 0, the velocity must point along Z."),
        (
            QUARTER,
            0.0,
            (speed, 0.0, 0.0),
            "If the azimuth is a quarter turn, the velocity must point along X.",
        ),
        (
            0.0,
            QUARTER,
            (0.0, speed, 0.0),
            "If the elevation is a quarter turn, the velocity must point straight up.",
        ),
        (
            0.0,
            -QUARTER,
            (0.0, -speed, 0.0),
            "If the elevation is negative, the velocity must point down.",
        ),
    ):
        about(f"aim({speed}, {azimuth}, {elevation})", cause=cause)
        got = xyz(ballistics.aim(speed, azimuth, elevation))
        small = math.radians(QUARTER)
        degrees = "The angles are already in radians, so don't convert them with math.radians."
        mistakes = {
            (0.0, 0.0): [
                (
                    (speed, 0.0, 0.0),
                    "The azimuth was measured from X, so 0 points along X. Measure it from Z "
                    "toward X.",
                ),
                (
                    (0.0, speed, 0.0),
                    "The elevation was measured from the vertical. Measure it from the ground, so "
                    "that an elevation of 0 is level.",
                ),
            ],
            (QUARTER, 0.0): [
                (
                    (-speed, 0.0, 0.0),
                    "The azimuth has the wrong sign. A positive azimuth must turn the velocity "
                    "from Z toward X.",
                ),
                ((speed * math.sin(small), 0.0, speed * math.cos(small)), degrees),
            ],
            (0.0, QUARTER): [
                (
                    (0.0, speed, speed),
                    "The horizontal part of the velocity is too fast. Multiply the speed by "
                    "cos(elevation) to get it.",
                ),
                (
                    (0.0, -speed, 0.0),
                    "The Y component has the wrong sign. A positive elevation must point up.",
                ),
                ((0.0, speed * math.sin(small), speed * math.cos(small)), degrees),
            ],
        }
        blame(got, mistakes.get((azimuth, elevation), []))
        # The cosine of a quarter turn is 6e-17 in floats, not 0.
        expect_close(got, wanted)


@pytest.mark.exercise("4.3a")
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
        about.call = f"aim({speed}, {a}, {e})"
        got = xyz(ballistics.aim(speed, a, e))
        level = speed * math.cos(e)
        wanted = (level * math.sin(a), speed * math.sin(e), level * math.cos(a))
        expect_close(got, wanted, tolerance=ROUNDED)


@pytest.mark.exercise("4.3a")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [math.inf, -math.inf, math.nan])
def test_speed_and_angles_are_finite(bad: float) -> None:
    about.cause = (
        "The speed must be finite and not negative, and both angles must be finite. Check them "
        "with not_negative and finite from arguments.py."
    )
    about.read = "the docstring of aim"
    for data in ((bad, 0.0, 0.0), (3.0, bad, 0.0), (3.0, 0.0, bad), (-3.0, 0.0, 0.0)):
        about.call = f"aim{data}"
        expect_error(
            lambda data=data: ballistics.aim(*data),
            ValueError,
            allowed=lambda: ballistics.aim(0.0, -9.0, 9.0),
        )


# B4.2 Fire a shot


@pytest.mark.exercise("B4.2")
@pytest.mark.parametrize("name", TABLE)
def test_a_shot_starts_as_its_type_says(name: str) -> None:
    mass, velocity, acceleration, damping = TABLE[name]
    about.call = f'r = BallisticRange(); r.fire("{name}"); r.shots'
    about.cause = (
        "Each call to fire must add exactly one Shot, of the given type, to the list of shots."
    )
    about.read = "the docstring of fire; book 4.1.2"
    at = BallisticRange()
    at.fire(name)
    expect_exactly(types_of(at), (name,), then=", their types")
    shot = at.shots[0]
    about.cause = "A shot that has just been fired has not flown yet, so its age is 0."
    expect_close(shot.age, 0.0, then="[0].age")
    p, own = shot.particle, f"{about.call}[0].particle"
    about.cause = "Every shot starts at MUZZLE, so put the new particle there."
    expect_close(xyz(p.position), (0.0, 1.5, 0.0), call=f"{own}.position")
    _, up, along = velocity
    speed = math.hypot(up, along)
    mistakes = [
        (
            (0.0, 0.0, speed),
            "No elevation was given, so the shot must keep the angle of its type's velocity.",
        ),
        (
            (0.0, up * along / speed, along * along / speed),
            "The shot is too slow. Use the length of its type's velocity, not just the Z "
            "component.",
        ),
    ]
    unaimed = "No angles were given, so the shot must start with the velocity of its type."
    about.cause = cause_of(xyz(p.velocity), mistakes, unaimed)
    expect_close(xyz(p.velocity), velocity, call=f"{own}.velocity")
    about.cause = (
        "The shot must accelerate as its type does, so pass the type's acceleration to the "
        "Particle."
    )
    expect_close(xyz(p.acceleration), acceleration, call=f"{own}.acceleration")
    about.cause = "The shot must have the mass of its type, so pass that mass to the Particle."
    expect_close(p.mass, mass, call=f"{own}.mass")
    about.cause = (
        "The shot must have the damping of its type, so pass that damping to the Particle."
    )
    expect_close(p.damping, damping, call=f"{own}.damping")


@pytest.mark.exercise("B4.2")
def test_shots_stand_in_the_order_in_which_they_were_fired_and_have_nothing_in_common(
    rng: Random,
) -> None:
    names = rng.sample(sorted(TABLE), 3)
    names.append(names[0])
    calls = "; ".join(f'r.fire("{name}")' for name in names)
    about(
        f"r = BallisticRange(); {calls}; r.shots",
        cause="Append each new shot to the end of the list, so that the shots stay in the order "
        "in which they were fired.",
    )
    about.read = "the docstring of BallisticRange"
    at = BallisticRange()
    for name in names:
        at.fire(name)
    expect_exactly(types_of(at), tuple(names), then=", their types")
    about.cause = (
        "Two shots, or two ranges, share an object. Create a new particle for every shot, and a "
        "new list of shots for every range."
    )
    at.shots[0].particle.velocity.x = 99.0
    about.call = f"{about.call}[0].particle.velocity.x = 99.0; r.shots[3].particle.velocity.x"
    got = at.shots[3].particle.velocity.x
    expect_close(got, 0.0, tolerance=ROUNDED)
    about.call = f"{about.call}; len(BallisticRange().shots)"
    expect_exactly(len(BallisticRange().shots), 0)


@pytest.mark.exercise("B4.2")
def test_an_azimuth_turns_the_shot_and_keeps_its_own_elevation(rng: Random) -> None:
    azimuth = round(rng.uniform(0.3, 1.2), 3)
    about.read = "the docstring of fire"
    for name, up, along in (("artillery", 30.0, 40.0), ("pistol", 0.0, 35.0)):
        about.call = f'r.fire("{name}", azimuth={azimuth}); r.shots[-1].particle.velocity'
        about.cause = (
            "The azimuth rotates the type's velocity about the Y axis, so the Y component must not "
            "change."
        )
        at = BallisticRange()
        at.fire(name, azimuth=azimuth)
        wanted = (along * math.sin(azimuth), up, along * math.cos(azimuth))
        got = xyz(at.shots[-1].particle.velocity)
        unaimed = (
            "The shot still has its type's velocity, so the azimuth had no effect. Rotate the "
            "velocity by it."
        )
        blame(got, [((0.0, up, along), unaimed)])
        expect_close(got, wanted, tolerance=ROUNDED)


@pytest.mark.exercise("B4.2")
def test_an_elevation_takes_the_place_of_the_type_s_own(rng: Random) -> None:
    about.read = "the docstring of fire"
    for elevation in (round(rng.uniform(0.3, 1.2), 3), 0.0):
        about.cause = (
            "The elevation replaces the angle of the type, but the speed stays the same. Aim the "
            "whole speed of 50 m/s at this elevation."
        )
        if elevation == 0.0:
            about.cause = (
                "An elevation of 0 is valid and means a level shot. Python treats 0 as false in an "
                "if statement, so compare the elevation with None instead."
            )
        about.call = f'r.fire("artillery", elevation={elevation}); r.shots[-1].particle.velocity'
        at = BallisticRange()
        at.fire("artillery", elevation=elevation)
        wanted = (0.0, 50.0 * math.sin(elevation), 50.0 * math.cos(elevation))
        got = xyz(at.shots[-1].particle.velocity)
        expect_close(got, wanted, tolerance=ROUNDED)
        about.cause = (
            "Only the velocity depends on the angles. Leave the acceleration alone, because "
            "gravity always points down."
        )
        about.call = (
            f'r.fire("artillery", elevation={elevation}); r.shots[-1].particle.acceleration'
        )
        got = xyz(at.shots[-1].particle.acceleration)
        expect_close(got, (0.0, -20.0, 0.0))


@pytest.mark.exercise("B4.2")
def test_azimuth_and_elevation_are_both_heeded(rng: Random) -> None:
    azimuth, elevation = round(rng.uniform(0.3, 1.2), 3), round(rng.uniform(0.3, 1.2), 3)
    about.call = f'r.fire("artillery", {azimuth}, {elevation}); r.shots[-1].particle.velocity'
    about(cause="Both angles were given, so pass both to aim.", read="the docstring of fire")
    at = BallisticRange()
    at.fire("artillery", azimuth, elevation)
    level = 50.0 * math.cos(elevation)
    wanted = (level * math.sin(azimuth), 50.0 * math.sin(elevation), level * math.cos(azimuth))
    got = xyz(at.shots[-1].particle.velocity)
    mistakes = [
        (
            (0.0, 50.0 * math.sin(elevation), level),
            (
                "You ignored the azimuth, so the shot flies straight down the range. Pass it to "
                "aim along with the elevation."
            ),
        ),
        (
            (40.0 * math.sin(azimuth), 30.0, 40.0 * math.cos(azimuth)),
            (
                "You ignored the elevation, so the shot kept the angle of its type. Pass it to aim "
                "along with the azimuth."
            ),
        ),
    ]
    blame(got, mistakes)
    expect_close(got, wanted, tolerance=ROUNDED)


@pytest.mark.exercise("B4.2")
@pytest.mark.robust
def test_what_cannot_be_fired_is_refused_and_nothing_flies() -> None:
    about.cause = (
        "A call that raises an error must not add a shot. Look up the type and check the angles "
        "before you touch the list."
    )
    about.read = "the docstring of fire"
    at = BallisticRange()
    for call, attempt in (
        ('r.fire("cannon")', lambda: at.fire("cannon")),
        ('r.fire("pistol", azimuth=math.nan)', lambda: at.fire("pistol", azimuth=math.nan)),
        ('r.fire("pistol", elevation=math.inf)', lambda: at.fire("pistol", elevation=math.inf)),
    ):
        about.call = call
        expect_error(attempt, ValueError, allowed=lambda: BallisticRange().fire("pistol"))
        expect_exactly(len(at.shots), 0, then="; len(r.shots)")
