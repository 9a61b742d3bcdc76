"""Words and expectations that the checks of chapter 7 share."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Unpack

from autograder.checks.asked import Words
from expect import about, expect_that, scoped


def of_mass(mass: float) -> str:
    """Return a mass in words, for the call of a message."""
    return "immovable" if math.isinf(mass) else f"{mass:g} kg"


def expect_list(kind: str) -> None:
    """Expect that ``contacts()`` returned a list; ``kind`` says what it was instead."""
    __tracebackhide__ = True
    why = "You returned the Contact itself. Return a list, even if it has only one contact: put it "
    why += "in brackets, as in [contact]."
    if "None" in kind:
        why = f"contacts() returned None. Always return a list. {about.cause}"
    expect_that(not kind, kind, "a list of contacts", cause=why)


@scoped
def expect_impact(impact: Any) -> Any:
    """Expect an impact, as time and contact, and return it."""
    __tracebackhide__ = True
    pair = isinstance(impact, (tuple, list)) and len(impact) == 2
    got = f"{impact:.6g}" if type(impact) is float else "not a tuple of two values"
    why = "next_impact must return both the time and the contact, as a tuple (time, contact). "
    why += "Return None only if there is no impact."
    wanted = "a tuple (time, contact)"
    if impact is None:
        got, why = "None, as if there were no impact within the duration", about.cause
        wanted += ", because there is an impact"
    elif pair and not isinstance(impact[0], float | int):
        pair, got = False, "a tuple whose first value is not a time"
        why = "The time comes first: return the tuple (time, contact)."
    expect_that(pair, got, wanted, cause=why)
    return impact


def expect_none(impact: Any, **words: Unpack[Words]) -> None:
    """Expect None, because there is no impact within the duration."""
    __tracebackhide__ = True
    expect_that(impact is None, "an impact", "None, because there is no impact", **words)


def expect_particles(
    seen: Sequence[Any],
    wanted: Sequence[int],
    names: Sequence[str] = ("a", "b"),
    **words: Unpack[Words],
) -> None:
    """Expect these indices for the particle and the other of a contact; -1 stands for None."""
    __tracebackhide__ = True

    def said(pair: Sequence[Any]) -> str:
        known = {-1: "None", **dict(enumerate(names))}
        one, other = (known.get(i, "a different particle") for i in pair)
        return f"contact.particle is {one} and contact.other is {other}"

    numbers = all(type(i) in (int, float) for i in seen)
    expect_that(numbers and tuple(seen) == tuple(wanted), said(seen), said(wanted), **words)
