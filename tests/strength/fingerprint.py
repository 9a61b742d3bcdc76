"""What figures were measured on: they are old once a check or a solution has changed since."""

from __future__ import annotations

import ast
import hashlib
import io
import tokenize
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

from autograder.checks.arrange import shared_by_checks
from autograder.manifest import ROOT, Chapter


def of_checks(chapter: Chapter, solution: Path) -> str:
    """Return the fingerprint of a chapter's checks and of the modules of a solution."""
    checks = sorted((ROOT / "tests" / chapter.name).glob("*.py"))
    modules = [solution / chapter.name / file for file in chapter.edited_files]
    return fingerprint([*checks, *shared_by_checks(ROOT), *modules])


def of_check_file(check: Path, chapter: Chapter, solution: Path) -> str:
    """Return the fingerprint of a file of checks and of all modules that it imports.

    Sentences don't count, because no right solution passes or fails by the words of a message.
    """
    folders = [ROOT / "tests" / chapter.name, ROOT / "tests/shared", solution / chapter.name]
    found: set[Path] = set()
    left = [check, ROOT / "tests/conftest.py"]
    while left:
        file = left.pop()
        if file not in found:
            found.add(file)
            files = (
                folder / f"{name}.py" for name in _imports(file, chapter) for folder in folders
            )
            left += [file for file in files if file.is_file()]
    return fingerprint(sorted(found), sentences=False)


def _imports(file: Path, chapter: Chapter) -> Iterator[str]:
    """Yield the names of the modules that a file imports, without the chapter's name."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        match node:
            case ast.ImportFrom(module=str(module), names=names) if module == chapter.name:
                yield from (name.name for name in names)
            case ast.ImportFrom(module=str(module)):
                yield module.removeprefix(f"{chapter.name}.")
            case ast.Import(names=names):
                yield from (name.name.removeprefix(f"{chapter.name}.") for name in names)


def fingerprint(files: Iterable[Path], *, sentences: bool = True) -> str:
    """Return a hash of the code in files, without docstrings, comments, layout and quoted words.

    If ``sentences`` is False, strings that contain a space don't count either.
    """
    digest = hashlib.sha256()
    for file in files:
        text = file.read_text(encoding="utf-8")
        digest.update((_code(text) if sentences else _logic(text)).encode())
    return digest.hexdigest()[:16]


@cache
def _logic(source: str) -> str:
    """Return the code of a module, without docstrings, comments and strings with a space."""
    return ast.unparse(WithoutSentences().visit(ast.parse(source)))


class WithoutSentences(ast.NodeTransformer):
    """Empties every string that contains a space, and drops docstrings and quoted words."""

    def visit_Expr(self, node: ast.Expr) -> ast.AST | None:
        is_text = isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
        return None if is_text else self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> ast.Constant:
        return ast.Constant("") if isinstance(node.value, str) and " " in node.value else node

    def visit_JoinedStr(self, node: ast.JoinedStr) -> ast.expr:
        texts = [part.value for part in node.values if isinstance(part, ast.Constant)]
        return ast.Constant("") if any(" " in str(text) for text in texts) else node

    def visit_keyword(self, node: ast.keyword) -> ast.AST | None:
        return None if node.arg == "asks" else self.generic_visit(node)


@cache
def _code(source: str) -> str:
    """Return a module's tokens in a row, without docstrings, comments and quoted words."""
    dropped = set()
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Module() | ast.ClassDef() | ast.FunctionDef() if ast.get_docstring(node):
                dropped.add((node.body[0].lineno, node.body[0].col_offset))
            case ast.keyword(arg="asks", value=words):
                dropped.add((words.lineno, words.col_offset))
    tokens = tokenize.generate_tokens(io.StringIO(source).readline)
    kept = [t.string for t in tokens if t.type != tokenize.COMMENT and t.start not in dropped]
    return "".join("".join(kept).split())
