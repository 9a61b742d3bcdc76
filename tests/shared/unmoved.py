"""Expect that code which only reads vectors has not changed them, perhaps under another name."""

from __future__ import annotations

from collections.abc import Sequence

from expect import expect_unchanged


def expect_kept(name: str, now: Sequence[float], before: Sequence[float]) -> None:
    """Expect that a vector is still what it was before the call. Test this before the result."""
    __tracebackhide__ = True
    cause = f"Your code changes {name}. An operator such as -= changes the vector itself, also if "
    cause += "you gave it a second name. Use operators such as -, which create a new vector."
    expect_unchanged(name, now, before, cause=cause)


def expect_all_kept(
    name: str, now: Sequence[Sequence[float]], before: Sequence[Sequence[float]]
) -> None:
    """Expect that several vectors are still what they were; ``name`` has a field for the number."""
    __tracebackhide__ = True
    for i, (one, old) in enumerate(zip(now, before, strict=True)):
        expect_kept(name.format(i), one, old)
