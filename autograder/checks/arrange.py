"""Assemble the files and settings for a process that checks one chapter of one student."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from autograder.accepted_files import module_of
from autograder.at_home.restrictions import graded_files
from autograder.manifest import ROOT, Chapter, chapters_below, load_chapters
from autograder.message import Message

NO_CACHE = shutil.ignore_patterns("__pycache__")


@dataclass(frozen=True)
class SandboxSettings:
    """Settings for running a student's code in worker processes inside a sandbox."""

    level: dict[str, bool]  # the layers of protection to use, which are the fields of sandbox.Level
    missing: dict[str, Message] = field(default_factory=dict)  # why each module was rejected
    hidden: Path | None = None  # a folder of checks of which students see only a short rationale
    compiled: Path | None = None  # a folder that keeps the submission's bytecode between runs


@dataclass(frozen=True)
class Request:
    """A request to run some of a chapter's checks on the code in the folders of ``engine``."""

    chapter: Chapter
    engine: list[Path]
    exercises: list[str]
    seed: str
    sandbox: SandboxSettings | None = None
    root: Path = ROOT


@dataclass(frozen=True)
class Config:
    """The configuration that a check process reads when it starts."""

    chapter: str
    root: str  # the folder from which pytest runs the checks
    engine: list[str]
    tests: list[str]  # the folders of checks, relative to the root
    known: list[str]  # the ids of the chapter's exercises
    modules: list[str]  # the student's modules to import before the checks
    complete: list[str]  # the files that students use but did not write
    graded: dict[str, list[str]]  # the files that the grader will have too, by chapter
    level: dict[str, bool] | None  # that of the sandbox, if there is one
    probes: list[str]  # folders of probes: of public checks, and if there are any, of hidden ones
    compiled: str  # the folder for bytecode
    exercises: list[str]
    seed: str
    time_limit: float
    stack_file: str
    broken: dict[str, Message]  # why each module cannot be imported
    done: list[str]  # the checks that already have a verdict, and need not run again


def arrange(
    folder: Path,
    request: Request,
    time_limit: float,
    broken: Mapping[str, Message],
    done: Iterable[str],
) -> Config:
    """Prepare the new ``folder`` for a check process, and return the process's configuration."""
    chapter, root, sandbox = request.chapter, request.root, request.sandbox
    chapters = [*chapters_below(chapter, root), chapter]
    # These paths are relative to the root, because pytest does not accept brackets in a path.
    place, tests = root, [f"tests/{chapter.name}"]
    if sandbox and sandbox.hidden:
        place = folder / "root"
        tests += _put_checks(place, chapter.name, root, sandbox.hidden)
    return Config(
        chapter=chapter.name,
        root=str(place),
        engine=[str(path) for path in request.engine],
        tests=tests,
        known=[exercise.id for exercise in chapter.exercises],
        modules=_modules(chapter, chapters, request),
        complete=[f"{c.name}/{file}" for c in chapters for file in c.complete],
        graded={
            # A rejected data file is listed too, as in ch07_constraints.drops.csv.
            package: [file for file in files if f"{package}.{file}" not in broken]
            for package, files in graded_files(load_chapters(root)).items()
        },
        level=sandbox.level if sandbox else None,
        probes=_put_probes(folder, chapter.name, root, sandbox.hidden) if sandbox else [],
        compiled=str((sandbox and sandbox.compiled) or folder / "compiled"),
        exercises=request.exercises,
        seed=request.seed,
        time_limit=time_limit,
        stack_file=str(folder / "stack.txt"),
        broken=dict(broken),
        done=list(done),
    )


def shared_by_checks(root: Path) -> list[Path]:
    """List the helper modules in tests/ that are shared by the checks of all chapters."""
    return [root / "tests/conftest.py", *sorted((root / "tests/shared").glob("*.py"))]


def _put_checks(place: Path, name: str, root: Path, hidden: Path) -> list[str]:
    """Copy public and hidden checks into a folder, and return where in it the hidden ones are."""
    shutil.copytree(root / "tests" / name, place / "tests" / name, ignore=NO_CACHE)
    for file in [root / "pyproject.toml", *shared_by_checks(root)]:
        copy = place / file.relative_to(root)
        copy.parent.mkdir(exist_ok=True)
        shutil.copyfile(file, copy)
    if not (hidden / name).is_dir():
        return []
    shutil.copytree(hidden / name, place / "tests/hidden" / name, ignore=NO_CACHE)
    return [f"tests/hidden/{name}"]


def _put_probes(folder: Path, name: str, root: Path, hidden: Path | None) -> list[str]:
    """Copy the probes of a chapter into new folders, of which the second has the hidden ones too.

    A probe is a part of a check that has to run in the same process as the student's code, which
    can therefore read it. Only the workers of hidden checks, whose output students never see, may
    use the second folder.
    """
    (folder / "compiled").mkdir()
    probes = [*(root / "tests" / name).glob("*probes.py")]
    secret = [*(hidden / name).glob("*probes.py")] if hidden else []
    folders = [folder / "probes", folder / "hidden_probes"][: 2 if secret else 1]
    for place, files in zip(folders, (probes, probes + secret), strict=False):
        (place / name).mkdir(parents=True)
        for file in files:
            shutil.copyfile(file, place / name / file.name)
    return [*map(str, folders)]


def _modules(chapter: Chapter, chapters: list[Chapter], request: Request) -> list[str]:
    """List the student's modules, with all files of an earlier chapter without a manifest.

    Checks import the complete modules of the chapter too, which may run the student's code.
    """
    files = {c.name: c.edited_files for c in chapters}
    complete = [file for file in chapter.complete if file.endswith(".py")]
    files[chapter.name] = chapter.edited_files + complete
    listed = {c.name for c in load_chapters(request.root)}
    for file in sorted(f for folder in request.engine for f in folder.glob("ch??_*/*.py")):
        name = file.parent.name
        if name < chapter.name and name not in listed:
            files.setdefault(name, []).append(file.name)
    return [module_of(name, file) for name in sorted(files) for file in files[name]]
