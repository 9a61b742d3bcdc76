"""Make a handout, the folder with stubs, checks and tools that an instructor gives to students."""

from __future__ import annotations

import re
import shlex
import shutil
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path

from autograder.checks.arrange import shared_by_checks
from autograder.course.handout import for_students, manifest_of
from autograder.handouts.stubs import KEPT, make_stubs
from autograder.handouts.tables import with_table
from autograder.manifest import ROOT, Chapter, chapters_below, load_chapter

STUDENT_TOOLS = {
    ".": "Makefile pyproject.toml LICENSE .gitignore glossary.md",
    ".vscode": "*.json",
    "autograder": (
        "__init__.py __main__.py accepted_files.py answers.py commands.* definitions.py files.py "
        "local_server.py make_venv.py manifest.py message.py options.py records.py scores.py"
    ),
    "autograder/at_home": "*.py",
    "autograder/checks": "*.py",
    "autograder/diagnosis": "*.py",
    "autograder/handouts": "__init__.py bodies.py lock.py stubs.lock stubs.py unused.py",
    "autograder/locks": "pictures.lock requirements.lock",
    "autograder/student": "*.py",
    "autograder/student/debugging": "*.py",
    "autograder/student/watching": "*.py",
    "autograder/text": "*.py",
    "scenes": "*.py",
}

PAGE_LINK = re.compile(r"(?<!!)\[([^\[\]]*)\]\(([^)#:\s]+\.(?:md|py))(?:#[^)]*)?\)")
CHARTS = "charts.py"  # these scenes draw charts of the reference, so students don't need them
LESSONS = "figures.py"  # draws the pictures of the lessons
KEPT_README = """\
This folder has the original stubs, which `make reset` restores. Do not edit or hand in these files.
"""


def student_tools(root: Path = ROOT) -> Iterator[Path]:
    """Yield the files of a handout that students use but do not write, such as the Makefile."""
    for folder, names in STUDENT_TOOLS.items():
        for name in names.split():
            yield from sorted((root / folder).glob(name))


def make_handout(
    chapters: list[Chapter], given: list[Chapter], out: Path, root: Path = ROOT, *, about: str = ""
) -> None:
    """Write the folder that an instructor gives to students, and print a summary of its contents.

    Students receive ``chapters`` as stubs with their checks, and the ``given`` chapters as finished
    code without checks. Exercises in a manifest that are missing from ``chapters`` become optional.
    The text ``about`` is the section of the README that describes the assignment.

    Raises:
        ValueError: A chapter is in both lists, or the folder ``out`` is not new or empty.
    """
    if both := [c.name for c in chapters if c.name in [other.name for other in given]]:
        raise ValueError(f"{', '.join(both)} cannot be handed out both as stubs and as given")
    if out.exists() and not out.is_dir():
        raise ValueError(f"out must be a new or empty folder, but {out} is a file")
    if out.exists() and any(out.iterdir()):
        raise ValueError(f"out must be a new or empty folder, but {out} is not empty. Name another")
    part = out.resolve().with_name(f".{out.resolve().name}.part")
    shutil.rmtree(part, ignore_errors=True)  # left over from a run that was killed
    try:
        _fill(chapters, given, part, root, about)
        out.mkdir(parents=True, exist_ok=True)
        for path in part.iterdir():
            shutil.move(path, out / path.name)
    finally:
        shutil.rmtree(part, ignore_errors=True)
    print(f"as stubs: {', '.join(chapter.name for chapter in chapters)}")
    if given:
        print(f"given complete: {', '.join(chapter.name for chapter in given)}")
    there = [chapter.name for chapter in [*chapters, *given]]
    below = [other for chapter in chapters for other in chapters_below(chapter, root)]
    if missing := sorted({other.name for other in below if other.name not in there}):
        print(f"each student must add: {', '.join(missing)}")
    print(f"handout: {out}; try it with: make -C {shlex.quote(str(out))} check")


def _fill(chapters: list[Chapter], given: list[Chapter], out: Path, root: Path, about: str) -> None:
    """Copy or generate every file of a handout into the folder ``out``."""
    for file in [*student_tools(root), *shared_by_checks(root)]:
        _copy([file], out / file.parent.relative_to(root))
    names = [chapter.name for chapter in (*chapters, *given)]
    _copy_room(root / "lab", out, names)
    _copy_room(root / "plots", out, names)
    _copy([root / "chapters" / "README.md"], out / "chapters")
    _copy([root / "docs/claims.md", root / "docs/errata.md"], out / "docs")
    stubs = make_stubs(root)
    for chapter in [*chapters, *given]:
        source = root / "chapters" / chapter.name
        for name in ("README.md", "reference.md", *chapter.complete):
            _copy([source / name], (out / "chapters" / chapter.name / name).parent)
        _copy((source / "pictures").glob("*"), out / "chapters" / chapter.name / "pictures")
    for chapter in chapters:
        folder = f"chapters/{chapter.name}"
        _write_manifest(chapter, root / folder, out / folder)
        for path, text in stubs.items():
            if path.startswith(folder + "/"):  # made anew, since the files here may be edited
                _write(out / path, text)
                if path.endswith(".py"):
                    _write(out / KEPT / chapter.name / Path(path).name, text)
        tests = root / "tests" / chapter.name
        _copy([*tests.glob("test_*.py"), *tests.glob("*probes.py")], out / "tests" / chapter.name)
    _write(out / KEPT / "README.md", KEPT_README)
    for chapter in given:
        modules = (root / "solutions" / chapter.name).glob("*.py")
        _copy(modules, out / "chapters" / chapter.name)
    titles = ", ".join(chapter.title.lower() for chapter in chapters)
    example = chapters[0].exercises[0].id
    readme = Path(__file__).with_name("readme.txt").read_text(encoding="utf-8")
    heading, _, body = readme.format(titles=titles, example=example).partition("\n\n")
    _write(out / "README.md", "\n\n".join(filter(None, [heading, about, body])))
    _remove_dead_links(out)


def _remove_dead_links(out: Path) -> None:
    """Replace links to files that the handout does not contain with plain text."""
    for page in out.rglob("*.md"):
        text = page.read_text(encoding="utf-8")
        for link in PAGE_LINK.finditer(text):
            if not (page.parent / link[2]).exists():
                text = text.replace(link[0], link[1])
        _write(page, text)


def _write_manifest(chapter: Chapter, source: Path, target: Path) -> None:
    """Write a chapter's manifest and table of exercises, with the points of this assignment."""
    whole = for_students(load_chapter(source), chapter)
    text = (source / "chapter.toml").read_text(encoding="utf-8")
    if whole != load_chapter(source):
        text = manifest_of(text, whole)
        page = target / "reference.md"
        if page.is_file():
            _write(page, with_table(page.read_text(encoding="utf-8"), whole))
    _write(target / "chapter.toml", text)


def _copy_room(room: Path, out: Path, chapters: Collection[str]) -> None:
    """Copy a room such as lab/ into a handout, without chapters that students do not receive."""
    for file in room.rglob("*"):
        path = file.relative_to(room.parent)
        numbered = re.search(r"ch\d\d_", str(path))
        wanted = not numbered or any(name.startswith(numbered[0]) for name in chapters)
        wanted = wanted and file.name not in (CHARTS, LESSONS)
        if wanted and file.is_file() and "__pycache__" not in file.parts:
            _copy([file], out / path.parent)


def _copy(files: Iterable[Path], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for file in files:
        if file.is_file():
            shutil.copyfile(file, folder / file.name)


def _write(file: Path, text: str) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8", newline="\n")
