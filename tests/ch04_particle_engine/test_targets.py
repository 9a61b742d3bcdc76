"""Target blocks: where a path hits a block, exercise 4.3b."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch04_particle_engine import targets
from ch04_particle_engine.targets import TargetBlock
from draw import Components, components, number
from expect import about, blame, expect_close, expect_exactly, expect_that, expect_unchanged, xyz

READ = "the docstring of hit_fraction"
# A box from (1, 2, 3) to (3, 6, 9): numbers that are exact in binary.
CENTER, SIZE = (2.0, 4.0, 6.0), (2.0, 4.0, 6.0)

ROUNDED = 1e-12  # some roundings of numbers up to 20, divided by at least 1


def words(start: Components, end: Components) -> str:
    """Return the call for this box in words."""
    return (
        f"a box with corners at (1, 2, 3) and (3, 6, 9); hit_fraction(start=Vector3{start}, "
        f"end=Vector3{end}, block=box)"
    )


def expect_hit(got: Any, wanted: float | None = None, tolerance: float | None = None) -> None:
    """Expect this fraction, or any result but None."""
    __tracebackhide__ = True
    hit = "a fraction from 0 to 1" if wanted is None else f"{wanted:.6g}"
    expect_that(got is not None, "None, which means a miss", hit, read=READ)
    if wanted is not None:
        expect_close(got, wanted, read=READ, tolerance=tolerance)


def fraction(start: Components, end: Components) -> float | None:
    """Return what comes back for this box."""
    about.read = READ
    box = TargetBlock(Vector3(*CENTER), SIZE, mass=10.0)
    return targets.hit_fraction(Vector3(*start), Vector3(*end), box)


@pytest.mark.exercise("4.3b", asks="ask whether the path from the start to the end")
def test_a_fast_shot_does_not_pass_through_a_thin_block(rng: Random) -> None:
    about.read = READ
    z = round(rng.uniform(10.2, 11.4), 3)
    about.call = (
        f"a block with its center at (0, 1, {z}), which is 1 cm thick along Z; "
        "hit_fraction(start=Vector3(0, 1, 10), end=Vector3(0.1, 1.1, 11.67), block=block)"
    )
    about.cause = (
        "Return the fraction of the path after which the shot reaches the near face of the block: "
        "0 at the start of the path, 1 at its end."
    )
    block = TargetBlock(Vector3(0.0, 1.0, z), (2.0, 2.0, 0.01), mass=10.0)
    got = targets.hit_fraction(Vector3(0.0, 1.0, 10.0), Vector3(0.1, 1.1, 11.67), block)
    wanted = (z - 0.005 - 10.0) / 1.67
    mistakes = [
        (
            (z - 0.01 - 10.0) / 1.67,
            "You treat the block as twice as thick as it is. Each number in size is the length of "
            "a whole side, so a face is only half that length from the center.",
        ),
        (
            (z + 0.005 - 10.0) / 1.67,
            "You return the fraction at which the shot leaves the block. Return the fraction at "
            "which it enters it.",
        ),
        (
            (z - 10.0) / 1.67,
            "You treat the position of the block as its near face, but it is the center. The near "
            "face is half a side closer.",
        ),
        (
            wanted * math.hypot(0.1, 0.1, 1.67),
            "You return the length of the path up to the block, in m. Divide it by the length of "
            "the whole path to get the fraction.",
        ),
        (
            -10.0,
            "You return the smallest of the three entry fractions. Return the largest of the "
            "three, because the path must be between the faces on all three axes.",
        ),
        (
            0.0,
            "You return the entry fraction of the X axis alone, perhaps because the return "
            "statement is inside the loop. Return the largest fraction after the loop.",
        ),
    ]
    blame(got, mistakes)
    if got is True:
        about.cause = "You return True for a hit. Return the fraction of the path instead, and "
        about.cause += "None for a miss."
    if got is None:
        about.cause = (
            "You test only the ends of the path, but this path starts in front of the block and "
            "ends behind it. Test the whole path."
        )
    expect_hit(got, wanted, ROUNDED)


@pytest.mark.exercise("4.3b", asks="enters the block at the latest of the three entries")
def test_a_path_hits_the_box_where_it_enters() -> None:
    smallest, last = (
        f"You return the {which}. Return the largest of the three, because the path must be "
        "between the faces on all three axes."
        for which in ("smallest of the three entry fractions", "entry fraction of the last axis")
    )
    for start, end, wanted in (
        ((1.5, 3.0, 1.0), (2.5, 5.0, 9.0), 0.25),
        ((1.5, 3.0, 17.0), (2.5, 5.0, 1.0), 0.5),
        ((-1.0, 3.0, 4.0), (7.0, 5.0, 8.0), 0.25),
        ((1.5, 10.0, 4.0), (2.5, -6.0, 8.0), 0.25),
        # Past the box on Z before the end of the way, and between its other faces by then.
        ((0.0, 3.0, 0.0), (4.0, 5.0, 16.0), 0.25),
        ((4.0, 5.0, 16.0), (0.0, 3.0, 0.0), 0.4375),
    ):
        about.call = words(start, end)
        about.cause = (
            "The path enters the box once it is between the two faces on all three axes. Return "
            "the largest of the three entry fractions."
        )
        got = fraction(start, end)
        back = [axis for axis, s, e in zip("XYZ", start, end, strict=True) if e < s]
        if got is None and back:
            about.cause = (
                f"This path goes in the negative {back[0]} direction, so it reaches the face with "
                f"the larger {back[0].lower()} first. On each axis, the smaller of the two "
                "fractions is the entry."
            )
        faces = zip(start, end, CENTER, SIZE, strict=True)
        entries = [min((c - w - s) / (e - s) for w in (n / 2, -n / 2)) for s, e, c, n in faces]
        blame(got, [(min(entries), smallest), (max(0.0, entries[2]), last)])
        expect_hit(got, wanted)


@pytest.mark.exercise("4.3b", asks="when the shot does not move along an axis")
def test_a_path_along_one_axis_needs_no_division_on_the_others() -> None:
    about.cause = (
        "Along two of the axes, the displacement of this path is 0, so you cannot divide by it. "
        "On these axes, check only whether the path is between the two faces."
    )
    for start, end, wanted in (
        ((2.0, 4.0, 1.0), (2.0, 4.0, 9.0), 0.25),
        ((2.0, 4.0, 17.0), (2.0, 4.0, 1.0), 0.5),
        ((-1.0, 4.0, 6.0), (7.0, 4.0, 6.0), 0.25),
    ):
        about.call = words(start, end)
        got = fraction(start, end)
        if got is None:
            about.cause = (
                "This path is parallel to one axis, and it hits the box. For the other two axes, "
                "return None only if the path is not between the two faces."
            )
        expect_hit(got, wanted)


@pytest.mark.exercise("4.3b", asks="enters the block at the latest of the three entries")
def test_a_slanting_path_enters_at_the_last_of_three_faces(rng: Random) -> None:
    about.read = READ
    about.cause = (
        "On each axis, the path enters the space between the two faces of the box at some "
        "fraction. It enters the box at the largest of these three fractions."
    )
    # From outside on all axes to the middle of the box: entered at the greatest of the three.
    sizes = tuple(round(rng.uniform(1.0, 3.0), 3) for _ in range(3))
    center = components(rng)
    away = tuple(number(rng, 4.0, 9.0) for _ in range(3))
    for sign, turn in ((1.0, 0), (-1.0, 0), (1.0, 1), (1.0, 2)):  # the last face on each axis
        sizes, away = sizes[turn:] + sizes[:turn], away[turn:] + away[:turn]
        start = tuple(c + sign * a for c, a in zip(center, away, strict=True))
        about.call = (
            f"block = TargetBlock(Vector3{center}, {sizes}, mass=10); "
            f"hit_fraction(start=Vector3{start}, end=Vector3{center}, block=block)"
        )
        block = TargetBlock(Vector3(*center), sizes, mass=10.0)
        got = targets.hit_fraction(Vector3(*start), Vector3(*center), block)
        wanted = max(1.0 - side / 2.0 / abs(a) for side, a in zip(sizes, away, strict=True))
        expect_hit(got, wanted, ROUNDED)


@pytest.mark.exercise("4.3b", asks="changes none of its arguments")
def test_hit_fraction_changes_none_of_its_arguments(rng: Random) -> None:
    start, end, center = components(rng), components(rng), components(rng)
    about.call = f"start, end = Vector3{start}, Vector3{end}; hit_fraction(start, end, block)"
    first, last = Vector3(*start), Vector3(*end)
    block = TargetBlock(Vector3(*center), (1.0, 2.0, 3.0), mass=10.0)
    about(
        cause="Your hit_fraction changes one of its arguments. Compute with plain numbers or with "
        "new vectors instead.",
        read=READ,
    )
    targets.hit_fraction(first, last, block)
    expect_unchanged("start", xyz(first), start)
    expect_unchanged("end", xyz(last), end)
    now = xyz(block.particle.position)
    expect_unchanged("block.particle.position", now, center)
    # Where the first answer counts, so that this is no check of doing nothing.
    inside = Vector3(*center)
    about.call = (
        "three paths that start at the center of a block; the result of hit_fraction for each of "
        "them"
    )
    other = Vector3(*(2.0 * c - e for c, e in zip(center, end, strict=True)))
    answers = [targets.hit_fraction(inside, there, block) for there in (last, last, other)]
    about.cause = "A path that starts inside the block hits it at once. Return 0 for it."
    if any(isinstance(answer, (int, float)) and answer < 0.0 for answer in answers):
        about.cause = (
            "You return a negative fraction for a path that starts inside the block. Such a path "
            "hits the block at once, so return 0."
        )
    expect_hit(answers[0])
    expect_close(answers, (0.0, 0.0, 0.0), tolerance=0.0)


@pytest.mark.exercise("4.3b", asks="path that misses it gives None")
def test_a_path_beside_before_or_behind_the_box_misses() -> None:
    for start, end, missed, cause in (
        (
            (3.5, 4.0, 1.0),
            (3.5, 4.0, 9.0),
            True,
            (
                "This path is parallel to Z and runs beside the box, at x = 3.5, so it never "
                "hits the box. Return None."
            ),
        ),
        (
            (2.9, 4.0, 1.0),
            (2.9, 4.0, 9.0),
            False,
            "This path runs parallel to Z at x = 2.9, which is between the faces at x = 1 and x = "
            "3, so it hits the box.",
        ),
        (
            (1.1, 4.0, 1.0),
            (1.1, 4.0, 9.0),
            False,
            "This path hits the box, because x = 1.1 is between the faces at x = 1 and x = 3. "
            "If you compare its distance from the center with half a side, use the absolute value.",
        ),
        (
            (2.0, 1.5, 1.0),
            (2.0, 1.5, 9.0),
            True,
            "This path runs at y = 1.5, below the box, so it misses. Return None.",
        ),
        (
            (2.0, 4.0, 0.0),
            (2.0, 4.0, 2.9),
            True,
            "This path ends at z = 2.9, just before the box, which begins at z = 3. Return None "
            "for a fraction above 1.",
        ),
        (
            (2.0, 4.0, 9.5),
            (2.0, 4.0, 20.0),
            True,
            "This path starts behind the box and leads away from it, so it misses. Return None if "
            "the whole box is behind the start.",
        ),
        (
            (2.0, 4.0, -1.0),
            (2.0, 4.0, -9.0),
            True,
            "This path leads away from the box, so it misses. Return None if the whole box is "
            "behind the start.",
        ),
    ):
        about(words(start, end), cause=cause)
        got = fraction(start, end)
        if missed:
            expect_exactly(got, None, read=READ)
        else:
            expect_hit(got)


@pytest.mark.exercise("4.3b", asks="If the latest entry comes after the earliest exit")
def test_a_path_past_a_corner_misses() -> None:
    beside = (
        "This path is never between the two faces on X and the two faces on Z at the same time. "
        "It misses the box, so return None."
    )
    through = (
        "A part of this path is between the two faces on X, on Y and on Z at the same time, so "
        "the path hits the box."
    )
    for start, end, missed, cause in (
        ((0.0, 4.0, 8.0), (4.0, 4.0, 16.0), True, beside),
        ((0.0, 4.0, 4.0), (4.0, 4.0, 8.0), False, through),
        ((4.0, 4.0, 4.0), (2.0, 4.0, 1.0), True, beside),
    ):
        about(words(start, end), cause=cause)
        got = fraction(start, end)
        if missed:
            expect_exactly(got, None, read=READ)
        else:
            expect_hit(got)


@pytest.mark.exercise("4.3b", asks="only touches the block counts as a hit")
def test_a_touch_and_a_start_inside_count_as_hits() -> None:
    along = (
        "This path runs along a face of the box. A touch counts as a hit, so return the fraction "
        "at which it first touches the face."
    )
    for start, end, wanted, cause in (
        (
            (2.0, 4.0, 1.0),
            (2.0, 4.0, 3.0),
            1.0,
            "You don't count a path that ends exactly on a face of the box as a hit. A touch "
            "counts, so return 1.",
        ),
        (
            (3.0, 4.0, 1.0),
            (3.0, 4.0, 9.0),
            0.25,
            along,
        ),
        (
            (1.0, 4.0, 1.0),
            (1.0, 4.0, 9.0),
            0.25,
            along,
        ),
        (
            (2.0, 4.0, 9.0),
            (2.0, 4.0, 12.0),
            0.0,
            "This path starts exactly on a face of the box. A touch counts as a hit, so return 0.",
        ),
        (
            (2.0, 4.0, 5.0),
            (2.0, 4.0, 30.0),
            0.0,
            "This path starts inside the box, so it hits the box at once. Return 0.",
        ),
        (
            (2.0, 4.0, 5.0),
            (2.5, 5.0, 7.0),
            0.0,
            "This path starts and ends inside the box, so it hits the box at once. Return 0.",
        ),
        (
            (2.0, 4.0, 5.0),
            (2.0, 4.0, 5.0),
            0.0,
            "This path has no length, but it is inside the box, so it hits the box at once. Return "
            "0.",
        ),
    ):
        about(words(start, end), cause=cause)
        got = fraction(start, end)
        expect_hit(got, wanted, 0.0)
    about(
        words((2.0, 4.0, 2.0), (2.0, 4.0, 2.0)),
        cause="This path has no length and is outside the box, so it misses. Return None.",
    )
    got = fraction((2.0, 4.0, 2.0), (2.0, 4.0, 2.0))
    expect_exactly(got, None, read=READ)
