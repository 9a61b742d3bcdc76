"""Turn our solutions into the stubs in chapters/, the unfinished files that students complete.

In a stub, each function that students write keeps its signature and docstring, but its body becomes
``raise NotImplementedError``. If a stub no longer has its hash in stubs.lock, somebody has edited
it, and it is never overwritten.
"""

from __future__ import annotations

import ast
import json
from pathlib import Path

from autograder.answers import blank_answers
from autograder.definitions import functions
from autograder.files import replace_bytes
from autograder.handouts.bodies import with_bodies
from autograder.handouts.lock import LOCK_NAME, read_lock, stub_hash
from autograder.handouts.unused import without_unused
from autograder.manifest import ROOT, Chapter, load_chapters

KEPT = "stubs"  # the folder of a handout with the original stubs


def make_stubs(root: Path = ROOT) -> dict[str, str]:
    """Generate the text of every file that students start from, keyed by its path in ``root``.

    The files are Python stubs, answers.md without the model answers, and data files that contain
    only the column names.
    """
    stubs = {}
    for chapter in load_chapters(root):
        solution = root / "solutions" / chapter.name
        for name in chapter.edited_files:
            stubs[f"chapters/{chapter.name}/{name}"] = stub_of(chapter, name, root)
        for name in chapter.data_files:
            with (solution / name).open(encoding="utf-8") as file:
                stubs[f"chapters/{chapter.name}/{name}"] = file.readline()
        answers = solution / "answers.md"
        if answers.exists():
            text = answers.read_text(encoding="utf-8")
            stubs[f"chapters/{chapter.name}/answers.md"] = blank_answers(text)
    return stubs


def stub_of(chapter: Chapter, file: str, root: Path = ROOT) -> str:
    """Generate the stub of one module, such as vector.py, from our solution."""
    source = (root / "solutions" / chapter.name / file).read_text(encoding="utf-8")
    return stub_module(source, messages_of(chapter, file))


def pristine_stub(chapter: Chapter, file: str, root: Path = ROOT) -> str | None:
    """Return the original stub of a module from our solution, or from the copy in a handout.

    If there is neither, the result is None.
    """
    if (root / "solutions" / chapter.name / file).is_file():
        return stub_of(chapter, file, root)
    kept = root / KEPT / chapter.name / file
    return kept.read_text(encoding="utf-8") if kept.is_file() else None


def write_stubs(root: Path = ROOT) -> tuple[list[str], list[str]]:
    """Write all stubs and stubs.lock. Return the paths that were written, and those left alone.

    A stub that somebody has edited is left alone.
    """
    locked = read_lock(root)
    written, left_alone = [], []
    stubs = make_stubs(root)
    for path, text in stubs.items():
        file = root / path
        current = _read(file)
        if current == text:
            continue
        if current is not None and stub_hash(current) != locked.get(path):
            left_alone.append(path)
            continue
        replace_bytes(file, text.encode())
        written.append(path)
    hashes = {path: stub_hash(text) for path, text in stubs.items() if path not in left_alone}
    hashes |= complete_hashes(root)
    kept = {path: locked[path] for path in left_alone if path in locked}
    lock_text = json.dumps(dict(sorted((hashes | kept).items())), indent=1) + "\n"
    replace_bytes(root / LOCK_NAME, lock_text.encode())
    return written, left_alone


def stale_stubs(root: Path = ROOT) -> list[str]:
    """List the stubs and complete modules in chapters/ that are out of date or have been edited."""
    stale = [path for path, text in make_stubs(root).items() if _read(root / path) != text]
    locked = read_lock(root)
    return stale + [path for path, key in complete_hashes(root).items() if locked.get(path) != key]


def complete_hashes(root: Path = ROOT) -> dict[str, str]:
    """Compute a hash of each module that students use unchanged, keyed by its path in ``root``."""
    paths = [f"chapters/{c.name}/{name}" for c in load_chapters(root) for name in c.complete]
    return {path: stub_hash((root / path).read_text(encoding="utf-8")) for path in paths}


def _read(file: Path) -> str | None:
    """Return the text of a file, or None. One that is not valid UTF-8 then counts as edited."""
    return file.read_text(encoding="utf-8", errors="replace") if file.exists() else None


def stub_module(source: str, messages: dict[str, str]) -> str:
    """Turn a solution into a stub, in which each function of ``messages`` raises its message.

    Private helpers, constants and imports that only the removed bodies used would give the solution
    away, so they are removed too.

    Raises:
        ValueError: The module does not define one of the names.
    """
    if missing := messages.keys() - functions(ast.parse(source)).keys():
        raise ValueError(f"the solution does not define {', '.join(sorted(missing))}")
    return without_unused(without_bodies(source.encode(), messages).decode(), source)


def without_bodies(source: bytes, messages: dict[str, str]) -> bytes:
    """Replace the body of each function in ``messages`` with an error that has this message."""
    bodies = {n: f"raise NotImplementedError({json.dumps(m)})" for n, m in messages.items()}
    return with_bodies(source, bodies)


def messages_of(chapter: Chapter, file: str) -> dict[str, str]:
    """Return the error message of each stub in a file, keyed by names such as Vector3.copy."""
    prefix = file.removesuffix(".py") + "."
    return {
        name.removeprefix(prefix): f"Exercise {exercise.id}: {exercise.title}"
        for exercise in chapter.exercises
        for name in exercise.edit
        if name.startswith(prefix)
    }
