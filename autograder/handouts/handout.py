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
    "autograder/handouts": "__init__.py stubs.lock stubs.py unused.py",
    "autograder/locks": "pictures.lock requirements.lock",
    "autograder/student": "*.py",
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
    code. Exercises that ``chapters`` lack become optional. The README contains ``about``.
    """
    if both := {c.name for c in chapters} & {c.name for c in given}:
        raise ValueError(f"{min(both)} cannot be handed out both as stubs and as given")
    if out.is_file() or (out.exists() and any(out.iterdir())):
        raise ValueError(f"out must be a new or empty folder, got {str(out)!r}")
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
    below = {other.name for chapter in chapters for other in chapters_below(chapter, root)}
    if missing := below - {chapter.name for chapter in [*chapters, *given]}:
        print(f"each student must add: {', '.join(sorted(missing))}")
    print(f"handout: {out}; try it with: make -C {shlex.quote(str(out))} check")


def _fill(chapters: list[Chapter], given: list[Chapter], out: Path, root: Path, about: str) -> None:
    """Copy or generate every file of a handout into the folder ``out``."""
    for file in [*student_tools(root), *shared_by_checks(root)]:
        _copy([file], out / file.parent.relative_to(root))
    for room in ("lab", "plots"):
        _copy_room(root / room, out, [chapter.name for chapter in (*chapters, *given)])
    _copy([root / "chapters" / "README.md"], out / "chapters")
    _copy([root / "docs/claims.md", root / "docs/errata.md"], out / "docs")
    stubs = make_stubs(root)
    for chapter in [*chapters, *given]:
        source, target = (place / "chapters" / chapter.name for place in (root, out))
        for name in ("README.md", "reference.md", *chapter.complete):
            _copy([source / name], (target / name).parent)
        _copy((source / "pictures").glob("*"), target / "pictures")
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
        _copy((root / "solutions" / chapter.name).glob("*.py"), out / "chapters" / chapter.name)
    titles = ", ".join(chapter.title.lower() for chapter in chapters)
    readme = Path(__file__).with_name("readme.txt").read_text(encoding="utf-8")
    readme = readme.format(titles=titles, example=chapters[0].exercises[0].id)
    heading, _, body = readme.partition("\n\n")
    _write(out / "README.md", "\n\n".join(filter(None, [heading, about, body])))
    for page in out.rglob("*.md"):  # links to files that the handout does not contain
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
        if numbered and not any(name.startswith(numbered[0]) for name in chapters):
            continue
        if file.is_file() and file.name not in (CHARTS, LESSONS) and file.suffix != ".pyc":
            _copy([file], out / path.parent)


def _copy(files: Iterable[Path], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for file in files:
        if file.is_file():
            shutil.copyfile(file, folder / file.name)


def _write(file: Path, text: str) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8", newline="\n")
