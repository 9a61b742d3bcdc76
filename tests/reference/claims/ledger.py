"""The book's claims, which docs/claims.md describes in words, and functions that measure them."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

PAGE = Path(__file__).resolve().parents[3] / "docs/claims.md"
ENTRY = re.compile(
    r"(?ms)^### (?P<says>[^\n]+)\n\n\*Section (?P<chapter>\d)\.[^<]+"
    r"<details><summary>What we measured</summary>\n\n"
    r"\*\*It (?P<verdict>fails(?=\.)|holds(?=\.)|holds\sif(?= )).+?</details>"
)
NUMBER = r"-?\d[\d,]*(?:\.\d+)?(?:e[+-]\d+)?"


@dataclass(frozen=True)
class Claim:
    """A claim of the book, and a function that measures whether it is true.

    ``says`` is the beginning of its heading on the page. ``measured`` raises AssertionError if the
    verdict is not true, and returns phrases of the entry with the numbers that it measured.
    """

    verdict: str
    says: str
    measured: Callable[[], Iterable[str]]

    def entry(self, page: str) -> re.Match[str]:
        """Return the entry of this claim on the page."""
        (found,) = (each for each in ENTRY.finditer(page) if each["says"].startswith(self.says))
        return found

    def updated(self, page: str) -> str:
        """Measure the claim, and return the page with these numbers in its entry."""
        entry = self.entry(page)[0]
        *rest, answer, end = entry.split("\n\n")
        for phrase in self.measured():
            answer = with_numbers(answer, phrase)
        return page.replace(entry, "\n\n".join([*rest, answer, end]))


def claim(verdict: str, says: str) -> Callable[[Callable[[], Iterable[str]]], Claim]:
    """Make a claim out of the function that measures it."""
    return lambda measured: Claim(verdict, says, measured)


def claims_in(*modules: ModuleType) -> list[Claim]:
    return [value for each in modules for value in vars(each).values() if isinstance(value, Claim)]


def with_numbers(paragraph: str, phrase: str) -> str:
    """Find the words of a phrase in a paragraph, and put the numbers of the phrase there."""
    pattern = NUMBER.join(map(re.escape, re.split(NUMBER, phrase)))
    text, count = re.subn(pattern, lambda _: phrase, " ".join(paragraph.split()))
    if count != 1:
        raise ValueError(f"the page has these words {count} times: {phrase}")
    kept = text.replace(" %", "\x00%")  # a percentage stays on one line
    lines = textwrap.fill(kept, 100, break_long_words=False, break_on_hyphens=False)
    return lines.replace("\x00%", " %")


def measured_page(claims: list[Claim], page: str) -> str:
    """Measure all claims, and return the page with these numbers and the count of verdicts."""
    for each in claims:
        page = each.updated(page)
    *rest, count = page.removesuffix("\n").split("\n\n")
    return "\n\n".join([*rest, with_numbers(count, summary(claims))]) + "\n"


def summary(claims: list[Claim]) -> str:
    """Count the verdicts."""
    verdicts = [each.verdict for each in claims]
    holds, conditions, fails = map(verdicts.count, ("holds", "holds if", "fails"))
    return (
        f"Of these {len(claims)} claims, {holds} hold, {conditions} hold if a condition is met, "
        f"and {fails} fail."
    )
