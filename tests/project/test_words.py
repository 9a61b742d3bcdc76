"""The old words of the companion do not return to text that a reader sees."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from autograder.manifest import ROOT

# The old wording, and what a native writer would write instead.
OLD = {
    r"\bas new\b(?! \w+s\b| matrix)": "Return a new vector ...",
    r"\bturned round\b|\bturn(?:s)? (?:it )?round\b": "reversed, rotated",
    r"\bwhat is no\b": "anything that is not a number",
    r"\bbears? (?:a|how|such)\b": "is stable up to, tolerates",
    r"\bstands? (?:there|twice)\b": "is listed, appears twice",
    r"\bat hand\b": "available",
    r"\bgo(?:es)? on where it\b": "resumes",
    r"\bmend(?:s|ed)?\b|\bput right\b": "fix, correct",
    r"\bis told\b|\bare told\b": "is reported, is shown",
    r"\bwhoever\b": "name the person",
    r"\bone's own\b": "your own",
    r"\bsimply\b|\bobviously\b": "leave it out",
}
KINDS = (ast.Module, ast.ClassDef, ast.FunctionDef)


def found(text: str) -> list[str]:
    """Return the old words in a text, each with its replacement."""
    return [f"{hit[0]!r}: {new}" for old, new in OLD.items() for hit in re.finditer(old, text)]


def prose(file: Path) -> str:
    """Return a page without its code, or the docstrings of a module."""
    text = file.read_text(encoding="utf-8")
    if file.suffix != ".py":
        return re.sub(r"(?ms)^```.*?^```|`[^`]*`", "", text)
    nodes = [node for node in ast.walk(ast.parse(text)) if isinstance(node, KINDS)]
    return "\n".join(ast.get_docstring(node) or "" for node in nodes)


@pytest.mark.parametrize(
    "patterns",
    [
        ("*.md", "docs/*.md", "*/README.md", "chapters/*/*.md", "chapters/*/chapter.toml"),
        ("solutions/*/*.py", "chapters/*/*.py"),
    ],
    ids=["pages", "docstrings"],
)
def test_what_a_reader_sees_is_in_plain_english(patterns: tuple[str, ...]) -> None:
    files = [file for pattern in patterns for file in sorted(ROOT.glob(pattern))]
    words = {file.relative_to(ROOT).as_posix(): found(prose(file)) for file in files}
    assert len(words) > 40
    assert {file: old for file, old in words.items() if old} == {}
