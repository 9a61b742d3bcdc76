"""Angles, points and the center of mass in the plane, build tasks B9.1 to B9.3."""

from __future__ import annotations

import cmath
import math
from random import Random

import pytest

from calls import calls
from ch09_rotations.plane import angle_to_vector, center_of_mass, rotate_point, wrap_angle
from ch09_rotations.plane_probes import masses_after
from draw import number, positive_number
from expect import expect_close, expect_unchanged
from turning import TIGHT

Point = tuple[float, float]
WRAP = "book 9.1.1, and the docstring of wrap_angle"
UNIT = "book 9.1.1, Eq. 9.1"
POINT = "book 9.1, Eq. 9.2"
MASS = "book 9.1.3, and the docstring of center_of_mass"


@pytest.mark.exercise(
    "B9.1", asks="Convert an angle to the equivalent angle in the range", read=WRAP
)
def test_full_turns_are_removed_from_an_angle(rng: Random) -> None:
    for turns in (0, 1, -1, 7, -12):
        sizes = positive_number(rng, 0.01, 1.5), positive_number(rng, 1.6, 3.1)
        for angle in (sizes[0], -sizes[0], sizes[1], -sizes[1]):
            with calls("Add or subtract 2 pi until the angle is above -pi and at most pi."):
                got = wrap_angle(angle + turns * math.tau)
            off = "Your angle is too {} by pi. Either you add or subtract pi instead of full turns "
            off += "of 2 pi, or you use atan, which mixes up opposite directions."
            slips = {
                "You return an angle from 0 to 2 pi.": angle % math.tau,
                "You return the angle unchanged.": angle + turns * math.tau,
                "You return the angle in degrees. Return it in radians.": math.degrees(angle),
                off.format("large"): angle + math.pi,
                off.format("small"): angle - math.pi,
            }
            if turns == 0:
                slips[
                    "You add a full turn to an angle that is already in the range. Add one only to "
                    "an angle of -pi or less."
                ] = angle + math.tau
            if turns > 1:
                slips["You subtract only one full turn of 2 pi."] = angle + (turns - 1) * math.tau
            if turns < -1:
                slips["You add only one full turn of 2 pi."] = angle + (turns + 1) * math.tau
            expect_close(got, angle, slips, tolerance=TIGHT)


@pytest.mark.exercise(
    "B9.1", asks="remove them all at once and not one by one", weight=0.5, read=WRAP
)
def test_an_angle_of_many_turns_is_wrapped(rng: Random) -> None:
    size = positive_number(rng, 0.1, 3.0)
    for turns, angle in ((160_000, size), (160_000, -size), (-160_000, size), (-160_000, -size)):
        with calls("Remove all 160000 turns at once with math.remainder or %, not one by one."):
            got = wrap_angle(angle + turns * math.tau)
        # A loop that takes them off one by one makes as many rounding errors, of up to 6e-11 each.
        expect_close(got, angle, tolerance=2e-5)


@pytest.mark.exercise("B9.1", asks="are the same direction too, and both give pi", read=WRAP)
def test_half_a_turn_is_wrapped_to_pi_and_not_to_minus_pi() -> None:
    for sign in (1, -1):
        with calls("The angles pi and -pi point in the same direction, so return pi for both."):
            got = wrap_angle(sign * math.pi)
        slips = {"You return -pi, but the range includes pi and not -pi.": -math.pi}
        expect_close(got, math.pi, slips, tolerance=0.0)
        end = "pi" if sign > 0 else "-pi"
        with calls(f"The angle is near {end}, but it is already in range. Return it unchanged."):
            got = wrap_angle(sign * (math.pi - 1e-6))
        expect_close(got, sign * (math.pi - 1e-6), tolerance=TIGHT)


@pytest.mark.exercise("B9.2", asks="as the unit vector (cos(angle), sin(angle))", read=UNIT)
def test_the_direction_of_an_angle(rng: Random) -> None:
    angle, small = positive_number(rng, 1.7, 3.0), positive_number(rng, 0.1, 1.4)
    for t in (angle, -angle, small, -small, small + 2.0 * math.tau, 0.0, 0.5 * math.pi, 4.0):
        with calls("Return (cos(angle), sin(angle)). The angle is already in radians."):
            got = angle_to_vector(t)
        x, y, taken = math.cos(t), math.sin(t), math.radians(t)
        slips = {
            "You swap sine and cosine. The cosine of the angle is x, and its sine is y.": (y, x),
            "You treat the angle as degrees.": (math.cos(taken), math.sin(taken)),
            "Your y has the wrong sign.": (x, -y),
            "Your x has the wrong sign.": (-x, y),
        }
        expect_close(got, (x, y), slips)


def slips_of(point: Point, angle: float, origin: Point) -> dict[str, Point]:
    """Return the results of likely mistakes when a point is rotated and moved."""
    start, place, turn = complex(*point), complex(*origin), cmath.rect(1.0, angle)
    end, (c, s) = place + start * turn, (turn.real, turn.imag)
    x = c * point[0] - s * point[1]
    way = "You ignore the sign of the angle. If it is negative, rotate clockwise."
    way = "Your rotation is clockwise." if angle > 0.0 else way
    ends = {
        way: place + start / turn,
        "You add origin before you rotate the point.": (start + place) * turn,
        "You rotate the point but don't add origin.": start * turn,
        "You add origin but don't rotate the point.": place + start,
        "You rotate the point about origin instead of (0, 0).": place + (start - place) * turn,
        "You treat the angle as degrees.": place + start * cmath.rect(1.0, math.radians(angle)),
        "You add only the x of origin. Add its y to the other component.": end - 1j * origin[1],
        "You add only the y of origin. Add its x to the other component.": end - origin[0],
        "You swap x and y of the result. Return (x, y).": complex(end.imag, end.real),
        "You subtract origin. Add it instead.": end - 2.0 * place,
        "You swap sine and cosine.": place + start * complex(s, c),
        "The sine term of x has the wrong sign.": end + 2.0 * s * point[1],
        "The sine term of y has the wrong sign.": end - 2j * s * point[0],
        "You compute y from the new x.": place + complex(x, s * x + c * point[1]),
    }
    return {name: (end.real, end.imag) for name, end in ends.items()}


