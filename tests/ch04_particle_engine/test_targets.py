"""Target blocks: where a path hits a block, exercise 4.3b."""

from __future__ import annotations

from collections.abc import Mapping
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch04_particle_engine.targets import TargetBlock, hit_fraction
from draw import Components, Triple, number, vector
from expect import about, expect_close, expect_exactly, expect_that, expect_unchanged, named

READ = "the docstring of hit_fraction"
# A box from (1, 2, 3) to (3, 6, 9): numbers that are exact in binary.
CENTER = SIZE = (2.0, 4.0, 6.0)
HIT = "a fraction from 0 to 1"
LARGEST = "Return the largest, because the path must be between the faces on all three axes."
ROUNDED = 1e-12  # some roundings of numbers up to 20, divided by at least 1


def expect_hit(got: Any, wanted: str = HIT, cause: str | None = None) -> None:
    """Expect any result but None."""
    __tracebackhide__ = True
    expect_that(got is not None, "None, which means a miss", wanted, cause=cause or about.cause)


def expect_path(
    start: Components,
    end: Components,
    wanted: float | str | None,
    cause: str,
    *,
    missed: str | None = None,
    slips: Mapping[str, float] | None = None,
    tolerance: float | None = None,
) -> None:
    """Expect a fraction for this path and the box, or any HIT, or None."""
    __tracebackhide__ = True
    with calls(
        cause,
        f"a box with corners at (1, 2, 3) and (3, 6, 9); hit_fraction(start=Vector3{start}, "
        f"end=Vector3{end}, block=box)",
    ):
        got = hit_fraction(
            Vector3(*start), Vector3(*end), TargetBlock(Vector3(*CENTER), SIZE, 10.0)
        )
    if wanted is None:
        expect_exactly(got, None)
    elif isinstance(wanted, str):
        expect_hit(got)
    else:
        expect_hit(got, f"{wanted:.6g}", missed)
        expect_close(got, wanted, slips, tolerance=tolerance)


@pytest.mark.exercise("4.3b", asks="ask whether the path from the start to the end", read=READ)
def test_a_fast_shot_does_not_pass_through_a_thin_block(rng: Random) -> None:
    z = round(rng.uniform(10.2, 11.4), 3)
    cause = "Return the fraction of the path before the near face: 0 at its start, 1 at its end."
    with calls(cause):
        block = TargetBlock(Vector3(0.0, 1.0, z), size=(2.0, 2.0, 0.01), mass=10.0)
        got = hit_fraction(start=Vector3(0, 1, 10), end=Vector3(0.1, 1.1, 11.67), block=block)
    wanted = (z - 0.005 - 10.0) / 1.67
    slips = {
        "You treat the block as twice as thick as it is. Each number in size is the length of a "
        "whole side, so a face is only half that length from the center.": (z - 10.01) / 1.67,
        "You return the fraction at which the shot leaves the block. Return the fraction at which "
        "it enters it.": (z + 0.005 - 10.0) / 1.67,
        "You treat the position of the block as its near face, but it is the center. The near "
        "face is half a side closer.": (z - 10.0) / 1.67,
        "You return the length of the path up to the block, in m. Divide it by the length of the "
        "whole path to get the fraction.": wanted * abs(Triple((0.1, 0.1, 1.67))),
        f"You return the smallest of the three entry fractions. {LARGEST}": -10.0,
        "You return the entry fraction of the X axis alone, perhaps because the return statement "
        "is inside the loop. Return the largest fraction after the loop.": 0.0,
    }
    if got is True:
        cause = "You return True for a hit. Return the fraction instead, and None for a miss."
    ends = "You test only the ends of the path, but it passes through the block. Test all of it."
    expect_hit(got, f"{wanted:.6g}", ends)
    expect_close(got, wanted, cause=named(got, cause, slips), tolerance=ROUNDED)


