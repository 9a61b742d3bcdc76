"""Compare the code of each pair of students in a class, and rate how unusual each result is.

A fingerprint of the code that few students share weighs more, because it is less likely to be a
coincidence. The similarity of two students is a weighted average over the exercises.

Some students write code that resembles everybody else's. So the expected similarity of a pair is
the average of both students' median similarities to the rest of the class, and its excess is what
it has above that. Its surprise is the excess minus the median of all pairs, divided by the spread.
"""

from __future__ import annotations

import math
import statistics
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import combinations

from autograder.similarity.code import Token

FEWEST = 12  # students; they form 66 pairs, and statistics on fewer pairs would be misleading
UPPER_DECILE = statistics.NormalDist().inv_cdf(0.9)
FALSE_ALARMS = 0.002  # pairs expected above the line by chance, if pairs vary as a bell curve does


@dataclass(frozen=True)
class Passage:
    """A function as one student wrote it, with its tokens and the text of its file."""

    file: str
    name: str
    tokens: list[Token]
    text: str

    @property
    def lines(self) -> list[str]:
        """The lines of the function, exactly as the student wrote them."""
        return self.text.split("\n")[self.tokens[0].start[0] - 1 : self.tokens[-1].end[0]]

    @property
    def code(self) -> str:
        """Those lines of the function that have code."""
        first, lines = self.tokens[0].start[0], self.lines
        rows = {row for t in self.tokens for row in range(t.start[0], t.end[0] + 1)}
        return "\n".join(lines[row - first] for row in sorted(rows))


@dataclass
class Part:
    """A student's code for one exercise, or the code in one file that belongs to no exercise."""

    passages: list[Passage] = field(default_factory=list)
    fingerprints: set[int] = field(default_factory=set)


@dataclass(frozen=True)
class Work:
    """All the code that one student handed in."""

    student: str
    parts: Mapping[str, Part]

    @property
    def code(self) -> dict[tuple[str, str], str]:
        """The text of all functions that are compared, by file and name."""
        passages = [passage for part in self.parts.values() for passage in part.passages]
        return {(passage.file, passage.name): passage.code for passage in passages}


@dataclass(frozen=True)
class Pair:
    """Two students and the similarity of their code, on a scale from 0 to 1."""

    one: Work
    other: Work
    similarity: float
    identical: bool = False  # the compared code is the same, character for character
    surprise: float | None = None  # how unusual this is in a class that is large enough


@dataclass(frozen=True)
class Shared:
    """What two students have in common in one part. ``rarest`` students have the rarest of it."""

    name: str
    similarity: float
    fingerprints: set[int]
    rarest: int


class Comparison:
    """The comparison of the code of every pair of students in a class.

    In ``pairs``, identical pairs come first. The others are sorted by decreasing surprise or, if
    there are no surprises, by decreasing similarity. ``line`` is the surprise from which a pair
    stands out, or None. ``holders`` counts the students who have a fingerprint in a part.
    """

    def __init__(self, works: list[Work]) -> None:
        self.students = len(works)
        parts = [(work.student, name, p) for work in works for name, p in work.parts.items()]
        self.holders = Counter((name, value) for _, name, p in parts for value in p.fingerprints)
        self._own = {(who, name): self._weight(name, p.fingerprints) for who, name, p in parts}
        weights: dict[str, list[float]] = {}
        for (_, name), weight in self._own.items():
            weights.setdefault(name, []).append(weight)
        self._usual = {name: statistics.median(values) for name, values in weights.items()}
        # Because of the square root, a long exercise cannot dominate the average.
        self._weights = {name: math.sqrt(size) for name, size in self._usual.items()}
        codes = [(work, work.code) for work in works]
        self.pairs = [
            Pair(one, other, self._similarity(one, other), bool(code) and code == other_code)
            for (one, code), (other, other_code) in combinations(codes, 2)
        ]
        self.line: float | None = None
        excesses = _excesses(self.pairs)
        if self.students >= FEWEST and (spread := _spread(excesses)):
            middle, unit = spread
            self.line = statistics.NormalDist().inv_cdf(1.0 - FALSE_ALARMS / len(self.pairs))
            self.pairs = [
                replace(pair, surprise=(excess - middle) / unit)
                for pair, excess in zip(self.pairs, excesses, strict=True)
            ]
        self.pairs.sort(key=lambda p: (not p.identical, -(p.surprise or 0.0), -p.similarity))

    def stands_out(self, pair: Pair) -> bool:
        """Return True if two students' code is so similar that an instructor should read both."""
        # Identical code may have a low surprise if both students did only a part of the exercises.
        return pair.identical or bool(self.line and pair.surprise and pair.surprise >= self.line)

    @property
    def identical(self) -> list[Pair]:
        """The pairs of students whose compared code is the same, character for character."""
        return [pair for pair in self.pairs if pair.identical]

    @property
    def outstanding(self) -> int:
        """The number of pairs that stand out. These pairs come first in ``pairs``."""
        return sum(map(self.stands_out, self.pairs))

    def shared(self, pair: Pair) -> list[Shared]:
        """List the code that two students share in each part, strongest evidence first."""
        found = []
        for name in pair.one.parts.keys() & pair.other.parts.keys():
            both = pair.one.parts[name].fingerprints & pair.other.parts[name].fingerprints
            if similarity := self._similarity_in(name, pair.one, pair.other):
                rarest = min(self.holders[name, value] for value in both)
                found.append(Shared(name, similarity, both, rarest))
        return sorted(found, key=lambda s: (-self._weight(s.name, s.fingerprints), s.name))

    def _similarity(self, one: Work, other: Work) -> float:
        """Return the weighted average over all parts. A part that only one student has counts 0."""
        both = one.parts.keys() & other.parts.keys()
        found = sum(self._weights[name] * self._similarity_in(name, one, other) for name in both)
        sizes = [sum(self._weights[name] for name in work.parts) for work in (one, other)]
        return found / math.sqrt(math.prod(sizes)) if all(sizes) else 0.0

    def _similarity_in(self, name: str, one: Work, other: Work) -> float:
        """Return the similarity of two students' code in a single part, from 0 to 1."""
        both = one.parts[name].fingerprints & other.parts[name].fingerprints
        # A student who has written less has less to share, and must not stand out for that.
        sizes = [max(self._own[w.student, name], self._usual[name]) for w in (one, other)]
        shared = self._weight(name, both)
        return shared / math.sqrt(math.prod(sizes)) if shared else 0.0

    def _weight(self, name: str, values: set[int]) -> float:
        """Return the weight of fingerprints. It is larger if fewer students have them."""
        return sum(math.log(self.students / self.holders[name, value]) for value in values)


def _excesses(pairs: list[Pair]) -> list[float]:
    """Return the similarity of each pair minus what is usual for its two students."""
    of: dict[str, list[float]] = {}
    for pair in pairs:
        for work in (pair.one, pair.other):
            of.setdefault(work.student, []).append(pair.similarity)
    half = {student: statistics.median(values) / 2.0 for student, values in of.items()}
    return [p.similarity - half[p.one.student] - half[p.other.student] for p in pairs]


def _spread(values: list[float]) -> tuple[float, float] | None:
    """Return the median and the spread of the pairs' excesses, or None if all are equal.

    The spread is a standard deviation, estimated so that a few outliers hardly change it.
    """
    deciles = statistics.quantiles(values, n=10, method="inclusive")
    unit = (deciles[8] - deciles[4]) / UPPER_DECILE or statistics.pstdev(values)
    return (deciles[4], unit) if unit > 1e-9 else None
