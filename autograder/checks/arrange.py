"""Assemble the files and settings for a check process.

A check process runs the checks of one chapter on the code of one student.
"""

from __future__ import annotations

import shutil
from collections.abc import Collection
from dataclasses import dataclass, field
from pathlib import Path

from autograder.at_home.students_code import graded_files
from autograder.manifest import Chapter, chapters_below, load_chapters
from autograder.message import Message


@dataclass(frozen=True)
class Behind:
    """Settings for running a student's code in worker processes inside a sandbox.

    Attributes:
        level: The layers of protection to use, as a dictionary with the fields of sandbox.Level.
        fresh: True if every check runs in a new Python interpreter.
        missing: The rejected modules of the submission, each with the reason.
        hidden: A folder of hidden checks, of which students see only a short rationale.
        compiled: A folder that stores the submission's compiled code between runs.
    """

    level: dict[str, bool]
    fresh: bool = False
    missing: dict[str, Message] = field(default_factory=dict)
    hidden: Path | None = None
    compiled: Path | None = None


@dataclass(frozen=True)
class Workers:
    """Settings for the sandboxed worker processes that run a student's code.

    Attributes:
        probes: The folder of our probes. A probe is a part of a check that has to run in the same
            process as the student's code, which can therefore read it.
        hidden_probes: A folder that contains the probes of hidden checks as well. Only the workers
            of hidden checks may use it, because students never see their output.
        compiled: The folder that caches compiled code.
    """

    level: dict[str, bool]
    fresh: bool
    probes: str
    hidden_probes: str
    compiled: str


@dataclass(frozen=True)
class Arranged:
    """The paths for a check process, and what the process has to know about the chapter.

    Attributes:
        known: The ids of the chapter's exercises.
        edits: The functions that students write, listed by exercise.
        modules: The student's modules to import before the checks.
        complete: The files that students use but did not write.
        graded: The files that the grader will have too, listed by chapter folder.
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
    """The configuration that a check process reads when it starts: its files, settings and checks.

    Attributes:
        apart: True if each exercise's checks run in a forked copy of the process.
        broken: The modules that cannot be imported, each with the reason.
        done: The checks that already have a verdict and need not run again.
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
    folder: Path,
    chapter: Chapter,
    engine: list[Path],
    root: Path,
    behind: Behind | None,
    rejected: Collection[str],
) -> Arranged:
    """Prepare ``folder`` for a check process, and return the paths and settings to use.

    ``rejected`` names the files that the grader would not take, such as ch07_constraints.drops.csv.
    """
    chapters = [*chapters_below(chapter, root), chapter]
    hidden = _put_hidden_checks(folder, chapter, root, behind)
    return Arranged(
        root=str(root_of_checks(folder, root, behind)),
        engine=[str(path) for path in engine],
        # These paths are relative to root, because pytest does not accept brackets in a path.
        tests=[f"tests/{chapter.name}", *hidden],
        known=[exercise.id for exercise in chapter.exercises],
        chapter=chapter.name,
        edits={exercise.id: exercise.edit for exercise in chapter.exercises},
        modules=_modules(chapter, chapters, engine, root),
        complete=[f"{c.name}/{file}" for c in chapters for file in c.complete],
        graded={
            package: [file for file in files if f"{package}.{file}" not in rejected]
            for package, files in graded_files(load_chapters(root)).items()
        },
        worker=_workers(folder, chapter, root, behind),
    )


def root_of_checks(folder: Path, root: Path, behind: Behind | None) -> Path:
    """Return the folder from which pytest runs the checks.

    This is normally the project's own folder. If there are hidden checks, it is a temporary folder
    that contains both the public and the hidden tests.
    """
    return folder / "root" if behind and behind.hidden else root


def shared_by_checks(root: Path) -> list[Path]:
    """List the helper modules in tests/ that are shared by the checks of all chapters."""
    return [root / "tests/conftest.py", *sorted((root / "tests/shared").glob("*.py"))]


def _put_hidden_checks(
    folder: Path, chapter: Chapter, root: Path, behind: Behind | None
) -> list[str]:
    """Copy a chapter's hidden and public checks into a folder from which pytest can run them.

    Returns:
        The path of the hidden checks relative to that folder, as a list with one item. If the
        chapter has no hidden checks, the list is empty.
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
    """Create the folders for the sandboxed worker processes, and return the workers' settings.

    Return None if there is no sandbox.
    """
    if behind is None:
        return None
    public = _put_probes(folder / "probes", chapter, [root / "tests"])
    hidden = public
    if behind.hidden and any((behind.hidden / chapter.name).glob("*probes.py")):
        hidden = _put_probes(folder / "hidden_probes", chapter, [root / "tests", behind.hidden])
    compiled = behind.compiled or folder / "compiled"
    compiled.mkdir(exist_ok=True)
    return Workers(behind.level, behind.fresh, str(public), str(hidden), str(compiled))


def _put_probes(folder: Path, chapter: Chapter, tests: list[Path]) -> Path:
    """Copy the chapter's probes from folders of checks into a new folder, and return it."""
    (folder / chapter.name).mkdir(parents=True)
    for file in (file for of in tests for file in (of / chapter.name).glob("*probes.py")):
        shutil.copyfile(file, folder / chapter.name / file.name)
    return folder


def _modules(
    chapter: Chapter, chapters: list[Chapter], engine: list[Path], root: Path
) -> list[str]:
    """List the student's modules, which are imported one by one before the checks run.

    Each import is tried even if another one has failed, so that all broken modules are found. If a
    handout contains an earlier chapter without its manifest, all files of that chapter are
    imported.
    """
    files = {c.name: c.edited_files for c in chapters}
    listed = {c.name for c in load_chapters(root)}
    for file in sorted(f for folder in engine for f in folder.glob("ch??_*/*.py")):
        name = file.parent.name
        if name < chapter.name and name not in listed:
            files.setdefault(name, []).append(file.name)
    return [f"{name}.{file[:-3]}" for name in sorted(files) for file in files[name]]