@pytest.mark.exercise("4.3b", asks="enters the block at the latest of the three entries", read=READ)
def test_a_path_hits_the_box_where_it_enters() -> None:
    cause = "Return the largest of the entry fractions of the three axes."
    for start, end, wanted in (
        ((1.5, 3.0, 1.0), (2.5, 5.0, 9.0), 0.25),
        ((1.5, 3.0, 17.0), (2.5, 5.0, 1.0), 0.5),
        ((-1.0, 3.0, 4.0), (7.0, 5.0, 8.0), 0.25),
        ((1.5, 10.0, 4.0), (2.5, -6.0, 8.0), 0.25),
        # Past the box on Z before the end of the way, and between its other faces by then.
        ((0.0, 3.0, 0.0), (4.0, 5.0, 16.0), 0.25),
        ((4.0, 5.0, 16.0), (0.0, 3.0, 0.0), 0.4375),
    ):
        back = [axis for axis, s, e in zip("XYZ", start, end, strict=True) if e < s]
        missed = None
        if back:
            missed = (
                f"This path goes in the negative {back[0]} direction, so it reaches the face with "
                f"the larger {back[0].lower()} first. On each axis, the smaller of the two "
                "fractions is the entry."
            )
        faces = zip(start, end, CENTER, SIZE, strict=True)
        entries = [min((c - w - s) / (e - s) for w in (n / 2, -n / 2)) for s, e, c, n in faces]
        slips = {
            f"You return the smallest of the three entry fractions. {LARGEST}": min(entries),
            f"You return the entry fraction of the last axis. {LARGEST}": max(0.0, entries[2]),
        }
        expect_path(start, end, wanted, cause, missed=missed, slips=slips)


@pytest.mark.exercise("4.3b", asks="when the shot does not move along an axis", read=READ)
def test_a_path_along_one_axis_needs_no_division_on_the_others() -> None:
    cause = (
        "Along two of the axes, the displacement of this path is 0, so you cannot divide by it. "
        "On these axes, check only whether the path is between the two faces."
    )
    missed = (
        "This path is parallel to one axis, and it hits the box. For the other two axes, return "
        "None only if the path is not between the two faces."
    )
    for start, end, wanted in (
        ((2.0, 4.0, 1.0), (2.0, 4.0, 9.0), 0.25),
        ((2.0, 4.0, 17.0), (2.0, 4.0, 1.0), 0.5),
        ((-1.0, 4.0, 6.0), (7.0, 4.0, 6.0), 0.25),
    ):
        expect_path(start, end, wanted, cause, missed=missed)


@pytest.mark.exercise("4.3b", asks="enters the block at the latest of the three entries", read=READ)
def test_a_slanting_path_enters_at_the_last_of_three_faces(rng: Random) -> None:
    # From outside on all axes to the middle of the box: entered at the greatest of the three.
    sizes = tuple(round(rng.uniform(1.0, 3.0), 3) for _ in range(3))
    center, away = vector(rng), tuple(number(rng, 4.0, 9.0) for _ in range(3))
    for sign, turn in ((1.0, 0), (-1.0, 0), (1.0, 1), (1.0, 2)):  # the last face on each axis
        sizes, away = sizes[turn:] + sizes[:turn], away[turn:] + away[:turn]
        start = center + sign * Triple(away)
        with calls(
            "On each axis, the path enters the space between the two faces of the box at some "
            "fraction. It enters the box at the largest of these three fractions."
        ):
            block = TargetBlock(Vector3(*center), size=sizes, mass=10.0)
            got = hit_fraction(start=Vector3(*start), end=Vector3(*center), block=block)
        wanted = max(1.0 - side / 2.0 / abs(a) for side, a in zip(sizes, away, strict=True))
        expect_hit(got, f"{wanted:.6g}")
        expect_close(got, wanted, tolerance=ROUNDED)


@pytest.mark.exercise("4.3b", asks="changes none of its arguments", read=READ)
def test_hit_fraction_changes_none_of_its_arguments(rng: Random) -> None:
    first, last, center = vector(rng), vector(rng), vector(rng)
    with calls("Your hit_fraction changes one of its arguments. Use plain numbers or new vectors."):
        start, end = Vector3(*first), Vector3(*last)
        block = TargetBlock(Vector3(*center), size=(1.0, 2.0, 3.0), mass=10.0)
        hit_fraction(start, end, block)
    expect_unchanged("start", start, first)
    expect_unchanged("end", end, last)
    expect_unchanged("block.particle.position", block.particle.position, center)
    # Where the first answer counts, so that this is no check of doing nothing.
    cause = "A path that starts inside the block hits it at once. Return 0 for it."
    with calls(cause, "three paths from the center of a block; the results of hit_fraction"):
        inside, other = Vector3(*center), Vector3(*(2.0 * center - last))
        answers = [hit_fraction(inside, there, block) for there in (end, end, other)]
    if any(isinstance(answer, (int, float)) and answer < 0.0 for answer in answers):
        cause = f"You return a negative fraction. {cause}"
    expect_hit(answers[0])
    expect_close(answers, (0.0, 0.0, 0.0), tolerance=0.0, cause=cause)


