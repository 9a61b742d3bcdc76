"""Compare the code of each pair of students in a class, and rate how unusual each result is.

We compare fingerprints of the code, which are hashes of short sequences of tokens. A fingerprint
that few students share weighs more, because it is less likely to be a coincidence. The similarity
of two students is a weighted average over the exercises. Its weights keep a long exercise from
dominating the result.

Some students write code that resembles everybody else's, so we expect a high similarity. The
expected similarity of a pair is the average of both students' median similarities to the rest of
the class. The excess of the pair is its similarity minus this expected value. The surprise of the
pair is the difference between its excess and the median of all pairs, divided by the spread.
"""

from __future__ import annotations

import math
import statistics
from collections import Counter
from collections.abc import Iterator, Mapping
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
    def code(self) -> str:
        """The lines of the function that have code, exactly as the student wrote them."""
        lines = self.text.split("\n")
        rows = {row for t in self.tokens for row in range(t.start[0], t.end[0] + 1)}
        return "\n".join(lines[row - 1] for row in sorted(rows))


@dataclass
class Part:
    """A student's code for one exercise.

    Code that belongs to no exercise is grouped by file instead.
    """

    passages: list[Passage] = field(default_factory=list)
    fingerprints: set[int] = field(default_factory=set)


@dataclass(frozen=True)
class Work:
    """All the code that one student handed in, sorted by exercise.

    Code that belongs to no exercise is sorted by file.
    """

    student: str
    parts: Mapping[str, Part]

    @property
    def code(self) -> dict[tuple[str, str], str]:
        """The text of all functions that are compared, by file and name."""
        passages = [passage for part in self.parts.values() for passage in part.passages]
        return {(passage.file, passage.name): passage.code for passage in passages}


@dataclass(frozen=True)
class Pair:
    """Two students and the similarity of their code, on a scale from 0 to 1.

    Attributes:
        identical: True if the compared code of both is the same, character for character.
        surprise: How unusual the similarity is in the class. It is None if the class is too small
            for such a measure.
    """

    one: Work
    other: Work
    similarity: float
    identical: bool = False
    surprise: float | None = None


@dataclass(frozen=True)
class Shared:
    """The code that two students have in common in one exercise.

    Code that belongs to no exercise is grouped by file instead. ``rarest`` is the number of
    students who share the rarest fingerprint in that code. If the number is small, the match is
    unlikely to be a coincidence.
    """

    name: str
    similarity: float
    fingerprints: set[int]
    rarest: int


class Comparison:
    """The result of comparing the code of every pair of students in a class.

    The surprise of a pair says how unusual the similarity of their code is for the class.

    Attributes:
        pairs: All pairs of students. Identical pairs come first. Otherwise, the pairs are sorted by
            decreasing surprise. If surprises could not be computed, they are sorted by decreasing
            similarity instead.
        line: The surprise from which a pair stands out, or None if there are no surprises.
        measure: The measure of similarity that was used.
    """

    def __init__(self, pairs: list[Pair], line: float | None, measure: Measure) -> None:
        self.pairs = pairs
        self.line = line
        self.measure = measure

    def stands_out(self, pair: Pair) -> bool:
        """Return True if two students' code is so similar that an instructor should read both.

        That is the case if the similarity is far above what is usual in this class, or if the code
        is identical. Identical code may have a low surprise if both students did only a part of the
        exercises.
        """
        if self.line is None or pair.surprise is None:
            return pair.identical
        return pair.identical or pair.surprise >= self.line

    @property
    def identical(self) -> list[Pair]:
        """The pairs of students whose compared code is the same, character for character."""
        return [pair for pair in self.pairs if pair.identical]

    @property
    def outstanding(self) -> int:
        """The number of pairs that stand out. These pairs come first in ``pairs``."""
        return sum(map(self.stands_out, self.pairs))

    def shared(self, pair: Pair) -> list[Shared]:
        """List the code that two students share in each exercise, strongest evidence first.

        Shared code is stronger evidence of copying if fewer other students have it.
        """
        found = []
        for name in pair.one.parts.keys() & pair.other.parts.keys():
            both = pair.one.parts[name].fingerprints & pair.other.parts[name].fingerprints
            if similarity := self.measure.similarity_in(name, pair.one, pair.other):
                rarest = min(self.measure.holders[name, value] for value in both)
                found.append(Shared(name, similarity, both, rarest))
        return sorted(found, key=lambda s: (-self.measure.weight(s.name, s.fingerprints), s.name))


