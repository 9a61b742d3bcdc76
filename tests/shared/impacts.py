"""What the checks of next_impact share, for chapter 7."""

from __future__ import annotations

from typing import Any

from expect import about, expect_exactly, scoped


@scoped
def expect_impact(impact: Any) -> Any:
    """Expect an impact, as time and contact, and return it."""
    why = (
        "There is an impact within this duration, so the result must be a tuple (time, contact). "
        "Return None only if there is no impact."
    )
    about.cause = f"{why} {about.cause}"
    pair = isinstance(impact, (tuple, list)) and len(impact) == 2
    expect_exactly(pair, True, then=" is (time, contact)")
    return impact
