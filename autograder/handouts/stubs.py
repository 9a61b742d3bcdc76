"""Turn our solutions into the stubs in chapters/, the unfinished files that students complete.

The manifest lists the functions that students write. In a stub, each of them keeps its signature
and docstring, but its body becomes ``raise NotImplementedError``. A hash of every stub is stored in
stubs.lock. If the hash no longer matches, somebody has edited the stub, and it is never
overwritten.
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
    """Generate the text of every file that students start from.

    The result maps paths such as chapters/ch02_vectors/vector.py to texts. The files are Python
    stubs, answers.md without the model answers, and data files that contain only the column names.
    """
    stubs = {}
    for chapter in load_chapters(root):
        solution = root / "solutions" / chapter.name
        for name in chapter.edited_files:
            stubs[f"chapters/{chapter.name}/{name}"] = stub_of(chapter, name, root)
        for name in chapter.data_files:  # students get only the first line, with the column names
            lines = (solution / name).read_text(encoding="utf-8").splitlines(keepends=True)
            stubs[f"chapters/{chapter.name}/{name}"] = lines[0]
        answers = solution / "answers.md"
        if answers.exists():
            text = answers.read_text(encoding="utf-8")
            stubs[f"chapters/{chapter.name}/answers.md"] = blank_answers(text)
    return stubs


def stub_of(chapter: Chapter, file: str, root: Path = ROOT) -> str:
    """Generate the stub of one module, such as vector.py, from our solution.

    Raises:
        OSError: The solution cannot be read.
    """
    source = (root / "solutions" / chapter.name / file).read_text(encoding="utf-8")
    return stub_module(source, messages_of(chapter, file))


def pristine_stub(chapter: Chapter, file: str, root: Path = ROOT) -> str | None:
    """Return the original stub of a module, as it was before the student edited it.

    If our solutions are available, the stub is generated from them. A handout does not contain
    them, but keeps a copy of each original stub. If there is no copy either, the result is None.
    """
    if (root / "solutions" / chapter.name / file).is_file():
        return stub_of(chapter, file, root)
    kept = root / KEPT / chapter.name / file
    return kept.read_text(encoding="utf-8") if kept.is_file() else None


def write_stubs(root: Path = ROOT) -> tuple[list[str], list[str]]:
    """Write all stubs and stubs.lock, without overwriting any stub that somebody has edited.

    Return the paths of the stubs that were written, and the paths of the edited ones.
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
    """List the files in chapters/ that are out of date or have been edited.

    These are stubs that no longer match our solutions, and complete modules that no longer match
    stubs.lock.
    """
    stale = [path for path, text in make_stubs(root).items() if _read(root / path) != text]
    locked = read_lock(root)
    return stale + [path for path, key in complete_hashes(root).items() if locked.get(path) != key]


def complete_hashes(root: Path = ROOT) -> dict[str, str]:
    """Compute a hash of each module that students use without changing it, such as cloth.py.

    The keys of the result are paths such as chapters/ch06_springs/cloth.py.
    """
    files = [
        root / "chapters" / chapter.name / name
        for chapter in load_chapters(root)
        for name in chapter.complete
    ]
    return {
        file.relative_to(root).as_posix(): stub_hash(file.read_text(encoding="utf-8"))
        for file in files
    }


def _read(file: Path) -> str | None:
    """Return the text of a stub in chapters/, or None if the file does not exist.

    Any bytes that are not valid UTF-8 are replaced, so such a file later counts as edited.
    """
    return file.read_text(encoding="utf-8", errors="replace") if file.exists() else None


def stub_module(source: str, messages: dict[str, str]) -> str:
    """Turn the source of a solution into a stub by removing the bodies that students write.

    ``messages`` maps the name of each such function, such as ``Vector3.dot``, to the error message
    that its stub raises. Private helpers, constants and imports that only these bodies used would
    give the solution away, so they are removed too.

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
    """Return the error message of each stub, such as "Exercise B2.1: Copy, clear and invert".

    The keys are the names of the functions, such as Vector3.copy.
    """
    prefix = file.removesuffix(".py") + "."
    return {
        name.removeprefix(prefix): f"Exercise {exercise.id}: {exercise.title}"
        for exercise in chapter.exercises
        for name in exercise.edit
        if name.startswith(prefix)
    }