def compare(works: list[Work]) -> Comparison:
    """Compare the code of each pair of students in a class, and rate how unusual each result is.

    In a class of fewer than twelve students, there are too few pairs for such a rating. The pairs
    are then only sorted by similarity.
    """
    measure = Measure(works)
    codes = [(work, work.code) for work in works]
    pairs = [
        Pair(one, other, measure.similarity(one, other), bool(code) and code == other_code)
        for (one, code), (other, other_code) in combinations(codes, 2)
    ]
    if len(works) < FEWEST or (spread := _spread(_excesses(pairs))) is None:
        pairs.sort(key=lambda pair: (not pair.identical, -pair.similarity))
        return Comparison(pairs, None, measure)
    middle, unit = spread
    judged = [
        replace(pair, surprise=(excess - middle) / unit)
        for pair, excess in zip(pairs, _excesses(pairs), strict=True)
    ]
    judged.sort(key=lambda pair: (not pair.identical, -(pair.surprise or 0.0)))
    line = statistics.NormalDist().inv_cdf(1.0 - FALSE_ALARMS / len(pairs))
    return Comparison(judged, line, measure)


class Measure:
    """Measures how similar two students' code is, on a scale from 0 to 1.

    Code that only a few students have written counts more than code that many have written.
    """

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
        """Compute the average similarity of two students' code over all exercises, from 0 to 1.

        If only one of the students has written code for an exercise, the similarity there is 0.
        """
        found = sum(
            self.size(name) * self.similarity_in(name, one, other)
            for name in one.parts.keys() & other.parts.keys()
        )
        sizes = [sum(map(self.size, w.parts)) for w in (one, other)]
        return found / math.sqrt(math.prod(sizes)) if all(sizes) else 0.0

    def size(self, name: str) -> float:
        """Return the weight of an exercise in the average similarity of two students.

        The weight is the square root of the exercise's typical size, so that a long exercise cannot
        dominate the average.
        """
        return math.sqrt(self.usual[name])

    def similarity_in(self, name: str, one: Work, other: Work) -> float:
        """Compute the similarity of two students' code for a single exercise, from 0 to 1.

        ``name`` is the exercise's id and title. For code that belongs to no exercise, it is a label
        such as "Other code in ch02_vectors/vector.py".
        """
        both = one.parts[name].fingerprints & other.parts[name].fingerprints
        # A student who has written less has less to share, and must not stand out for that.
        sizes = [max(self.own[w.student, name], self.usual[name]) for w in (one, other)]
        shared = self.weight(name, both)
        return shared / math.sqrt(math.prod(sizes)) if shared else 0.0

    def weight(self, name: str, values: set[int]) -> float:
        """Compute the total weight of a set of fingerprints for one exercise.

        A fingerprint weighs more if fewer students share it, because it is less likely to be a
        coincidence.
        """
        return sum(math.log(self.students / self.holders[name, value]) for value in values)


def _excesses(pairs: list[Pair]) -> Iterator[float]:
    """Yield the excess of each pair, which is its similarity minus the expected similarity.

    The expected similarity is the average of the two students' usual similarities. A student's
    usual similarity is the median of the student's similarities to everyone else in the class.
    """
    of: dict[str, list[float]] = {}
    for pair in pairs:
        for work in (pair.one, pair.other):
            of.setdefault(work.student, []).append(pair.similarity)
    usual = {student: statistics.median(values) for student, values in of.items()}
    for pair in pairs:
        yield pair.similarity - (usual[pair.one.student] + usual[pair.other.student]) / 2.0


def _spread(values: Iterator[float]) -> tuple[float, float] | None:
    """Compute the median and the spread of ``values``, which contains one number per pair.

    The spread is a standard deviation estimated from the upper half of the values, which has the
    longer tail. The estimate is robust against a few outliers, such as students who have copied.
    The result is None if all values are equal.
    """
    found = [*values]
    deciles = statistics.quantiles(found, n=10, method="inclusive")
    unit = (deciles[8] - deciles[4]) / UPPER_DECILE or statistics.pstdev(found)
    return (deciles[4], unit) if unit > 1e-9 else None
