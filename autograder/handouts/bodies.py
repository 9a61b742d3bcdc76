"""Replace the bodies of functions in Python source, so that all else stays byte for byte.

The source is bytes, as in a student's file, which may have a BOM or the line ends of Windows.
"""

from __future__ import annotations

import ast
import codecs
from collections.abc import Mapping
from itertools import accumulate

from autograder.definitions import functions


def with_bodies(source: bytes, bodies: Mapping[str, str]) -> bytes:
    """Replace the bodies of some functions, but keep their docstrings.

    ``bodies`` maps names such as Vector3.dot to the source of the new bodies.
    """
    newline = b"\r\n" if source.partition(b"\n")[0].endswith(b"\r") else b"\n"
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
        text = text[:begin].rstrip() + b"".join(newline + indent + b for b in body) + text[end:]
    return bom + text
