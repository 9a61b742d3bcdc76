"""Arrange what a process of checks works with: the checks, the engine, and walls around it."""

from __future__ import annotations

import shutil
from dataclasses import dataclass, field
from pathlib import Path

from autograder.checks.students_code import graded_files
from autograder.manifest import Chapter, chapters_below, load_chapters
from autograder.message import Message


@dataclass(frozen=True)
class Behind:
    """Where untrusted code runs: in workers, and behind which walls (sandbox.Level as a dict).

    ``fresh`` starts an interpreter for each check; ``missing`` says of modules why they were not
    taken; ``hidden`` is a folder of further checks, of which only the rationale is told, unless
    ``tells`` says that an instructor is to read it.
    """

    level: dict[str, bool]
    fresh: bool = False
    missing: dict[str, Message] = field(default_factory=dict)
    hidden: Path | None = None
    tells: bool = False


@dataclass(frozen=True)
class Workers:
    """How the process of the checks starts its workers. ``probes`` is the folder of the probes."""

    level: dict[str, bool]
    fresh: bool
    tells: bool
    probes: str


@dataclass(frozen=True)
class Arranged:
    """Where everything is that a process of checks works with. Paths are texts, as JSON has it.

    ``known`` are the exercises of the chapter, and ``edits`` the bodies that they have students
    write. ``modules`` are imported before the checks, ``complete`` are the files that students only
    call, and ``graded`` lists the files of each chapter's folder that a grader has.
    """

    root: str
    engine: list[str]
    tests: list[str]
    known: list[str]
    chapter: str
    edits: dict[str, list[str]]
    modules: list[str]
    complete: list[str]
    graded: dict[str, list[str]]
    worker: Workers | None


@dataclass(frozen=True)
class Config:
    """What the process of the checks is told: where everything is, and what is left to do.

    ``apart`` has each exercise checked in a copy of the process. ``broken`` says of modules why
    they cannot be imported, and ``done`` names the checks that have a verdict.
    """

    arranged: Arranged
    exercises: list[str]
    seed: str
    time_limit: float
    apart: bool
    stack_file: str
    broken: dict[str, Message]
    done: list[str]


def arrange(
    folder: Path, chapter: Chapter, engine: list[Path], root: Path, behind: Behind | None
) -> Arranged:
    """Put what is needed into a folder of our own, and return where everything is."""
    chapters = [*chapters_below(chapter, root), chapter]
    hidden = _put_hidden_checks(folder, chapter, root, behind)
    return Arranged(
        root=str(root_of_checks(folder, root, behind)),
        engine=[str(path) for path in engine],
        # Below root, since pytest takes no path with brackets.
        tests=[f"tests/{chapter.name}", *hidden],
        known=[exercise.id for exercise in chapter.exercises],
        chapter=chapter.name,
        edits={exercise.id: exercise.edit for exercise in chapter.exercises},
        modules=_modules(chapter, chapters, engine, root),
        complete=[f"{c.name}/{file}" for c in chapters for file in c.complete],
        graded=graded_files(load_chapters(root)),
        worker=_workers(folder, chapter, root, behind),
    )


def root_of_checks(folder: Path, root: Path, behind: Behind | None) -> Path:
    """Return where the checks are: in our own folder, where hidden ones join the others."""
    return folder / "root" if behind and behind.hidden else root


def shared_by_checks(root: Path) -> list[Path]:
    """Return the files that the checks of all chapters share."""
    return [root / "tests/conftest.py", *sorted((root / "tests/shared").glob("*.py"))]


def _put_hidden_checks(
    folder: Path, chapter: Chapter, root: Path, behind: Behind | None
) -> list[str]:
    """Put the hidden checks of this chapter beside the others; return where, from the root."""
    if not behind or not behind.hidden:
        return []
    tests = folder / "root" / "tests"
    shutil.copytree(
        root / "tests" / chapter.name,
        tests / chapter.name,
        ignore=shutil.ignore_patterns("__pycache__"),
    )
    shutil.copyfile(root / "pyproject.toml", folder / "root" / "pyproject.toml")
    for file in shared_by_checks(root):
        copy = folder / "root" / file.relative_to(root)
        copy.parent.mkdir(exist_ok=True)
        shutil.copyfile(file, copy)
    hidden = behind.hidden / chapter.name
    if not hidden.is_dir():
        return []
    shutil.copytree(
        hidden, tests / "hidden" / chapter.name, ignore=shutil.ignore_patterns("__pycache__")
    )
    return [f"tests/hidden/{chapter.name}"]


def _workers(folder: Path, chapter: Chapter, root: Path, behind: Behind | None) -> Workers | None:
    """Return how the workers are started, whose probes are put into the folder."""
    if behind is None:
        return None
    probes = folder / "probes" / chapter.name
    probes.mkdir(parents=True)
    for tests in (root / "tests", behind.hidden):
        for file in (tests / chapter.name).glob("*probes.py") if tests else ():
            shutil.copyfile(file, probes / file.name)
    return Workers(behind.level, behind.fresh, behind.tells, str(probes.parent))


def _modules(
    chapter: Chapter, chapters: list[Chapter], engine: list[Path], root: Path
) -> list[str]:
    """Return the modules to import before the checks do, so that a bad one stops no other.

    Chapters below that have no manifest here, as in some hand-outs, are taken as they are.
    """
    files = {c.name: c.edited_files for c in chapters}
    listed = {c.name for c in load_chapters(root)}
    for file in sorted(f for folder in engine for f in folder.glob("ch??_*/*.py")):
        name = file.parent.name
        if name < chapter.name and name not in listed:
            files.setdefault(name, []).append(file.name)
    return [f"{name}.{file[:-3]}" for name in sorted(files) for file in files[name]]
