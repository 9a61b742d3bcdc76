"""Read a lesson: its sections, its commands and its numbers."""

from __future__ import annotations

import re

from autograder.manifest import ROOT

NUMBER = re.compile(r"(?<![\w.,])\d+(?:,\d{3})*(?:\.\d+)?(?:e-?\d+)?(?!\.?\d)(?![A-Za-z_])")
ALWAYS = {"0", "1", "2", "3", "4"}  # always allowed, because they are used like words
# Numbers in the names of exercises, sections, chapters, equations and errata.
NAMES = re.compile(
    r"(?:[Ee]xercises?|[Ss]ections?|[Cc]hapters?|Eq\.|E-|[BGP]|CH=|EX=)"
    r"[\s(]*\d[\d.]*[a-d]?(?:(?:,| and| to|,? or) [BGP]?\d[\d.]*[a-d]?)*"
)


def lesson_of(chapter: str) -> str:
    return (ROOT / "chapters" / chapter / "README.md").read_text(encoding="utf-8")


def sections_of(text: str) -> dict[str, str]:
    """Return the parts of a lesson below its second-level headings."""
    parts = re.split(r"(?m)^## (.+)\n", text)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def numbers_in(section: str) -> list[str]:
    """Return the numbers that a reader sees, except for those in code, links and names."""
    text = re.sub(r"(?ms)^```.*?^```", " ", section)
    text = re.sub(r"`[^`]*`|\]\([^)]*\)|(?m:^\*\*Your turn\*\*.*$)", " ", text)
    text = NAMES.sub(" ", text)
    return [token for token in NUMBER.findall(text) if token not in ALWAYS]


def agrees(token: str, value: float) -> bool:
    """Return whether a printed number is a value rounded to the printed digits."""
    digits = token.replace(",", "")
    mantissa, _, exponent = digits.partition("e")
    decimals = len(mantissa.partition(".")[2])
    unit = 10.0 ** (int(exponent or 0) - decimals)
    return abs(abs(value) - float(digits)) <= 0.5001 * unit


def turns_of(text: str) -> list[tuple[str, str, str]]:
    """Return the minutes, words and commands of each *your turn*."""
    return re.findall(r"(?ms)^\*\*Your turn\*\* \((\d+) minutes\): (.+?)^```sh\n(.+?)^```", text)


def minutes_of(text: str) -> list[tuple[str, float]]:
    """Return the estimated time for each exercise, from its *your turn*."""
    times: list[tuple[str, float]] = []
    for minutes, _, commands in turns_of(text):
        ids = re.findall(r"(?m)^make check EX=(\S+)", commands)
        times += [(number, int(minutes) / len(ids)) for number in ids]
    return times


def lab_commands(text: str) -> list[tuple[str, dict[str, str]]]:
    """Return the scene and the settings of each `make lab SCENE=...` command in a text."""
    found = re.findall(r'make lab SCENE=([\w-]+)(?: SET="([^"]*)")?', text)
    return [(s, dict(word.split("=", 1) for word in settings.split())) for s, settings in found]


class Facts:
    """The numbers that each section of a lesson gives, and those that the reference computes."""

    def __init__(self) -> None:
        self.given: dict[str, list[str]] = {}
        self.computed: dict[str, dict[str, float]] = {}

    def section(self, heading: str, given: str = "") -> None:
        self.given[heading] = given.split()
        self.values = self.computed[heading] = {}

    def says(self, numbers: str, *values: float) -> None:
        """Note numbers as the latest section prints them, and their values."""
        self.values |= zip(numbers.split(), values, strict=True)
