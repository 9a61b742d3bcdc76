"""Count the lines, the calls and the constructed objects in the source of a function.

The counts come from the tokens of the source. The code is not compiled or run, so a call inside a
loop counts once.
"""

from __future__ import annotations

import keyword
from collections.abc import Sequence
from dataclasses import dataclass

from autograder.similarity.code import LOCAL, Function

END_OF_LINE = ";"


@dataclass(frozen=True)
class Counts:
    """The number of lines, calls and constructed objects in the body of a function.

    ``lines`` counts lines with code. Blank lines, comments and docstrings do not count. ``calls``
    counts calls such as v.dot(w). ``objects`` counts calls that construct an object, such as
    Vector3(...). An error in a raise statement does not count as a call or an object.
    """

    lines: int
    calls: int
    objects: int


def count(function: Function) -> Counts:
    """Count the lines, calls and objects in the body of a function."""
    words = [token.word.removeprefix(LOCAL) for token in function.tokens]
    called = [words[i - 1] for i, word in enumerate(words) if word == "(" and _is_call(words, i)]
    lines = {token.start[0] for token in function.tokens if token.word != END_OF_LINE}
    objects = sum(name.lstrip("_")[:1].isupper() for name in called)
    return Counts(len(lines), len(called), objects)


def _is_call(words: Sequence[str], i: int) -> bool:
    """Return whether the bracket at index ``i`` belongs to a call.

    Brackets in expressions do not count, nor do brackets after def, class and raise.
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
