"""Sparks that turn on the screen, going further G4.1."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch04_particle_engine.screen_rotation import screen_angle, screen_corners
from draw import number
from expect import expect_between, expect_close, named

ANGLE, CORNERS = "the docstring of screen_angle", "the docstring of screen_corners"
TURN = 2.0 * math.pi

ROUNDED = 1e-12  # some roundings of numbers up to 10, and of a sine


@pytest.mark.exercise("G4.1", asks="at time 0 and grows by rate per second", read=ANGLE)
def test_the_angle_grows_by_the_rate(rng: Random) -> None:
    start, drawn = round(rng.uniform(-0.5, 0.5), 3), round(rng.uniform(0.85, 1.0), 3)
    for rate in (drawn, -drawn):
        with calls(
            "The angle must be start + rate x time, reduced to the range from -pi to pi. With a "
            "negative rate it can become negative."
        ):
            got = screen_angle(start=start, rate=rate, time=2.5)
        angle = start + 2.5 * rate
        half, full = "half a turn (pi)", "Add or subtract only full turns of 2 pi."
        slips = {
            "You return the angle without its sign. A spark that rotates backward has a negative "
            "angle.": abs(angle),
            "You add the rate and the time. Multiply them to get the angle of the rotation.":
                math.remainder(start + rate + 2.5, TURN),
            "You leave out the start angle. Add start to rate x time.": 2.5 * rate,
            "You reduce the angle to the range from 0 to 2 pi, but it must be from -pi to pi. "
            "Subtract 2 pi if it is above pi.": angle + TURN,
            f"You add {half} to the angle. {full}": angle + math.pi,
            f"You subtract {half} from the angle. {full}": angle - math.pi,
        }  # fmt: skip
        expect_close(got, angle, slips, unit="rad", tolerance=1e-14)


@pytest.mark.exercise("G4.1", asks="Full turns make no difference on the screen", read=ANGLE)
def test_whole_turns_are_left_out(rng: Random) -> None:
    turns = rng.randint(10, 25)
    beyond = rng.uniform(0.3, 1.2), rng.uniform(3.5, 4.5)  # to either side of half a turn
    for drawn in (way * (turns * TURN + part) for way in (1.0, -1.0) for part in beyond):
        rate = round((drawn - 0.5) / 20.0, 3)
        cause = "The angle must be from -pi to pi. Add or subtract full turns of 2 pi until it is."
        with calls(cause):
            got = screen_angle(start=0.5, rate=rate, time=20.0)
        angle = 0.5 + 20.0 * rate
        slips = {
            "You return start + rate x time, which is outside the range from -pi to pi. Remove "
            "full turns of 2 pi from it.": angle,
            "You reduce the angle to the range from -2 pi to 2 pi, probably with math.fmod. Add or "
            "subtract one more turn if it is still outside -pi to pi.": math.fmod(angle, TURN),
            "You reduce the angle to the range from 0 to 2 pi. Subtract one more turn of 2 pi if "
            "it is above pi.": angle % TURN,
            "You remove only one full turn, but this angle contains many. Use math.remainder, "
            "which removes all of them.": angle - math.copysign(TURN, angle),
        }
        why = named(got, cause, slips)
        expect_between(got, -math.pi, math.pi, unit="rad", tolerance=1e-9, cause=why)
        expect_close(
            (math.cos(got), math.sin(got)),
            (math.cos(angle), math.sin(angle)),
            then="; the cosine and the sine of the result",
            tolerance=ROUNDED,
            cause="Your angle points in a different direction than start + rate x time. Remove "
            "only full turns of 2 pi, which leave the direction unchanged.",
        )


@pytest.mark.exercise("G4.1", asks="then lies between -pi and pi", read=ANGLE)
def test_angles_just_beyond_half_a_turn() -> None:
    for start, rate, time, wanted in (
        (0.0, 1.0, 4.0, 4.0 - TURN),
        (0.0, -1.0, 4.0, TURN - 4.0),
        (3.0, 1.0, 2.0, 5.0 - TURN),
        (-3.0, -1.0, 2.0, TURN - 5.0),
        (0.0, 1.0, 10.0, 10.0 - 2.0 * TURN),
        (0.0, -1.0, 10.0, 2.0 * TURN - 10.0),
    ):
        with calls(
            "The angle must be from -pi to pi. A rotation by more than half a turn in one "
            "direction equals a rotation by less than half a turn in the other direction."
        ):
            got = screen_angle(start=start, rate=rate, time=time)
        expect_close(got, wanted, tolerance=1e-14)


@pytest.mark.exercise("G4.1", asks="at the upper right at an angle of 0", read=CORNERS)
def test_the_corners_of_a_square(rng: Random) -> None:
    x, y, size = number(rng), number(rng), round(rng.uniform(0.5, 3.0), 3)
    half, quarter = size / 2.0, math.pi / 2.0

    def square(angle: float, cx: float = x, cy: float = y, grown: float = 1.0) -> list[float]:
        found = []
        for i in range(4):  # the corners are at 45 degrees, half a diagonal from the center
            direction, away = angle + math.pi / 4.0 + i * quarter, half * math.sqrt(2.0) * grown
            found += [cx + away * math.cos(direction), cy + away * math.sin(direction)]
        return found

    for angle, shown, cause in (
        (0.0, "0",
         "Start with the upper right corner, which is half a side from the center in x and in y. "
         "List the others in the direction from X toward Y."),
        (quarter, "math.pi / 2",
         "After a quarter turn from X toward Y, each corner must be where the next one was."),
        (round(rng.uniform(0.2, 1.2), 3), "",
         "Rotate each corner about the center by the angle t. A corner at (a, b) relative to the "
         "center moves to (a cos t - b sin t, a sin t + b cos t)."),
    ):  # fmt: skip
        with calls(
            cause,
            f"screen_corners(({x}, {y}), size={size}, angle={shown or angle}); x, y of each corner",
        ):
            corners = screen_corners((x, y), size, angle)
            got = [coordinate for corner in corners for coordinate in corner]
        wanted = square(angle)
        c, s = math.cos(angle), math.sin(angle)
        flipped: dict[str, list[float]] = {"x": [], "y": []}
        for a, b in ((half, half), (-half, half), (-half, -half), (half, -half)):
            flipped["x"] += [x + a * c + b * s, y + a * s + b * c]
            flipped["y"] += [x + a * c - b * s, y - a * s + b * c]
        unrotated = {
            "You don't rotate the square. Rotate each corner about the center by the angle.":
                square(0.0),
            "The angle is in radians already. Don't convert it with math.radians.":
                square(math.radians(angle)),
        }  # fmt: skip
        another = {
            "You treat size as half the length of a side, so your square is twice as large as it "
            "should be. It is the length of a whole side, so use half of it.":
                square(angle, grown=2.0),
            "You leave out the center, so your square is centered on the origin. Add the "
            "coordinates of the center to each corner.": square(angle, 0.0, 0.0),
            "You list the corners in the opposite order. List them in the direction of rotation, "
            "which is from X toward Y.": [*wanted[:2], *wanted[6:], *wanted[4:6], *wanted[2:4]],
        }  # fmt: skip
        start = "You start with another corner. Start at the upper right for an angle of 0."
        backward = {
            "You rotate the square from Y toward X. Rotate it from X toward Y.": square(-angle),
            **{
                f"The sine in your {name} has the wrong sign. A corner at (a, b) moves to (a cos t "
                "- b sin t, a sin t + b cos t) about the center.": result
                for name, result in flipped.items()
            },
        }
        why = named(got, cause, unrotated if angle == quarter else another)
        for i in (2, 4, 6):
            if angle != quarter:
                why = named(got, why, {start: [*wanted[i:], *wanted[:i]]})
        if angle:
            why = named(got, why, backward)
        expect_close(got, wanted, tolerance=ROUNDED, cause=why)