@pytest.mark.exercise("4.3b", asks="path that misses it gives None", read=READ)
def test_a_path_beside_before_or_behind_the_box_misses() -> None:
    behind = "so it misses. Return None if the whole box is behind the start."
    for start, end, wanted, cause in (
        ((3.5, 4.0, 1.0), (3.5, 4.0, 9.0), None,
         "This path is parallel to Z at x = 3.5, beside the box, so it misses. Return None."),
        ((2.9, 4.0, 1.0), (2.9, 4.0, 9.0), HIT,
         "This path is parallel to Z at x = 2.9, between x = 1 and x = 3, so it hits the box."),
        ((1.1, 4.0, 1.0), (1.1, 4.0, 9.0), HIT,
         "This path hits the box, because x = 1.1 is between the faces at x = 1 and x = 3. If you "
         "compare its distance from the center with half a side, use the absolute value."),
        ((2.0, 1.5, 1.0), (2.0, 1.5, 9.0), None,
         "This path runs at y = 1.5, below the box, so it misses. Return None."),
        ((2.0, 4.0, 0.0), (2.0, 4.0, 2.9), None,
         "This path ends at z = 2.9, before the box begins. Return None for a fraction above 1."),
        ((2.0, 4.0, 9.5), (2.0, 4.0, 20.0), None,
         f"This path starts behind the box and leads away from it, {behind}"),
        ((2.0, 4.0, -1.0), (2.0, 4.0, -9.0), None, f"This path leads away from the box, {behind}"),
    ):  # fmt: skip
        expect_path(start, end, wanted, cause)


@pytest.mark.exercise("4.3b", asks="If the latest entry comes after the earliest exit", read=READ)
def test_a_path_past_a_corner_misses() -> None:
    beside = "This path is never between the faces on X and on Z at the same time. Return None."
    through = "A part of this path is between the faces on all three axes, so it hits the box."
    expect_path((0.0, 4.0, 8.0), (4.0, 4.0, 16.0), None, beside)
    expect_path((0.0, 4.0, 4.0), (4.0, 4.0, 8.0), HIT, through)
    expect_path((4.0, 4.0, 4.0), (2.0, 4.0, 1.0), None, beside)


@pytest.mark.exercise("4.3b", asks="only touches the block counts as a hit", read=READ)
def test_a_touch_and_a_start_inside_count_as_hits() -> None:
    along = "A touch counts as a hit. Return the fraction at which the path first touches the face."
    at_once = "inside the box, so it hits the box at once. Return 0."
    for start, end, wanted, cause in (
        ((2.0, 4.0, 1.0), (2.0, 4.0, 3.0), 1.0,
         "You don't count a path that ends exactly on a face as a hit. A touch counts: return 1."),
        ((3.0, 4.0, 1.0), (3.0, 4.0, 9.0), 0.25, along),
        ((1.0, 4.0, 1.0), (1.0, 4.0, 9.0), 0.25, along),
        ((2.0, 4.0, 9.0), (2.0, 4.0, 12.0), 0.0,
         "This path starts exactly on a face of the box. A touch counts as a hit, so return 0."),
        ((2.0, 4.0, 5.0), (2.0, 4.0, 30.0), 0.0, f"This path starts {at_once}"),
        ((2.0, 4.0, 5.0), (2.5, 5.0, 7.0), 0.0, f"This path starts and ends {at_once}"),
        ((2.0, 4.0, 5.0), (2.0, 4.0, 5.0), 0.0, f"This path has no length, but it is {at_once}"),
        ((2.0, 4.0, 2.0), (2.0, 4.0, 2.0), None,
         "This path has no length and is outside the box, so it misses. Return None."),
    ):  # fmt: skip
        expect_path(start, end, wanted, cause, tolerance=0.0)
