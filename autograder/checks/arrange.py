"""Prepare the files and settings for a process that runs checks."""

from __future__ import annotations

import shutil
from dataclasses import dataclass, field
from pathlib import Path

from autograder.checks.students_code import graded_files
from autograder.manifest import Chapter, chapters_below, load_chapters
from autograder.message import Message


@dataclass(frozen=True)
class Behind:
    """The settings for running untrusted code in worker processes inside a sandbox.

    ``level`` names the layers of the sandbox (a sandbox.Level as a dict). If ``fresh`` is set, each
    check gets a new interpreter. ``missing`` maps each rejected module to the reason for its
    rejection.

    ``hidden`` is a folder of additional checks. Students see only the rationale of a hidden check.
    If ``for_instructor`` is set, the result contains the full messages, so set it only if students
    will not read the result. ``compiled`` is a folder in which the compiled code of a submission is
    kept between runs.
    """

    level: dict[str, bool]
    fresh: bool = False
    missing: dict[str, Message] = field(default_factory=dict)
    hidden: Path | None = None
    for_instructor: bool = False
    compiled: Path | None = None


@dataclass(frozen=True)
class Workers:
    """The settings with which a check process starts its worker processes.

    ``probes`` is the folder of the probes. ``compiled`` is the folder for compiled code.
    """

    level: dict[str, bool]
    fresh: bool
    for_instructor: bool
    probes: str
    compiled: str


@dataclass(frozen=True)
class Arranged:
    """The files and names that a check process works with. Paths are strings, as in JSON.

    ``known`` lists the exercises of the chapter. ``edits`` lists the functions that students write,
    for each exercise. ``modules`` are imported before the checks. ``complete`` lists the files that
    students call but do not write. ``graded`` maps each chapter's folder to its files that also
    exist in the grader.
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
    """The configuration of a check process: its files, its settings and the remaining checks.

    If ``apart`` is set, the checks of each exercise run in a forked copy of the process. ``broken``
    maps each module that cannot be imported to the reason. ``done`` names the checks that already
    have a verdict.
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
    """Prepare ``folder`` for a check process, and return the paths and names that it works with."""
    chapters = [*chapters_below(chapter, root), chapter]
    hidden = _put_hidden_checks(folder, chapter, root, behind)
    return Arranged(
        root=str(root_of_checks(folder, root, behind)),
        engine=[str(path) for path in engine],
        # The paths are relative to root, because pytest rejects paths that contain brackets.
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
    """Return the folder that contains the checks.

    If there are hidden checks, the result is a copy that contains the public and the hidden checks.
    """
    return folder / "root" if behind and behind.hidden else root


def shared_by_checks(root: Path) -> list[Path]:
    """Return the helper files that the checks of all chapters share."""
    return [root / "tests/conftest.py", *sorted((root / "tests/shared").glob("*.py"))]


def _put_hidden_checks(
    folder: Path, chapter: Chapter, root: Path, behind: Behind | None
) -> list[str]:
    """Copy the public and the hidden checks of this chapter into the folder.

    Return the path of the hidden checks relative to the root, or an empty list if there are none.
    """
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
    """Copy the probes into the folder, and return the settings for the workers."""
    if behind is None:
        return None
    probes = folder / "probes" / chapter.name
    probes.mkdir(parents=True)
    for tests in (root / "tests", behind.hidden):
        for file in (tests / chapter.name).glob("*probes.py") if tests else ():
            shutil.copyfile(file, probes / file.name)
    compiled = behind.compiled or folder / "compiled"
    compiled.mkdir(exist_ok=True)
    return Workers(
        behind.level, behind.fresh, behind.for_instructor, str(probes.parent), str(compiled)
    )


def _modules(
    chapter: Chapter, chapters: list[Chapter], engine: list[Path], root: Path
) -> list[str]:
    """Return the names of the modules to import before the checks.

    A module that cannot be imported does not affect the other modules. If an earlier chapter has no
    manifest, as in some hand-outs, all of its files are included.
    """
    files = {c.name: c.edited_files for c in chapters}
    listed = {c.name for c in load_chapters(root)}
    for file in sorted(f for folder in engine for f in folder.glob("ch??_*/*.py")):
        name = file.parent.name
        if name < chapter.name and name not in listed:
            files.setdefault(name, []).append(file.name)
    return [f"{name}.{file[:-3]}" for name in sorted(files) for file in files[name]]
