"""Compare the code of a class pair by pair, and rate how unusual the similarity of each pair is.

A fingerprint has more weight if fewer students have it in the same exercise. The similarity of a
pair is the mean over the exercises, in which no single exercise dominates. To rate it, the usual
similarity of both students to others is subtracted. The difference, divided by its spread over the
class, is called the surprise of the pair.
"""

from __future__ import annotations

import math
import statistics
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import combinations

from autograder.similarity.code import Token

FEWEST = 12  # students, with whom there are 66 pairs; statistics on fewer would mislead
UPPER_DECILE = statistics.NormalDist().inv_cdf(0.9)
FALSE_ALARMS = 0.002  # pairs beyond the line without copies, if pairs vary as a bell curve does


@dataclass(frozen=True)
class Passage:
    """A function that a student has written: its position, its tokens, and the whole file."""

    file: str
    name: str
    tokens: list[Token]
    text: str


@dataclass
class Part:
    """The code of a student for one exercise, or the other code in one file."""

    passages: list[Passage] = field(default_factory=list)
    fingerprints: set[int] = field(default_factory=set)


@dataclass(frozen=True)
class Work:
    """The code of one student, by exercise."""

    student: str
    parts: Mapping[str, Part]


@dataclass(frozen=True)
class Pair:
    """Two students: how similar their code is, from 0 to 1, and how surprising that is."""

    one: Work
    other: Work
    similarity: float
    surprise: float | None = None


@dataclass(frozen=True)
class Shared:
    """The code that a pair shares in one part. Its rarest code is used by ``rarest`` students."""

    name: str
    similarity: float
    fingerprints: set[int]
    rarest: int


class Comparison:
    """All pairs of a class, the most surprising first.

    A pair stands out if its surprise is above ``line``. A small class has neither surprises nor a
    line.
    """

    def __init__(self, pairs: list[Pair], line: float | None, measure: Measure) -> None:
        self.pairs = pairs
        self.line = line
        self.measure = measure

    def stands_out(self, pair: Pair) -> bool:
        """Return whether chance alone is unlikely to produce such a pair in a class like this."""
        if self.line is None or pair.surprise is None:
            return False
        return pair.surprise >= self.line

    @property
    def outstanding(self) -> int:
        """The number of pairs that stand out. They come first."""
        return sum(map(self.stands_out, self.pairs))

    def shared(self, pair: Pair) -> list[Shared]:
        """Return the code that a pair shares, the parts with the most rare shared code first."""
        found = []
        for name in pair.one.parts.keys() & pair.other.parts.keys():
            both = pair.one.parts[name].fingerprints & pair.other.parts[name].fingerprints
            if similarity := self.measure.similarity_in(name, pair.one, pair.other):
                rarest = min(self.measure.holders[name, value] for value in both)
                found.append(Shared(name, similarity, both, rarest))
        return sorted(found, key=lambda s: (-self.measure.weight(s.name, s.fingerprints), s.name))


def compare(works: list[Work]) -> Comparison:
    """Compare every two students of a class."""
    measure = Measure(works)
    pairs = [Pair(a, b, measure.similarity(a, b)) for a, b in combinations(works, 2)]
    if len(works) < FEWEST or (spread := _spread(_excesses(pairs))) is None:
        pairs.sort(key=lambda pair: -pair.similarity)
        return Comparison(pairs, None, measure)
    middle, unit = spread
    judged = [
        Pair(pair.one, pair.other, pair.similarity, (excess - middle) / unit)
        for pair, excess in zip(pairs, _excesses(pairs), strict=True)
    ]
    judged.sort(key=lambda pair: -(pair.surprise or 0.0))
    line = statistics.NormalDist().inv_cdf(1.0 - FALSE_ALARMS / len(pairs))
    return Comparison(judged, line, measure)


class Measure:
    """The weights of fingerprints and exercises in this class."""

    def __init__(self, works: list[Work]) -> None:
        self.students = len(works)
        self.holders: Counter[tuple[str, int]] = Counter()
        for work in works:
            for name, part in work.parts.items():
                self.holders.update((name, value) for value in part.fingerprints)
        totals: dict[str, list[float]] = {}
        self.own: dict[tuple[str, str], float] = {}  # by student and part
        for work in works:
            for name, part in work.parts.items():
                self.own[work.student, name] = self.weight(name, part.fingerprints)
                totals.setdefault(name, []).append(self.own[work.student, name])
        self.usual = {name: statistics.median(values) for name, values in totals.items()}

    def similarity(self, one: Work, other: Work) -> float:
        """Return the mean similarity over the exercises, 0 for each that one student lacks."""
        found = sum(
            self.size(name) * self.similarity_in(name, one, other)
            for name in one.parts.keys() & other.parts.keys()
        )
        sizes = [sum(map(self.size, w.parts)) for w in (one, other)]
        return found / math.sqrt(math.prod(sizes)) if all(sizes) else 0.0

    def size(self, name: str) -> float:
        """Return the weight of a part in the mean: the square root of its usual size."""
        return math.sqrt(self.usual[name])

    def similarity_in(self, name: str, one: Work, other: Work) -> float:
        """Return how similar two students' code is in one part, from 0 to 1."""
        both = one.parts[name].fingerprints & other.parts[name].fingerprints
        # Who has written less than usual has less to share, and is not to stand out by that.
        sizes = [max(self.own[w.student, name], self.usual[name]) for w in (one, other)]
        shared = self.weight(name, both)
        return shared / math.sqrt(math.prod(sizes)) if shared else 0.0

    def weight(self, name: str, values: set[int]) -> float:
        """Return the weight of fingerprints of a part: the larger, the fewer students have them."""
        return sum(math.log(self.students / self.holders[name, value]) for value in values)


def _excesses(pairs: list[Pair]) -> Iterator[float]:
    """Yield how much more similar each pair is than its two students usually are to others."""
    of: dict[str, list[float]] = {}
    for pair in pairs:
        for work in (pair.one, pair.other):
            of.setdefault(work.student, []).append(pair.similarity)
    usual = {student: statistics.median(values) for student, values in of.items()}
    for pair in pairs:
        yield pair.similarity - (usual[pair.one.student] + usual[pair.other.student]) / 2.0


def _spread(values: Iterator[float]) -> tuple[float, float] | None:
    """Return the median and a robust standard deviation, or None for no values.

    A few copies do not change this standard deviation. It is computed from the upper half, which
    has the longer tail.
    """
    found = [*values]
    deciles = statistics.quantiles(found, n=10, method="inclusive")
    unit = (deciles[8] - deciles[4]) / UPPER_DECILE or statistics.pstdev(found)
    return (deciles[4], unit) if unit > 1e-9 else None
