"""Angles, points and the center of mass in the plane, build tasks B9.1 to B9.3."""

from __future__ import annotations

import cmath
import math
from random import Random

import pytest

from ch09_rotations.plane import angle_to_vector, center_of_mass, rotate_point, wrap_angle
from ch09_rotations.plane_probes import masses_after
from draw import number, positive_number
from expect import about, blame, expect_close, expect_unchanged
from turning import TIGHT, named

Point = tuple[float, float]
WRAP = "book 9.1.1, and the docstring of wrap_angle"
POINT = "book 9.1, Eq. 9.2"
MASS = "book 9.1.3, and the docstring of center_of_mass"


@pytest.mark.exercise("B9.1", asks="Convert an angle to the equivalent angle in the range")
def test_full_turns_are_removed_from_an_angle(rng: Random) -> None:
    about.read = WRAP
    about.cause = (
        "Add or subtract full turns of 2 pi, which don't change the direction, until the angle is "
        "above -pi and at most pi."
    )
    for turns in (0, 1, -1, 7, -12):
        for low, high in ((0.01, 1.5), (1.6, 3.1)):
            size = positive_number(rng, low, high)
            for angle in (size, -size):
                whole = f" + {turns} * 2 pi" if turns else ""
                about.call = f"wrap_angle({angle}{whole})"
                got = wrap_angle(angle + turns * math.tau)
                slips = {
                    "You return an angle from 0 to 2 pi. Subtract 2 pi if the angle is above "
                    "pi.": angle % math.tau,
                    "You return the angle unchanged. Subtract its full turns of 2 pi, or add "
                    "them.": angle + turns * math.tau,
                    "You return the angle in degrees. Return it in radians.": math.degrees(angle),
                }
                for word, off in (("large", math.pi), ("small", -math.pi)):
                    slips[
                        f"Your angle is too {word} by pi. Either you add or subtract pi instead of "
                        "full turns of 2 pi, or you use atan, which mixes up opposite directions."
                    ] = angle + off
                if turns == 0:
                    slips[
                        "You add a full turn to an angle that is already in the range. Add one "
                        "only to an angle of -pi or less."
                    ] = angle + math.tau
                if turns > 1:
                    slips[
                        "You subtract only one full turn of 2 pi. Subtract as many as you need, "
                        "until the angle is at most pi."
                    ] = angle + (turns - 1) * math.tau
                if turns < -1:
                    slips[
                        "You add only one full turn of 2 pi. Add as many as you need, until the "
                        "angle is above -pi."
                    ] = angle + (turns + 1) * math.tau
                why = named(got, about.cause, slips)
                expect_close(got, angle, cause=why, tolerance=TIGHT)


@pytest.mark.exercise("B9.1", asks="remove them all at once and not one by one", weight=0.5)
def test_an_angle_of_many_turns_is_wrapped(rng: Random) -> None:
    about.read = WRAP
    about.cause = (
        "You remove the turns one by one, but this angle contains 160000 of them. Remove them all "
        "at once with math.remainder or %."
    )
    size = positive_number(rng, 0.1, 3.0)
    for turns, angle in ((160_000, size), (160_000, -size), (-160_000, size), (-160_000, -size)):
        about.call = f"wrap_angle({angle} + {turns} * 2 pi)"
        got = wrap_angle(angle + turns * math.tau)
        about.cause = "This angle contains 160000 full turns. Remove them all at once with "
        about.cause += "math.remainder or %."
        # A loop that takes them off one by one makes as many rounding errors, of up to 6e-11 each.
        expect_close(got, angle, tolerance=2e-5)


@pytest.mark.exercise("B9.1", asks="are the same direction too, and both give pi")
def test_half_a_turn_is_wrapped_to_pi_and_not_to_minus_pi() -> None:
    about.read = WRAP
    for angle in (math.pi, -math.pi):
        about.call = f"wrap_angle({'-' if angle < 0.0 else ''}math.pi)"
        about.cause = "The angles pi and -pi point in the same direction, so return pi for both."
        got = wrap_angle(angle)
        slip = "You return -pi, but the range includes pi and not -pi. Both point in the same "
        slip += "direction, so return pi."
        blame(got, {slip: -math.pi})
        expect_close(got, math.pi, tolerance=0.0)
    for angle in (1e-6 - math.pi, math.pi - 1e-6):
        end = "pi" if angle > 0.0 else "-pi"
        about.cause = f"This angle is close to {end}, but it is already in range, so return it "
        about.cause += "unchanged. Replace only -pi itself with pi."
        about.call = f"wrap_angle({'math.pi - 1e-6' if angle > 0.0 else '-math.pi + 1e-6'})"
        got = wrap_angle(angle)
        expect_close(got, angle, tolerance=TIGHT)


