"""Sparks that turn on the screen, going further G4.1."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch04_particle_engine import screen_rotation
from draw import number
from expect import about, blame, expect_between, expect_close

ANGLE, CORNERS = "the docstring of screen_angle", "the docstring of screen_corners"

ROUNDED = 1e-12  # some roundings of numbers up to 10, and of a sine


@pytest.mark.exercise("G4.1", asks="at time 0 and grows by rate per second")
def test_the_angle_grows_by_the_rate(rng: Random) -> None:
    about.read = ANGLE
    start, rate = round(rng.uniform(-0.5, 0.5), 3), round(rng.uniform(0.85, 1.0), 3)
    for turning in (rate, -rate):
        about.call = f"screen_angle(start={start}, rate={turning}, time=2.5)"
        about.cause = (
            "The angle must be start + rate x time, reduced to the range from -pi to pi. With a "
            "negative rate it can become negative."
        )
        got = screen_rotation.screen_angle(start, turning, 2.5)
        angle = start + 2.5 * turning
        mistakes = [
            (
                abs(angle),
                "You return the angle without its sign. A spark that rotates backward has a "
                "negative angle.",
            ),
            (
                math.remainder(start + turning + 2.5, 2.0 * math.pi),
                "You add the rate and the time. Multiply them to get the angle of the rotation.",
            ),
            (2.5 * turning, "You leave out the start angle. Add start to rate x time."),
            (
                angle + 2.0 * math.pi,
                "You reduce the angle to the range from 0 to 2 pi, but it must be from -pi to pi. "
                "Subtract 2 pi if it is above pi.",
            ),
            (
                angle + math.pi,
                "You add half a turn (pi) to the angle. Add or subtract only full turns of 2 pi.",
            ),
            (
                angle - math.pi,
                "You subtract half a turn (pi) from the angle. Add or subtract only full turns of "
                "2 pi.",
            ),
        ]
        blame(got, mistakes)
        expect_close(got, start + 2.5 * turning, unit="rad", tolerance=1e-14)


@pytest.mark.exercise("G4.1", asks="Full turns make no difference on the screen")
def test_whole_turns_are_left_out(rng: Random) -> None:
    about.read = ANGLE
    turns = rng.randint(10, 25)
    beyond = rng.uniform(0.3, 1.2), rng.uniform(3.5, 4.5)  # to either side of half a turn
    for angle in (way * (turns * 2.0 * math.pi + part) for way in (1.0, -1.0) for part in beyond):
        rate = round((angle - 0.5) / 20.0, 3)
        about.call = f"screen_angle(start=0.5, rate={rate}, time=20)"
        about.cause = (
            "The angle must be from -pi to pi. Add or subtract full turns of 2 pi until it is."
        )
        got = screen_rotation.screen_angle(0.5, rate, 20.0)
        angle, turn = 0.5 + 20.0 * rate, 2.0 * math.pi
        mistakes = [
            (
                angle,
                "You return start + rate x time, which is outside the range from -pi to pi. Remove "
                "full turns of 2 pi from it.",
            ),
            (
                math.fmod(angle, turn),
                "You reduce the angle to the range from -2 pi to 2 pi, probably with math.fmod. "
                "Add or subtract one more turn if it is still outside -pi to pi.",
            ),
            (
                angle % turn,
                "You reduce the angle to the range from 0 to 2 pi. Subtract one more turn of 2 pi "
                "if it is above pi.",
            ),
        ]
        mistakes += [
            (
                angle - way * turn,
                "You remove only one full turn, but this angle contains many. Use math.remainder, "
                "which removes all of them.",
            )
            for way in (1.0, -1.0)
        ]
        blame(got, mistakes)
        expect_between(got, -math.pi, math.pi, unit="rad", tolerance=1e-9)
        about.cause = (
            "Your angle points in a different direction than start + rate x time. Remove only full "
            "turns of 2 pi, which leave the direction unchanged."
        )
        direction = (math.cos(got), math.sin(got))
        wanted = (math.cos(angle), math.sin(angle))
        expect_close(
            direction, wanted, then="; the cosine and the sine of the result", tolerance=ROUNDED
        )


@pytest.mark.exercise("G4.1", asks="then lies between -pi and pi")
def test_angles_just_beyond_half_a_turn() -> None:
    about(
        cause=(
            "The angle must be from -pi to pi. A rotation by more than half a turn in one "
            "direction equals a rotation by less than half a turn in the other direction."
        ),
        read=ANGLE,
    )
    turn = 2.0 * math.pi
    for start, rate, time, wanted in (
        (0.0, 1.0, 4.0, 4.0 - turn),
        (0.0, -1.0, 4.0, turn - 4.0),
        (3.0, 1.0, 2.0, 5.0 - turn),
        (-3.0, -1.0, 2.0, turn - 5.0),
        (0.0, 1.0, 10.0, 10.0 - 2.0 * turn),
        (0.0, -1.0, 10.0, 2.0 * turn - 10.0),
    ):
        about.call = f"screen_angle(start={start}, rate={rate}, time={time})"
        got = screen_rotation.screen_angle(start, rate, time)
        expect_close(got, wanted, tolerance=1e-14)


@pytest.mark.exercise("G4.1", asks="at the upper right at an angle of 0")
def test_the_corners_of_a_square(rng: Random) -> None:
    x, y, size = number(rng), number(rng), round(rng.uniform(0.5, 3.0), 3)
    angle = round(rng.uniform(0.2, 1.2), 3)
    about.read = CORNERS
    half = size / 2.0
    for turned, cause in (
        (
            0.0,
            "Start with the upper right corner, which is half a side from the center in x and in "
            "y. List the others in the direction from X toward Y.",
        ),
        (
            math.pi / 2.0,
            "After a quarter turn, each corner must be where the next one was. Rotate the square "
            "from X toward Y by the angle.",
        ),
        (
            angle,
            "Rotate each corner about the center by the angle t. A corner at (a, b) relative "
            "to the center moves to (a cos t - b sin t, a sin t + b cos t).",
        ),
    ):
        shown = f"{turned:.6g}" if turned != math.pi / 2.0 else "math.pi / 2"
        about(
            f"screen_corners(center=({x}, {y}), size={size}, angle={shown}); x and y of each of "
            "the four corners, in order",
            cause=cause,
        )
        corners = screen_rotation.screen_corners((x, y), size, turned)
        got = [coordinate for corner in corners for coordinate in corner]
        wanted = []
        for i in range(4):  # the corners are at 45 degrees, half a diagonal from the center
            direction = turned + math.pi / 4.0 + i * math.pi / 2.0
            away = half * math.sqrt(2.0)
            wanted += [x + away * math.cos(direction), y + away * math.sin(direction)]
        center = (x, y) * 4
        doubled = [2.0 * n - c for n, c in zip(wanted, center, strict=True)]
        mistakes = [
            (
                doubled,
                "You treat size as half the length of a side, so your square is twice as large "
                "as it should be. It is the length of a whole side, so use half of it.",
            ),
            (
                [n - c for n, c in zip(wanted, center, strict=True)],
                "You leave out the center, so your square is centered on the origin. Add the "
                "coordinates of the center to each corner.",
            ),
            (
                [*wanted[:2], *wanted[6:], *wanted[4:6], *wanted[2:4]],
                "You list the corners in the opposite order. List them in the direction of "
                "rotation, which is from X toward Y.",
            ),
        ]
        for i in (2, 4, 6):
            start = "You start with another corner. Start with the one that is at the upper right "
            start += "at an angle of 0, and continue from X toward Y."
            mistakes.append(([*wanted[i:], *wanted[:i]], start))
        if turned == math.pi / 2.0:
            flat = "You don't rotate the square. Rotate each corner about the center by the angle."
            mistakes = [([*wanted[6:], *wanted[:6]], flat)]
            small = math.radians(turned) + math.pi / 4.0
            ways = [small + i * math.pi / 2.0 for i in range(4)]
            degrees = "The angle is in radians already. Don't convert it with math.radians."
            converted = [
                n for way in ways for n in (x + away * math.cos(way), y + away * math.sin(way))
            ]
            mistakes.append((converted, degrees))
        if turned:
            back = "You rotate the square from Y toward X. Rotate it from X toward Y."
            corner = math.pi / 4.0 - turned
            ways = [corner + i * math.pi / 2.0 for i in range(4)]
            turned_back = [
                n for way in ways for n in (x + away * math.cos(way), y + away * math.sin(way))
            ]
            mistakes.append((turned_back, back))
            for name, s in (("x", math.sin(turned)), ("y", -math.sin(turned))):
                c, flipped = math.cos(turned), []
                for a, b in ((half, half), (-half, half), (-half, -half), (half, -half)):
                    flipped += [x + a * c + b * s, y + a * s + b * c]
                sign = (
                    f"The sine in your {name} has the wrong sign. A corner at (a, b) moves to (a "
                    "cos t - b sin t, a sin t + b cos t) about the center."
                )
                mistakes.append((flipped, sign))
        blame(got, mistakes)
        expect_close(got, wanted, tolerance=ROUNDED)
