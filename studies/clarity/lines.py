"""Count the lines of code of a function, a class or a method."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from pathlib import Path

Definition = ast.FunctionDef | ast.ClassDef


def lines_of(engine: Sequence[Path], file: str, name: str) -> int:
    """Count the lines of a definition without its docstrings, comments and empty lines.

    ``engine`` lists the folders in which to look for ``file``.
    """
    path = next(folder / file for folder in engine if (folder / file).is_file())
    text = path.read_text(encoding="utf-8")
    node: ast.Module | Definition = ast.parse(text)
    for part in name.split("."):
        node = next(n for n in node.body if isinstance(n, Definition) and n.name == part)
    assert isinstance(node, Definition)
    said = {
        line
        for inner in ast.walk(node)
        if isinstance(inner, Definition) and ast.get_docstring(inner)
        for line in range(inner.body[0].lineno, (inner.body[0].end_lineno or 0) + 1)
    }
    rows = enumerate(text.splitlines(), 1)
    return sum(
        node.lineno <= number <= (node.end_lineno or 0)
        and number not in said
        and bool(row.strip())
        and not row.strip().startswith("#")
        for number, row in rows
    )
