"""What a claim of the book is, and the page docs/claims.md, which lists all of them."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from types import ModuleType

INTRODUCTION = """\
# What the book claims, and what we measured

Physics engines are full of rules of thumb. This page lists qualitative claims of *Game Physics
Engine Development*, second edition, in our own words. Read a claim, **predict** the answer to the
question below it, and only then open what we measured. A claim **holds**, it **holds if** a
condition is met, or it **fails**.

Our tests measure every claim with the reference engine, and they write the results on this page. So
the numbers below are always those of the engine that you see here. Where a claim fails, the
[errata](errata.md) give the correction.
"""


@dataclass(frozen=True)
class Claim:
    """One claim of the book, and a function that measures whether it is true.

    ``measured`` raises AssertionError if the verdict is not true, and returns what it measured in
    words. ``erratum`` is the number of the entry in errata.md, if there is one.
    """

    section: str
    says: str
    predict: str
    verdict: str
    erratum: str
    measured: Callable[[], str]

    def entry(self) -> str:
        """Measure the claim, and return its entry on the page."""
        found = f"**{self.verdict}.** {self.measured()}"
        if self.erratum:
            found += f" See [{self.erratum}](errata.md#{self.erratum.lower()})."
        return (
            f"### {self.says}\n\n"
            + _wrapped(f"*Section {self.section}.* **Predict:** {self.predict}")
            + "\n\n<details><summary>What we measured</summary>\n\n"
            + _wrapped(found)
            + "\n\n</details>\n"
        )


def claim(
    section: str, says: str, *, predict: str, verdict: str, erratum: str = ""
) -> Callable[[Callable[[], str]], Claim]:
    """Make a claim out of the function that measures it."""
    if verdict not in {"It holds", "It fails"} and not verdict.startswith("It holds if "):
        raise ValueError(f"unknown verdict: {verdict!r}")

    def made(measured: Callable[[], str]) -> Claim:
        return Claim(section, says, predict, verdict, erratum, measured)

    return made


def claims_in(*modules: ModuleType) -> Iterator[Claim]:
    """Yield the claims that these modules define, in the order of the book's chapters."""
    found = [value for module in modules for value in vars(module).values()]
    claims = [value for value in found if isinstance(value, Claim)]
    yield from sorted(claims, key=lambda c: c.section.split(".")[0])


def page(claims: list[Claim]) -> str:
    """Measure all claims, and return the text of the page."""
    parts, chapter = [INTRODUCTION], ""
    for each in claims:
        if (own := each.section.split(".")[0]) != chapter:
            chapter = own
            parts.append(f"## Chapter {chapter}\n")
        parts.append(each.entry())
    return "\n".join([*parts, "## In numbers\n", _wrapped(summary(claims)), ""])


def summary(claims: list[Claim]) -> str:
    """Count the verdicts."""
    holds = sum(c.verdict == "It holds" for c in claims)
    fails = sum(c.verdict == "It fails" for c in claims)
    return (
        f"Of these {len(claims)} claims, {holds} hold, {len(claims) - holds - fails} hold if a "
        f"condition is met, and {fails} fail. We chose claims that you can measure, and among "
        "them those that surprise, so these numbers say nothing about the rest of the book."
    )


def _wrapped(text: str) -> str:
    """Break a paragraph into lines, but keep each percentage on one line."""
    kept = text.replace(" %", "\x00%")
    lines = textwrap.fill(kept, 100, break_long_words=False, break_on_hyphens=False)
    return lines.replace("\x00%", " %")
