"""Show the code that a check runs, with the numbers that it has drawn, as the call in its message.

A check puts its calls of the student's code into a block:

    with calls("The magnitude is the length of the vector."):
        got = Vector3(*a).magnitude()

If the check fails, its message shows Vector3(2.0, 3.0, 6.0).magnitude() as the call. Every name of
a number, a text or a tuple is replaced by its value, and so is arithmetic with such names. Other
names, such as that of a particle, stay as they are, so create the particle in the block, too.
"""

from __future__ import annotations

import ast
import linecache
import math
import re
import sys
from collections import ChainMap
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache
from types import FrameType
from typing import Any

from autograder.checks.asked import Text, about, written

PLAIN = (bool, int, float, str, type(None))
CALCULATION = (
    *(ast.Name, ast.Constant, ast.BinOp, ast.UnaryOp, ast.Subscript, ast.operator, ast.unaryop),
    *(ast.expr_context, ast.JoinedStr, ast.FormattedValue),
)
MATRICES = (9, 12)  # the numbers of a Matrix3 and a Matrix4
GAP = re.compile(r"(\*?)\0(\d+)\0")


@contextmanager
def calls(cause: str, text: str = "", *, more: bool = False) -> Iterator[None]:
    """Run a block of code, and show it as the call if this check fails.

    ``cause`` says what the student has probably done wrong, if the code raises an exception or the
    next expectation fails. ``text`` is shown instead of the code, for example because it runs in a
    loop. With ``more``, the code is appended to that of the block before.
    """
    own = text if text else Block(sys._getframe(2))
    block = Chain(about.but({})[0], own) if more else own
    about(block, cause=cause)
    yield


class Block:
    """The code of a block, which is written only if its check fails.

    The values of names are kept as they were when the block began.
    """

    def __init__(self, frame: FrameType) -> None:
        self.place = frame.f_code.co_filename, frame.f_lineno
        own = {name: v[:] if type(v) is list else v for name, v in frame.f_locals.items()}
        self.known: Mapping[str, Any] = ChainMap(own, frame.f_globals)

    def __call__(self) -> str:
        """Write the statements on one line, with the value of the last one."""
        return self.written()[0]

    def written(self) -> list[str]:
        """Write the statements on one line, without and with the name of the last result."""
        texts, gaps = _template(*self.place)

        def filled(gap: re.Match[str]) -> str:
            star, source = gap[1], gaps[int(gap[2])]
            names = [name.id for name in _names(ast.parse(source))]
            values = {name: self.known.get(name, self.known) for name in names}
            if not all(map(_is_plain, values.values())):
                return star + source
            value = eval(source, {}, values)
            return _spread(value) if star else _literal(value)

        return [GAP.sub(filled, text) for text in texts]


class Chain(Block):
    """A block that continues another one, whose result it may use by its name."""

    def __init__(self, before: Text, own: str | Block) -> None:
        self.before, self.own = before, own

    def written(self) -> list[str]:
        """Write both blocks on one line, without and with the name of the last result."""
        before = (
            self.before.written()[1] if isinstance(self.before, Block) else written(self.before)
        )
        own = [self.own] * 2 if isinstance(self.own, str) else self.own.written()
        return [f"{before}; {each}" for each in own]


@cache
def _blocks(file: str) -> dict[int, ast.With]:
    """Return the with-statements of a file, by each line of their headers."""
    found: dict[int, ast.With] = {}
    for node in ast.walk(ast.parse("".join(linecache.getlines(file)))):
        if isinstance(node, ast.With):
            found |= dict.fromkeys(range(node.lineno, node.body[0].lineno), node)
    return found


@cache
def _template(file: str, line: int) -> tuple[list[str], list[str]]:
    """Return both texts of a block with gaps, and the source of each gap."""
    block = _blocks(file)[line]
    gaps = Gaps({name.id for name in _names(block) if isinstance(name.ctx, ast.Store)})
    copy = ast.parse("\n".join(map(ast.unparse, block.body)))
    *others, last = [gaps.visit(statement) for statement in copy.body]
    statements = [text for statement in others for text in _written(statement)]
    named = _written(last)
    is_result = isinstance(last, ast.Assign) and isinstance(last.targets[0], ast.Name)
    value = [_values(last.value)] if is_result else named
    return ["; ".join([*statements, *end]) for end in (value, named)], gaps.found


class Gaps(ast.NodeTransformer):
    """Replaces each expression that only calculates with names from outside by a gap."""

    def __init__(self, own: set[str]) -> None:
        self.own = own
        self.found: list[str] = []

    def visit(self, node: ast.AST) -> Any:
        """Return the node, or a gap in its place."""
        names = {name.id for name in _names(node)}
        is_plain = all(isinstance(each, CALCULATION) for each in ast.walk(node))
        if not (isinstance(node, ast.expr) and is_plain and names) or names & self.own:
            return self.generic_visit(node)
        self.found.append(ast.unparse(node))
        return ast.Name(f"\0{len(self.found) - 1}\0", ast.Load())


def _names(node: ast.AST) -> list[ast.Name]:
    return [each for each in ast.walk(node) if isinstance(each, ast.Name)]


def _written(statement: ast.stmt) -> list[str]:
    """Write a statement on one line, or several assignments that it makes as one each."""
    if not isinstance(statement, ast.Assign):
        return [ast.unparse(statement)]
    target, value = statement.targets[0], statement.value
    if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
        pairs = zip(target.elts, value.elts, strict=True)
        return [f"{ast.unparse(name)} = {ast.unparse(part)}" for name, part in pairs]
    names = [ast.unparse(each).strip("()") for each in statement.targets]
    return [" = ".join([*names, _values(value)])]


def _values(value: ast.expr) -> str:
    """Write a value, or several without parentheses."""
    parts = value.elts if isinstance(value, ast.Tuple) else [value]
    return ", ".join(map(ast.unparse, parts))


def _is_plain(value: Any) -> bool:
    if isinstance(value, (tuple, list)):
        return all(map(_is_plain, value))
    return type(value) in PLAIN


def _spread(values: Sequence[Any]) -> str:
    """Write the arguments of a starred tuple, those of a long matrix with a line for each row."""
    texts = [*map(_literal, values)]
    across = len(texts) // 3
    if len(texts) not in MATRICES or sum(map(len, texts)) < 60:
        return ", ".join(texts)
    return ",\n    ".join(", ".join(texts[i : i + across]) for i in range(0, 3 * across, across))


def _literal(value: Any) -> str:
    """Write a value as code that gives it again."""
    if isinstance(value, (tuple, list)):
        inside = ", ".join(map(_literal, value))
        if isinstance(value, list):
            return f"[{inside}]"
        return f"({inside},)" if len(value) == 1 else f"({inside})"
    if isinstance(value, float) and not math.isfinite(value):
        return "math.nan" if math.isnan(value) else "math.inf" if value > 0.0 else "-math.inf"
    return repr(value)
