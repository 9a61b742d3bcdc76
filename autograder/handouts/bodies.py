"""Edit Python source by the line ranges of its syntax tree, so that all else stays byte for byte.

The source is bytes, as in a student's file, which may have a BOM or the line ends of Windows.
"""

from __future__ import annotations

import ast
import codecs
from collections.abc import Mapping
from itertools import accumulate

from autograder.definitions import Scope, functions, scopes


def with_bodies(source: bytes, bodies: Mapping[str, str]) -> bytes:
    """Replace the bodies of some functions, but keep their docstrings.

    ``bodies`` maps names such as Vector3.dot to the source of the new bodies.
    """
    bom = codecs.BOM_UTF8 if source.startswith(codecs.BOM_UTF8) else b""
    text = source.removeprefix(bom)  # positions in the syntax tree do not count it
    lines = text.splitlines(keepends=True)
    starts = [0, *accumulate(map(len, lines))]
    for name, node in reversed(functions(ast.parse(source)).items()):
        if name not in bodies:
            continue
        first, last = node.body[0], node.end_lineno or 0
        before = lines[first.lineno - 1][: first.col_offset]
        begin = starts[first.lineno - 1] + first.col_offset
        end = starts[last - 1] + len(lines[last - 1].rstrip(b"\r\n"))
        indent = b" " * (node.col_offset + 4) if before.strip() else before
        body = bodies[name].strip().encode().splitlines()
        if ast.get_docstring(node, clean=False) is not None:
            ends = starts[(first.end_lineno or 0) - 1] + (first.end_col_offset or 0)
            body.insert(0, text[begin:ends])
        added = b"".join(newline_of(source) + indent + line for line in body)
        text = text[:begin].rstrip() + added + text[end:]
    return bom + text


def put_back(source: bytes, stub: bytes, names: list[str]) -> bytes:
    """Restore functions that a student has deleted, each where it is in the stub.

    A deleted class is restored as a whole. If that is not possible, raise ValueError.
    """
    there = scopes(ast.parse(source))
    lost = {name.partition(".")[0] for name in names if "." in name} - there.keys()
    try:
        for scope, (_, members) in scopes(ast.parse(stub)).items():
            for name in members:
                path = f"{scope}.{name}" if scope else name
                if path in lost or (path in names and scope not in lost):
                    source = _inserted(source, stub, scope, name)
        missing = {*names} - functions(ast.parse(source)).keys()
    except SyntaxError as error:
        raise ValueError("its stub does not fit into the file") from error
    if missing:
        raise ValueError(f"its stub does not define {', '.join(sorted(missing))}")
    return source


def _inserted(source: bytes, stub: bytes, scope: str, name: str) -> bytes:
    """Insert a function or class below its nearest predecessor in the stub, or above the next."""
    lines, model = source.splitlines(keepends=True), stub.splitlines(keepends=True)
    (owner, there), (in_stub, order) = (scopes(ast.parse(s))[scope] for s in (source, stub))
    at = [*order].index(name)
    before = [there[other] for other in [*order][:at] if other in there]
    after = [there[other] for other in [*order][at + 1 :] if other in there]
    if before:
        line = before[-1].end_lineno or 0
    elif after:
        line = first_line(owner, after[0])
    else:
        line = owner.end_lineno or 0 if isinstance(owner, ast.ClassDef) else len(lines)
    chunk = model[first_line(in_stub, order[name]) : order[name].end_lineno]
    if isinstance(owner, ast.ClassDef):  # the student's own indentation
        indent = lines[owner.body[0].lineno - 1][: owner.body[0].col_offset]
        chunk = [indent + part[4:] if part.startswith(b"    ") else part for part in chunk]
    newline = newline_of(source)
    chunk = [part.rstrip(b"\r\n") + newline for part in chunk]
    if lines and not lines[-1].endswith((b"\r", b"\n")):
        lines[-1] += newline
    if not b"".join(lines[line:]).strip():  # drop blank lines at the end of the file
        del lines[line:]
    return b"".join([*lines[:line], *chunk, *lines[line:]])


def first_line(scope: Scope, node: ast.stmt) -> int:
    """Return the index of the first line of a statement, with comments and blank lines above it."""
    ends = [other.end_lineno or 0 for other in scope.body if other.lineno < node.lineno]
    lines = [part.lineno for part in getattr(node, "decorator_list", [])]
    return max(ends, default=min([node.lineno, *lines]) - 1)


def newline_of(source: bytes) -> bytes:
    """Return the line end that a file uses."""
    return b"\r\n" if source.partition(b"\n")[0].endswith(b"\r") else b"\n"