@pytest.mark.exercise("B9.2", asks="as the unit vector (cos(angle), sin(angle))")
def test_the_direction_of_an_angle(rng: Random) -> None:
    about.read = "book 9.1.1, Eq. 9.1"
    about.cause = (
        "Return the unit vector at this angle from the X axis: (cos(angle), sin(angle)), with the "
        "angle in radians."
    )
    angle, small = positive_number(rng, 1.7, 3.0), positive_number(rng, 0.1, 1.4)
    for t in (angle, -angle, small, -small, small + 2.0 * math.tau, 0.0, 0.5 * math.pi, 4.0):
        about.call = f"angle_to_vector({t})"
        got = angle_to_vector(t)
        wanted = (math.cos(t), math.sin(t))
        taken = math.radians(t)
        slips = {
            "You swap sine and cosine. The cosine of the angle is x, and its sine is y.": (
                math.sin(t),
                math.cos(t),
            ),
            "You treat the angle as degrees. It is already in radians, so don't convert it.": (
                math.cos(taken),
                math.sin(taken),
            ),
            "Your y has the wrong sign. Use math.sin(angle), which has the right sign for every "
            "angle.": (math.cos(t), -math.sin(t)),
            "Your x has the wrong sign. Use math.cos(angle), which has the right sign for every "
            "angle.": (-math.cos(t), math.sin(t)),
        }
        expect_close(got, wanted, cause=named(got, about.cause, slips))


def slips_of(point: Point, angle: float, origin: Point) -> dict[str, Point]:
    """Return the results of likely mistakes when a point is rotated and moved."""
    start, place, turn = complex(*point), complex(*origin), cmath.rect(1.0, angle)
    ends = {
        "Your rotation is clockwise. Swap the signs of the two sine terms to rotate "
        "counter-clockwise.": place + start / turn,
        "You add origin before you rotate the point, so you rotate origin too. Rotate the point "
        "first, and then add origin.": (start + place) * turn,
        "You rotate the point but don't add origin. Add it after the rotation.": start * turn,
        "You add origin but don't rotate the point. Rotate it first.": place + start,
        "You rotate the point about origin. The point is given relative to origin, so rotate it "
        "about (0, 0) first, and then add origin.": place + (start - place) * turn,
        "You treat the angle as degrees. It is already in radians, so don't convert it.": place
        + start * cmath.rect(1.0, math.radians(angle)),
    }
    end = place + start * turn
    swapped = start * complex(turn.imag, turn.real)
    ends |= {
        "You add only the x of origin. Add its y to the other component.": end - 1j * origin[1],
        "You add only the y of origin. Add its x to the other component.": end - origin[0],
        "You swap x and y of the result. Return (x, y).": complex(end.imag, end.real),
        "You subtract origin. Add it instead.": end - 2.0 * place,
        "You swap sine and cosine. The rotated x is c x - s y, where c is the cosine and s is the "
        "sine.": place + swapped,
        "The sine term of x has the wrong sign. The rotated x is c x - s y.": end
        + 2.0 * turn.imag * point[1],
        "The sine term of y has the wrong sign. The rotated y is s x + c y.": end
        - 2j * turn.imag * point[0],
    }
    # y computed from an x that has been changed already.
    x = turn.real * point[0] - turn.imag * point[1]
    ends["You compute y from the new x. Use the old x in both formulas."] = place + complex(
        x, turn.imag * x + turn.real * point[1]
    )
    return {name: (end.real, end.imag) for name, end in ends.items()}


@pytest.mark.exercise("B9.2", asks="Convert a point from the coordinates of an object")
def test_the_headlight_of_the_book() -> None:
    about(
        "a headlight at (1.5, -0.75) on a car at (4, 3.85); "
        "rotate_point(point=(1.5, -0.75), angle=3 pi / 8, origin=(4, 3.85))",
        read=POINT,
    )
    about.cause = (
        "The point is given relative to the car, so rotate it counter-clockwise about (0, 0) "
        "first, and then add the position of the car."
    )
    got = rotate_point((1.5, -0.75), 3.0 * math.pi / 8.0, (4.0, 3.85))
    about.cause = named(got, about.cause, slips_of((1.5, -0.75), 3.0 * math.pi / 8.0, (4.0, 3.85)))
    # The book's two decimals.
    expect_close(got, (5.27, 4.95), tolerance=0.006)


@pytest.mark.exercise("B9.2", asks="Rotate point first and then add origin")
def test_a_point_is_turned_and_then_moved(rng: Random) -> None:
    about.read = POINT
    for sign in (1.0, -1.0, 1.0):
        x, y, across, up = (number(rng) for _ in range(4))
        angle = sign * positive_number(rng, 0.3, 2.9)
        about.call = f"rotate_point(point=({x}, {y}), angle={angle}, origin=({across}, {up}))"
        about.cause = (
            "Rotate the point first, which gives (x cos t - y sin t, x sin t + y cos t) for an "
            "angle t, and then add origin."
        )
        got = rotate_point((x, y), angle, (across, up))
        about.cause = named(got, about.cause, slips_of((x, y), angle, (across, up)))
        end = complex(across, up) + complex(x, y) * complex(math.cos(angle), math.sin(angle))
        expect_close(got, (end.real, end.imag), tolerance=TIGHT)


