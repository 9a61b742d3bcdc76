"""Count the lines, calls and new objects in a student's function and in the reference solution.

Students can compare these numbers to see how the two versions differ. The source text is only read,
not run, so a call inside a loop counts only once.
"""

from __future__ import annotations

import keyword
from collections.abc import Sequence
from dataclasses import dataclass

from autograder.similarity.code import LOCAL, Function

END_OF_LINE = ";"


@dataclass(frozen=True)
class Counts:
    """The number of lines, calls and new objects in the body of a function.

    An error that is created in a raise statement counts neither as a call nor as an object.

    Attributes:
        lines: The number of lines, without blank lines, comments and docstrings.
        calls: The total number of calls.
        objects: The number of calls that create an object, such as Vector3(...).
    """

    lines: int
    calls: int
    objects: int


def count(function: Function) -> Counts:
    """Count the lines, calls and new objects in the body of a function.

    The counts let students compare their own function with the one in the reference solution.
    """
    words = [token.word.removeprefix(LOCAL) for token in function.tokens]
    called = [words[i - 1] for i, word in enumerate(words) if word == "(" and _is_call(words, i)]
    lines = {token.start[0] for token in function.tokens if token.word != END_OF_LINE}
    objects = sum(name.lstrip("_")[:1].isupper() for name in called)
    return Counts(len(lines), len(called), objects)


def _is_call(words: Sequence[str], i: int) -> bool:
    """Return True if the opening parenthesis at index ``i`` begins the arguments of a call.

    Parentheses that group an expression do not count, and neither do those in def statements, class
    statements and raise statements.
    """
    before = words[i - 1] if i else ""
    first = i - 1
    while first >= 2 and words[first - 1] == ".":
        first -= 2
    introduced_by = words[first - 1] if first > 0 else ""
    is_value = before in (")", "]") or before.isidentifier()
    return (
        is_value
        and not keyword.iskeyword(before)
        and introduced_by not in ("def", "class", "raise")
    )
