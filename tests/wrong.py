"""Make the wrong submissions that a chapter's wrong.toml describes."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, field
from pathlib import Path

import libcst

from autograder.manifest import ROOT, Chapter
from autograder.stubs import with_bodies


@dataclass(frozen=True)
class Wrong:
    """The reference with one body as a student may have written it, and the checks it loses."""

    mistake: str
    edit: str
    body: str
    loses: list[str] = field(default_factory=list)


def read_wrong(chapter: Chapter) -> list[Wrong]:
    """Return the wrong submissions of a chapter."""
    text = (ROOT / "tests" / chapter.name / "wrong.toml").read_text(encoding="utf-8")
    return [Wrong(**entry) for entry in tomllib.loads(text)["wrong"]]


def write_wrong(chapter: Chapter, wrong: Wrong, engine: Path) -> None:
    """Write the one module that differs from the reference into an engine folder."""
    module, _, name = wrong.edit.partition(".")
    file = f"{chapter.name}/{module}.py"
    source = (ROOT / "solutions" / file).read_text(encoding="utf-8")
    changed = with_bodies(libcst.parse_module(source), {name: wrong.body.strip() + "\n"})
    (engine / chapter.name).mkdir(parents=True, exist_ok=True)
    (engine / file).write_text(changed.code, encoding="utf-8")
