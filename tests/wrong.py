"""Make the wrong submissions that a chapter's wrong.toml describes."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Sequence
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
    says: str = ""  # words of the first message, where the numbers tell the mistake
    opens: str = ""  # the body that the screen sends the student to, where it is another one


def read_wrong(chapter: Chapter) -> list[Wrong]:
    """Return the wrong submissions of a chapter."""
    text = (ROOT / "tests" / chapter.name / "wrong.toml").read_text(encoding="utf-8")
    return [Wrong(**entry) for entry in tomllib.loads(text)["wrong"]]


def write_wrong(chapter: Chapter, wrongs: Iterable[Wrong], engine: Path) -> None:
    """Write the modules that differ from the reference into an engine folder."""
    bodies: dict[str, dict[str, str]] = {}
    for wrong in wrongs:
        module, _, name = wrong.edit.partition(".")
        bodies.setdefault(f"{module}.py", {})[name] = wrong.body.strip() + "\n"
    for file, changed in bodies.items():
        _write_changed(chapter, file, changed, engine)


def write_all(chapter: Chapter, body: str | None, engine: Path, *, but: Sequence[str] = ()) -> None:
    """Write modules with the same line in every body that students write, or empty modules.

    Data that students enter is left empty. The exercises in ``but`` stay as in the reference.
    """
    changed = [e for e in chapter.exercises if e.id not in but]
    names = [name.partition(".") for exercise in changed for name in exercise.edit]
    for file in chapter.edited_files:
        if body is None:
            (engine / chapter.name).mkdir(exist_ok=True)
            (engine / chapter.name / file).touch()
            continue
        bodies = {name: body for module, _, name in names if f"{module}.py" == file}
        _write_changed(chapter, file, bodies, engine)
    for exercise in changed:
        for name in exercise.files:
            (engine / chapter.name / name).touch()


def _write_changed(chapter: Chapter, file: str, bodies: dict[str, str], engine: Path) -> None:
    source = (ROOT / "solutions" / chapter.name / file).read_text(encoding="utf-8")
    (engine / chapter.name).mkdir(parents=True, exist_ok=True)
    code = with_bodies(libcst.parse_module(source), bodies).code
    (engine / chapter.name / file).write_text(code, encoding="utf-8")
