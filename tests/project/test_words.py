"""The old words of the companion do not return to text that a reader sees."""

from __future__ import annotations

import ast
import re

import pytest

from autograder.manifest import ROOT, load_chapters

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
MODULES = [
    path
    for chapter in load_chapters()
    for folder in ("solutions", "chapters")
    for path in sorted((ROOT / folder / chapter.name).glob("*.py"))
]
PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("chapters/*/*.md"), *ROOT.glob("*/README.md")])
MANIFESTS = sorted(ROOT.glob("chapters/*/chapter.toml"))


def found(text: str) -> list[str]:
    """Return the old words in a text, each with its replacement."""
    return [f"{hit[0]!r}: {new}" for old, new in OLD.items() for hit in re.finditer(old, text)]


@pytest.mark.parametrize("path", [*PAGES, *MANIFESTS], ids=str)
def test_a_page_says_it_in_plain_english(path: object) -> None:
    text = re.sub(r"(?ms)^```.*?^```|`[^`]*`", "", path.read_text(encoding="utf-8"))  # type: ignore[attr-defined]
    assert found(text) == []


@pytest.mark.parametrize("path", MODULES, ids=str)
def test_a_docstring_says_it_in_plain_english(path: object) -> None:
    tree = ast.parse(path.read_text(encoding="utf-8"))  # type: ignore[attr-defined]
    kinds = (ast.Module, ast.ClassDef, ast.FunctionDef)
    texts = [ast.get_docstring(node) or "" for node in ast.walk(tree) if isinstance(node, kinds)]
    assert found("\n".join(texts)) == []