@pytest.mark.exercise("B9.3", asks="their mean position, weighted by their masses")
def test_the_center_of_two_masses_is_nearer_to_the_larger() -> None:
    about("center_of_mass([6, 2], [(4, 0), (0, 8)])", read=MASS)
    about.cause = (
        "Add up m x and m y over all masses, and then divide both sums by the sum of the masses."
    )
    got = center_of_mass([6.0, 2.0], [(4.0, 0.0), (0.0, 8.0)])
    slips = {
        "You return the sums of m x and m y. Divide both by the total mass.": (24.0, 16.0),
        "You divide by the number of masses. Divide by the total mass instead.": (12.0, 8.0),
        "You return the mean of the positions, which ignores the masses. Multiply each position by "
        "its mass, and divide the sums by the total mass.": (2.0, 4.0),
        "You swap the masses. Multiply each position by its own mass.": (1.0, 6.0),
        "You count only the first mass. If you use a loop, return the result after it, not inside "
        "it.": (3.0, 0.0),
        "You count only the last mass. If you use a loop, set the sums to 0 before it, not inside "
        "it.": (0.0, 2.0),
        "You don't divide the sum of m y. Divide both sums by the total mass.": (3.0, 16.0),
        "You don't divide the sum of m x. Divide both sums by the total mass.": (24.0, 2.0),
        "You swap x and y. Return (x, y).": (2.0, 3.0),
        "Your y is computed from the x of the positions. Use p[1] for it.": (3.0, 3.0),
        "Your x is computed from the y of the positions. Use p[0] for it.": (2.0, 2.0),
        "Your result is 0, as if each mass divided by the total mass were rounded down. Divide "
        "with /, not with //.": (0.0, 0.0),
    }
    expect_close(got, (3.0, 2.0), cause=named(got, about.cause, slips))
    about.call = "center_of_mass([1, 3, 4], [(8, 0), (8, 0), (0, 4)])"
    about.cause = "Two of the bodies are at the same position. Count both, each with its own mass."
    got = center_of_mass([1.0, 3.0, 4.0], [(8.0, 0.0), (8.0, 0.0), (0.0, 4.0)])
    same = "Two of the bodies are at the same position, and you use the mass of the first one for "
    same += "both, as positions.index does. Use zip to go through both lists together."
    expect_close(got, (4.0, 2.0), cause=named(got, about.cause, {same: (2.0, 2.0)}))


@pytest.mark.exercise("B9.3", asks="Both may be lists or tuples, and several masses")
def test_the_center_of_many_masses(rng: Random) -> None:
    about.read = MASS
    cause = (
        "Add up m x and m y over all masses, and then divide both sums by the sum of the masses, "
        "not by their number."
    )
    for count in (1, 2, 5):
        masses = [positive_number(rng) for _ in range(count)]
        masses[-1] = masses[0]  # equal masses must work too
        positions = [(number(rng), number(rng)) for _ in range(count)]
        about.call = f"center_of_mass({masses}, {positions})"
        about.cause = cause
        total = math.fsum(masses)
        pairs = list(zip(masses, positions, strict=True))
        wanted = [math.fsum(m * p[axis] for m, p in pairs) / total for axis in (0, 1)]
        got = center_of_mass([*masses], [*positions])
        last = dict(pairs)
        slips = {
            "Your result is rounded down to a whole number, as // does. Divide with / instead.": [
                math.floor(w) for w in wanted
            ],
            "You lose one of two equal masses, because you use the masses as dictionary keys. Use "
            "zip to go through both lists together.": [
                math.fsum(m * p[axis] for m, p in last.items()) / math.fsum(last) for axis in (0, 1)
            ],
        }
        why = named(got, about.cause, slips)
        expect_close(got, wanted, cause=why, tolerance=TIGHT)
        after = masses_after(masses, positions)
        for name, now, before in (("masses", after[0], masses), ("positions", after[1], positions)):
            about.cause = (
                f"Your function changes the caller's list of {name}, as pop and sort do. Work on a "
                "copy of the list."
            )
            expect_unchanged(name, now, before)
        about.cause = "The masses and positions may be tuples too, so don't use methods that only "
        about.cause += "lists have."
        about.call = f"center_of_mass({tuple(masses)}, {tuple(positions)})"
        got = center_of_mass(tuple(masses), tuple(positions))
        expect_close(got, wanted, tolerance=TIGHT)
