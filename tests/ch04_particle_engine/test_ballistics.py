"""Aiming and firing: mini-project 4.3, first part, and build task B4.2."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch04_particle_engine import ballistics
from ch04_particle_engine.ballistics import BallisticRange
from expect import about, blame, cause_of, expect_close, expect_error, expect_exactly, xyz

# The book's table, and the numbers of the grenade: mass, velocity, acceleration, damping.
TABLE = {
    "pistol": (2.0, (0.0, 0.0, 35.0), (0.0, -1.0, 0.0), 0.99),
    "artillery": (200.0, (0.0, 30.0, 40.0), (0.0, -20.0, 0.0), 0.99),
    "fireball": (1.0, (0.0, 0.0, 10.0), (0.0, 0.6, 0.0), 0.9),
    "laser": (0.1, (0.0, 0.0, 100.0), (0.0, 0.0, 0.0), 0.99),
    "grenade": (0.6, (0.0, 12.0, 12.0), (0.0, -10.0, 0.0), 0.9),
}
QUARTER = math.pi / 2.0

ROUNDED = 1e-12  # some roundings of numbers up to 100, and of a sine or a root


def types_of(at: Any) -> tuple[str, ...]:
    """Return the types of the shots in flight."""
    return tuple(shot.type for shot in at.shots)


# 4.3a Aiming


@pytest.mark.exercise("4.3a")
def test_the_axes_of_aiming(rng: Random) -> None:
    speed = round(rng.uniform(2.0, 90.0), 3)
    about.read = "the docstring of aim"
    for azimuth, elevation, wanted, cause in (
        (0.0, 0.0, (0.0, 0.0, speed), "straight down the range: along Z"),
        (QUARTER, 0.0, (speed, 0.0, 0.0), "a quarter of a turn of azimuth is along X"),
        (0.0, QUARTER, (0.0, speed, 0.0), "a quarter of a turn of elevation is straight up"),
        (0.0, -QUARTER, (0.0, -speed, 0.0), "a negative elevation is down"),
    ):
        about(f"aim({speed}, {azimuth}, {elevation})", cause=cause)
        got = xyz(ballistics.aim(speed, azimuth, elevation))
        small = math.radians(QUARTER)
        degrees = "the angles are in radians already: take math.radians out"
        mistakes = {
            (0.0, 0.0): [
                ((speed, 0.0, 0.0), "the azimuth is measured from Z, not from X"),
                ((0.0, speed, 0.0), "the elevation is measured from the level, not from above"),
            ],
            (QUARTER, 0.0): [
                ((-speed, 0.0, 0.0), "the azimuth turns from Z towards X, not the other way"),
                ((speed * math.sin(small), 0.0, speed * math.cos(small)), degrees),
            ],
            (0.0, QUARTER): [
                (
                    (0.0, speed, speed),
                    "of a shot that goes up, speed x cos(elevation) is left along the ground",
                ),
                ((0.0, -speed, 0.0), "a positive elevation is up"),
                ((0.0, speed * math.sin(small), speed * math.cos(small)), degrees),
            ],
        }
        blame(got, mistakes.get((azimuth, elevation), []))
        # The cosine of a quarter of a turn is 6e-17, not 0.
        expect_close(got, wanted)


@pytest.mark.exercise("4.3a")
def test_azimuth_and_elevation_together(rng: Random) -> None:
    speed = round(rng.uniform(2.0, 90.0), 3)
    azimuth, elevation = round(rng.uniform(0.4, 1.1), 3), round(rng.uniform(0.4, 1.1), 3)
    about.cause = "what is up is speed x sin(elevation); speed x cos(elevation) is left along the "
    about.cause += "ground, and the azimuth shares that out between X and Z"
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
    about.cause = "finite and not_negative of arguments.py, in chapter 2, refuse it in one line"
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
    about.cause = "one Shot of that type is added to the shots"
    about.read = "the docstring of fire; book 4.1.2"
    at = BallisticRange()
    at.fire(name)
    expect_exactly(types_of(at), (name,), then=", their types")
    shot = at.shots[0]
    about.cause = "a shot that has just been fired has the age 0"
    expect_close(shot.age, 0.0, then="[0].age")
    p, own = shot.particle, f"{about.call}[0].particle"
    about.cause = "every shot starts at MUZZLE"
    expect_close(xyz(p.position), (0.0, 1.5, 0.0), call=f"{own}.position")
    _, up, along = velocity
    speed = math.hypot(up, along)
    mistakes = [
        (
            (0.0, 0.0, speed),
            "without an elevation the shot is not level: it has the angle of its type's velocity",
        ),
        (
            (0.0, up * along / speed, along * along / speed),
            "the speed is the length of the type's velocity, not its Z alone",
        ),
    ]
    about.cause = cause_of(xyz(p.velocity), mistakes, "not aimed, it has the velocity of its type")
    expect_close(xyz(p.velocity), velocity, call=f"{own}.velocity")
    about.cause = "the Particle is given the acceleration of its type"
    expect_close(xyz(p.acceleration), acceleration, call=f"{own}.acceleration")
    about.cause = "the Particle is given the mass of its type"
    expect_close(p.mass, mass, call=f"{own}.mass")
    about.cause = "the Particle is given the damping of its type"
    expect_close(p.damping, damping, call=f"{own}.damping")


@pytest.mark.exercise("B4.2")
def test_shots_stand_in_the_order_in_which_they_were_fired_and_have_nothing_in_common(
    rng: Random,
) -> None:
    names = rng.sample(sorted(TABLE), 3)
    names.append(names[0])
    calls = "; ".join(f'r.fire("{name}")' for name in names)
    about(f"r = BallisticRange(); {calls}; r.shots", cause="append the new shot behind the others")
    about.read = "the docstring of BallisticRange"
    at = BallisticRange()
    for name in names:
        at.fire(name)
    expect_exactly(types_of(at), tuple(names), then=", their types")
    about.cause = "each shot has a particle of its own, and each range its own shots"
    at.shots[0].particle.velocity.x = 99.0
    about.call = f"{about.call}[0].particle.velocity.x = 99.0; r.shots[3].particle.velocity.x"
    got = at.shots[3].particle.velocity.x
    expect_close(got, 0.0, tolerance=ROUNDED)
    about.call = f"{about.call}; BallisticRange().shots, how many"
    expect_exactly(len(BallisticRange().shots), 0)


@pytest.mark.exercise("B4.2")
def test_an_azimuth_turns_the_shot_and_keeps_its_own_elevation(rng: Random) -> None:
    azimuth = round(rng.uniform(0.3, 1.2), 3)
    about.read = "the docstring of fire"
    for name, up, along in (("artillery", 30.0, 40.0), ("pistol", 0.0, 35.0)):
        about.call = f'r.fire("{name}", azimuth={azimuth}); r.shots[-1].particle.velocity'
        about.cause = "the azimuth turns the type's velocity along the ground; what is up stays as "
        about.cause += "it is"
        at = BallisticRange()
        at.fire(name, azimuth=azimuth)
        wanted = (along * math.sin(azimuth), up, along * math.cos(azimuth))
        got = xyz(at.shots[-1].particle.velocity)
        unaimed = "that is the type's own velocity: the azimuth turns it"
        blame(got, [((0.0, up, along), unaimed)])
        expect_close(got, wanted, tolerance=ROUNDED)


@pytest.mark.exercise("B4.2")
def test_an_elevation_takes_the_place_of_the_type_s_own(rng: Random) -> None:
    about.read = "the docstring of fire"
    for elevation in (round(rng.uniform(0.3, 1.2), 3), 0.0):
        about.cause = "in place of the type's own, with the whole speed of 50 m/s, the velocity's "
        about.cause += "length"
        if elevation == 0.0:
            about.cause = "an elevation of 0 is level: ask whether it is None, since 0 counts as "
            about.cause += "false"
        about.call = f'r.fire("artillery", elevation={elevation}); r.shots[-1].particle.velocity'
        at = BallisticRange()
        at.fire("artillery", elevation=elevation)
        wanted = (0.0, 50.0 * math.sin(elevation), 50.0 * math.cos(elevation))
        got = xyz(at.shots[-1].particle.velocity)
        expect_close(got, wanted, tolerance=ROUNDED)
        about.cause = "gravity points down wherever the shot is aimed: only the velocity is turned"
        about.call = (
            f'r.fire("artillery", elevation={elevation}); r.shots[-1].particle.acceleration'
        )
        got = xyz(at.shots[-1].particle.acceleration)
        expect_close(got, (0.0, -20.0, 0.0))


@pytest.mark.exercise("B4.2")
def test_azimuth_and_elevation_are_both_heeded(rng: Random) -> None:
    azimuth, elevation = round(rng.uniform(0.3, 1.2), 3), round(rng.uniform(0.3, 1.2), 3)
    about.call = f'r.fire("artillery", {azimuth}, {elevation}); r.shots[-1].particle.velocity'
    about(cause="aim takes both, whichever of them is given", read="the docstring of fire")
    at = BallisticRange()
    at.fire("artillery", azimuth, elevation)
    level = 50.0 * math.cos(elevation)
    wanted = (level * math.sin(azimuth), 50.0 * math.sin(elevation), level * math.cos(azimuth))
    got = xyz(at.shots[-1].particle.velocity)
    mistakes = [
        ((0.0, 50.0 * math.sin(elevation), level), "with an elevation the azimuth is forgotten"),
        (
            (40.0 * math.sin(azimuth), 30.0, 40.0 * math.cos(azimuth)),
            "with an azimuth the elevation is forgotten",
        ),
    ]
    blame(got, mistakes)
    expect_close(got, wanted, tolerance=ROUNDED)


@pytest.mark.exercise("B4.2")
@pytest.mark.robust
def test_what_cannot_be_fired_is_refused_and_nothing_flies() -> None:
    about.cause = "look for the name first, and make the shot before it joins the others"
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
