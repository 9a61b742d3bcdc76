"""Say in words which particles sleep, for the checks of the sleeping world."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import Unpack

from autograder.checks.asked import Words
from expect import expect_that


def expect_sleepers(got: Sequence[int], wanted: Sequence[int], **words: Unpack[Words]) -> None:
    """Expect exactly the particles with these numbers to sleep."""
    __tracebackhide__ = True
    expect_that(got == wanted, named(got), named(wanted), **words)


def expect_sleepers_of_steps(
    got: Sequence[Sequence[int]], wanted: Sequence[Sequence[int]], **words: Unpack[Words]
) -> None:
    """Expect exactly these particles to sleep after each step."""
    __tracebackhide__ = True
    expect_that(got == wanted, by_step(got), by_step(wanted), **words)


def expect_asleep(awake: Sequence[int], then: str) -> None:
    """Expect no steps after which particle 0 is awake."""
    __tracebackhide__ = True
    steps = ", ".join(map(str, awake))
    expect_that(not awake, f"awake after these steps: {steps}", "asleep after each step", then=then)


def awake_in(seen: Sequence[Sequence[int]]) -> list[int]:
    """Return the steps from 5 on in which particle 0 is awake."""
    return [i + 1 for i, one in enumerate(seen) if i >= 4 and one != [0]]


def named(numbers: Sequence[int]) -> str:
    """Return the names of particles, such as "particles 0 and 2"."""
    *rest, last = map(str, numbers) if numbers else ["no particle"]
    if not rest:
        return f"particle {last}" if numbers else last
    return f"particles {', '.join(rest)} and {last}"


def by_step(seen: Sequence[Sequence[int]]) -> str:
    """Return which particles sleep after each step, such as "particle 0 in steps 1 to 4"."""
    words, step = [], 1
    for numbers, same in groupby(seen):
        last = step + len([*same]) - 1
        words.append(
            f"{named(numbers)} in step{f's {step} to {last}' if last > step else f' {step}'}"
        )
        step = last + 1
    return ", ".join(words)
