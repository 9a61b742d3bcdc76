"""Split the functions in students' files into tokens, and compute fingerprints of them.

The students' code is never compiled or run. Fingerprints are computed by winnowing (Schleimer,
Wilkerson and Aiken, 2003): every sequence of GRAM consecutive tokens is hashed, and from every
WINDOW neighboring hashes, the smallest is kept. Two functions with GRAM + WINDOW - 1 consecutive
tokens in common therefore share a fingerprint. Moving statements changes only a few fingerprints,
because a sequence is no longer than a short statement.
"""

from __future__ import annotations

import builtins
import hashlib
import io
import keyword
import math
import tokenize
from collections.abc import Collection, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cache

GRAM = 8
WINDOW = 4
LONGEST = 100_000  # characters; the longest module of a chapter has about ten thousand
WIDEST = 2_000  # characters; in Python 3.12 the time grows with the square of a line's length
LOCAL = "~"  # marks a name that the student has chosen
ALWAYS_KNOWN = frozenset({"self", *keyword.kwlist})
_IN_NO_LINE = (tokenize.COMMENT, tokenize.NL, tokenize.INDENT, tokenize.DEDENT)
_Line = list[tokenize.TokenInfo]


@dataclass(frozen=True)
class Token:
    """A token with its place in the file, as (line, column). Equal words are equal code."""

    word: str
    start: tuple[int, int]
    end: tuple[int, int]


@dataclass(frozen=True)
class Function:
    """The tokens in the body of a function, or of all code outside functions if it has no name."""

    name: str
    tokens: list[Token]

    @property
    def words(self) -> tuple[str, ...]:
        return tuple(token.word for token in self.tokens)


def read_functions(text: str, known: frozenset[str] = frozenset()) -> tuple[list[Function], int]:
    """Split the body of each function in a student's file into tokens.

    Signatures, comments and docstrings are left out. All strings count as equal, and so do 2 and
    2.0. ``known`` contains the engine's names, which all students use. A method has a name such as
    Particle.mass, and a setter Particle.mass.setter. The number returned is the line at which we
    had to stop reading, or 0.
    """
    text, stopped = _without_the_excessive(text)
    found: dict[str, list[Token]] = {}
    scopes: list[tuple[int, str, bool]] = []  # depth, name, whether it is a function
    setter = ""
    try:
        for depth, line in _lines(text):
            while scopes and depth <= scopes[-1][0]:
                scopes.pop()
            inside = bool(scopes) and scopes[-1][2]
            words = [token.string for token in line[:-1] if token.string != "async"]
            if not inside and words[:1] in (["def"], ["class"]):
                scopes.append((depth, "".join(words[1:2]) + setter, words[0] == "def"))
                setter = ""
                line = [] if line[-2].string == ":" else line  # the body may be in the same line
            elif not inside and words[:1] == ["@"]:
                setter = ".setter" if words[-2:] == [".", "setter"] else ""
                continue
            owner = ".".join(name for _, name, _ in scopes) if scopes and scopes[-1][2] else ""
            found.setdefault(owner, []).extend(_tokens(line, known))
    except (tokenize.TokenError, SyntaxError, ValueError) as error:
        # The tokenizer gives the place as (line, column) or as (file, line, column, ...).
        place = error.args[1] if len(error.args) > 1 else ()
        numbers = place if isinstance(place, tuple) else ()
        stopped = next((number for number in numbers if isinstance(number, int)), 1)
    return [Function(name, tokens) for name, tokens in found.items() if tokens], stopped


def names_in(text: str) -> Iterator[str]:
    """Yield the names that comparisons keep, since they are Python's or public in our own file."""
    yield from (*dir(builtins), *dir(math))
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        is_private = token.string.startswith("_") and not token.string.endswith("__")
        if token.type == tokenize.NAME and not is_private:
            yield token.string


@cache
def hashes(words: tuple[str, ...]) -> tuple[int, ...]:
    """Hash every sequence of GRAM consecutive tokens, in the order of the code."""
    return tuple(_hash(words[i : i + GRAM]) for i in range(len(words) - GRAM + 1))


def fingerprints(words: tuple[str, ...]) -> set[int]:
    """Compute the fingerprints of a function by winnowing its hashes."""
    found = hashes(words)
    windows = range(max(1, len(found) - WINDOW + 1)) if found else ()
    return {min(found[i : i + WINDOW]) for i in windows}


def covered(tokens: list[Token], shared: Collection[int]) -> set[int]:
    """Return the indices of the tokens in any sequence whose hash is in ``shared``."""
    found = hashes(tuple(token.word for token in tokens))
    starts = [i for i, value in enumerate(found) if value in shared]
    return {i for start in starts for i in range(start, start + GRAM)}


def _hash(run: tuple[str, ...]) -> int:
    names: dict[str, int] = {}  # a student's own names count in the order of their appearance
    words = [
        f"{LOCAL}{names.setdefault(word, len(names))}" if word.startswith(LOCAL) else word
        for word in run
    ]
    digest = hashlib.blake2b("\n".join(words).encode("utf-8", "surrogatepass"), digest_size=8)
    return int.from_bytes(digest.digest(), "big")  # the same in every run, unlike hash()


def _without_the_excessive(text: str) -> tuple[str, int]:
    """Cut a file at a line that would take too long, and return that line's number, or 0."""
    size = 0
    for number, line in enumerate(io.StringIO(text), start=1):
        if len(line) > WIDEST or size + len(line) > LONGEST:
            return text[:size], number
        size += len(line)
    return text, 0


def _lines(text: str) -> Iterator[tuple[int, _Line]]:
    """Yield the tokens of each logical line, without comments, with its indentation level."""
    depth, nested = 0, 0
    line: _Line = []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        depth += (token.type == tokenize.INDENT) - (token.type == tokenize.DEDENT)
        kind = tokenize.tok_name[token.type]
        nested += kind.endswith("STRING_START")  # since Python 3.12 an f-string has many tokens
        if token.type in (tokenize.NEWLINE, tokenize.ENDMARKER):
            if line:
                yield depth, [*line, token]
            line = []
        elif token.type not in _IN_NO_LINE and not nested:
            line.append(token)
        if nested and kind.endswith("STRING_END"):
            nested -= 1
            if not nested:
                line.append(token._replace(type=tokenize.STRING))


def _tokens(line: _Line, known: frozenset[str]) -> Iterator[Token]:
    """Yield the tokens of a logical line to compare. A docstring has none."""
    if all(token.type in (tokenize.STRING, tokenize.NEWLINE) for token in line):
        return
    for before, token, after in zip([None, *line], line, [*line[1:], None], strict=False):
        word = token.string
        if token.type in (tokenize.NEWLINE, tokenize.ENDMARKER):
            word = ";"
        elif token.type == tokenize.STRING:
            word = "'"
        elif token.type == tokenize.NUMBER:
            with suppress(ValueError):  # 0x10, 1j
                word = repr(float(word))
        elif token.type == tokenize.NAME and word not in ALWAYS_KNOWN:
            of_an_object = before is not None and before.string == "."
            called = after is not None and after.string == "("
            if not (word in known and (of_an_object or called)):
                word = LOCAL + word
        yield Token(word, token.start, token.end)
