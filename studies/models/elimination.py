"""Going further: solve sparse symmetric equations by elimination (LDL^T).

The pull of a link appears only in the equations of links that share a particle with it. Most
coefficients in the equations of a net are therefore 0. Elimination turns some of these zeros into
other numbers, which are called fill-in and cost time. The amount of fill-in depends on the order of
elimination. A good rule is minimum degree: always eliminate the unknown whose equation has the
fewest other unknowns (Tinney and Walker, Proceedings of the IEEE 55, 1967, 1801). The nonzero
coefficients of a net are always in the same positions, so the order is found only once.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

SINGULAR = "equation {} has no unique solution"


class Elimination:
    """Solves A x = b for symmetric matrices A that all have their zeros in the same positions.

    ``count`` is the number of unknowns. ``pairs`` are the pairs (i, j) for which A[i][j] may differ
    from 0. The unknowns with numbers below ``first`` are eliminated before the others.

    The values of A are passed as a list of length ``size``, which begins with the ``count`` numbers
    on the diagonal. Because A is symmetric, A[i][j] and A[j][i] share one entry of the list.
    ``slot_of`` returns the index of this entry.

    This class does not search for pivots, so the order of elimination must suit A. Every order
    works if A is positive definite. It also works if A consists of a positive definite block, a
    negative definite block, and any numbers that couple the two (Vanderbei, SIAM Journal on
    Optimization 5, 1995, 100).
    """

    def __init__(self, count: int, pairs: Iterable[tuple[int, int]], first: int = 0) -> None:
        neighbors: list[set[int]] = [set() for _ in range(count)]
        for i, j in pairs:
            if i != j:
                neighbors[i].add(j)
                neighbors[j].add(i)
        self._slots: dict[tuple[int, int], int] = {(i, i): i for i in range(count)}
        # For each unknown k, in elimination order: k; the unknowns below it with the slots of
        # A[i][k]; and for each of them the slots that change, with the slots of A[j][k].
        self._columns: list[
            tuple[int, list[tuple[int, int]], list[tuple[int, list[tuple[int, int]]]]]
        ] = []
        left = set(range(count))
        while left:
            k = min(left, key=lambda i: (i >= first, len(neighbors[i]), i))
            left.remove(k)
            below = sorted(neighbors[k])
            for i in below:  # what is below k is connected from now on
                neighbors[i].discard(k)
                neighbors[i].update(below)
                neighbors[i].discard(i)
            rows = [(i, self._slot(i, k)) for i in below]
            changes = []
            for n, (i, slot) in enumerate(rows):
                others = rows[n:]
                changes.append((slot, [(self._slot(i, j), other) for j, other in others]))
            self._columns.append((k, rows, changes))
        self.size = len(self._slots)

    def _slot(self, i: int, j: int) -> int:
        """Return the index of A[i][j] in the list of values. Add a new entry if there is none."""
        return self._slots.setdefault((min(i, j), max(i, j)), len(self._slots))

    def slot_of(self, i: int, j: int) -> int:
        """Return the index of A[i][j] in the list of values."""
        return self._slots[min(i, j), max(i, j)]

    def factor(self, values: list[float]) -> None:
        """Replace the values of A by its factors: 1 / D on the diagonal, and L below it.

        Raises:
            ArithmeticError: if a pivot is 0 or not finite.
        """
        for k, _, changes in self._columns:
            pivot = values[k]
            if not 0.0 < abs(pivot) < math.inf:  # NaN too
                raise ArithmeticError(SINGULAR.format(k))
            values[k] = inverse = 1.0 / pivot
            for slot, targets in changes:
                ratio = values[slot] * inverse
                if ratio:  # a slack cable has zeros only
                    # values[other] is still A[j][k]: those before it are divided already
                    for target, other in targets:
                        values[target] -= ratio * values[other]
                    values[slot] = ratio

    def solve(self, factors: Sequence[float], right: Sequence[float]) -> list[float]:
        """Return the solution x of A x = b, from the factors of A and the right side b."""
        x = [*right]
        for k, rows, _ in self._columns:
            value = x[k]
            for i, slot in rows:
                x[i] -= factors[slot] * value
        for k, rows, _ in reversed(self._columns):
            value = x[k] * factors[k]
            for i, slot in rows:
                value -= factors[slot] * x[i]
            x[k] = value
        return x