def expect_point(point: Point, angle: float, origin: Point, wanted: Point, near: float) -> None:
    """Expect where rotate_point moves a point."""
    with calls(
        "Rotate the point first, which gives (x cos t - y sin t, x sin t + y cos t) for an angle "
        "t, and then add origin."
    ):
        got = rotate_point(point=point, angle=angle, origin=origin)
    expect_close(got, wanted, slips_of(point, angle, origin), tolerance=near)


@pytest.mark.exercise("B9.2", asks="Convert a point from the coordinates of an object", read=POINT)
def test_the_headlight_of_the_book() -> None:
    # The headlight at (1.5, -0.75) of a car at (4, 3.85). The book gives two decimals.
    expect_point((1.5, -0.75), 3.0 * math.pi / 8.0, (4.0, 3.85), (5.27, 4.95), near=0.006)


@pytest.mark.exercise("B9.2", asks="Rotate point first and then add origin", read=POINT)
def test_a_point_is_turned_and_then_moved(rng: Random) -> None:
    for sign in (1.0, -1.0, 1.0):
        point, origin = (number(rng), number(rng)), (number(rng), number(rng))
        angle = sign * positive_number(rng, 0.3, 2.9)
        end = complex(*origin) + complex(*point) * cmath.rect(1.0, angle)
        expect_point(point, angle, origin, (end.real, end.imag), near=TIGHT)


SUMS = "Add up m x and m y over all masses, and then divide both sums by the sum of the masses."


@pytest.mark.exercise("B9.3", asks="their mean position, weighted by their masses", read=MASS)
def test_the_center_of_two_masses_is_nearer_to_the_larger() -> None:
    with calls(SUMS):
        got = center_of_mass([6.0, 2.0], [(4.0, 0.0), (0.0, 8.0)])
    slips = {
        "You return the sums of m x and m y. Divide both by the total mass.": (24.0, 16.0),
        "You divide by the number of masses. Divide by the total mass instead.": (12.0, 8.0),
        "You return the mean of the positions, which ignores the masses.": (2.0, 4.0),
        "You swap the masses. Multiply each position by its own mass.": (1.0, 6.0),
        "You count only the first mass. Return after the loop, not in it.": (3.0, 0.0),
        "You count only the last mass. Set the sums to 0 before the loop, not in it.": (0.0, 2.0),
        "You don't divide the sum of m y.": (3.0, 16.0),
        "You don't divide the sum of m x.": (24.0, 2.0),
        "You swap x and y. Return (x, y).": (2.0, 3.0),
        "Your y is computed from the x of the positions. Use p[1] for it.": (3.0, 3.0),
        "Your x is computed from the y of the positions. Use p[0] for it.": (2.0, 2.0),
        "Your shares of the mass are rounded down to 0. Divide with /, not with //.": (0.0, 0.0),
    }
    expect_close(got, (3.0, 2.0), slips)
    with calls("Two of the bodies are at the same position. Count both, each with its own mass."):
        got = center_of_mass([1.0, 3.0, 4.0], [(8.0, 0.0), (8.0, 0.0), (0.0, 4.0)])
    slips = {
        "Two of the bodies are at the same position, and you use the mass of the first one for "
        "both, as positions.index does. Use zip to go through both lists together.": (2.0, 2.0)
    }
    expect_close(got, (4.0, 2.0), slips)


@pytest.mark.exercise("B9.3", asks="Both may be lists or tuples, and several masses", read=MASS)
def test_the_center_of_many_masses(rng: Random) -> None:
    for count in (1, 2, 5):
        masses = [positive_number(rng) for _ in range(count)]
        masses[-1] = masses[0]  # equal masses must work too
        positions = [(number(rng), number(rng)) for _ in range(count)]
        with calls(SUMS):
            got = center_of_mass([*masses], [*positions])
        pairs = list(zip(masses, positions, strict=True))
        wanted, by_mass = (
            [math.fsum(m * p[n] for m, p in each) / math.fsum(m for m, _ in each) for n in (0, 1)]
            for each in (pairs, dict(pairs).items())
        )
        slips = {
            "Your result is rounded down to a whole number, as // does. Divide with / instead.":
                [math.floor(w) for w in wanted],
            "You lose one of two equal masses, as a dictionary by mass does. Use zip.": by_mass,
        }  # fmt: skip
        expect_close(got, wanted, slips, tolerance=TIGHT)
        after = masses_after(masses, positions)
        for name, now, before in (("masses", after[0], masses), ("positions", after[1], positions)):
            cause = f"Your function changes the caller's list of {name}, as pop and sort do. Work "
            expect_unchanged(name, now, before, cause=f"{cause}on a copy of the list.")
        of, at = tuple(masses), tuple(positions)
        with calls("Both may be tuples too, so don't use methods that only lists have."):
            got = center_of_mass(of, at)
        expect_close(got, wanted, tolerance=TIGHT)
