"""Turn our solutions into the stubs in chapters/, the unfinished files that students complete.

In a stub, each function that students write keeps its signature and docstring, but its body becomes
``raise NotImplementedError``. If a stub no longer has its hash in stubs.lock, somebody has edited
it, and it is never overwritten.
"""

from __future__ import annotations

import ast
import codecs
import hashlib
import json
from collections.abc import Mapping
from itertools import accumulate
from pathlib import Path

from autograder.answers import blank_answers
from autograder.definitions import functions
from autograder.files import replace_bytes
from autograder.handouts.unused import without_unused
from autograder.manifest import ROOT, Chapter, load_chapters

KEPT = "stubs"  # the folder of a handout with the original stubs
LOCK_NAME = "autograder/handouts/stubs.lock"


def stub_hash(text: str) -> str:
    """Compute the SHA-256 hash of a stub's text, as it is stored in stubs.lock."""
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def read_lock(root: Path = ROOT) -> dict[str, str]:
    """Return the hashes in stubs.lock, if there is one, keyed by the paths of the files."""
    hashes: dict[str, str] = json.loads(_read(root / LOCK_NAME) or "{}")
    return hashes


def make_stubs(root: Path = ROOT) -> dict[str, str]:
    """Generate all files that students start from: stubs, blank answers and empty tables."""
    stubs = {}
    for chapter in load_chapters(root):
        solution, folder = root / "solutions" / chapter.name, f"chapters/{chapter.name}"
        for name in chapter.edited_files:
            stubs[f"{folder}/{name}"] = stub_of(chapter, name, root)
        for name in chapter.data_files:
            text = (solution / name).read_text(encoding="utf-8")
            stubs[f"{folder}/{name}"] = text.partition("\n")[0] + "\n"
        if answers := _read(solution / "answers.md"):
            stubs[f"{folder}/answers.md"] = blank_answers(answers)
    return stubs


def stub_of(chapter: Chapter, file: str, root: Path = ROOT) -> str:
    """Generate the stub of one module, such as vector.py, from our solution."""
    source = (root / "solutions" / chapter.name / file).read_text(encoding="utf-8")
    return stub_module(source, messages_of(chapter, file))


def pristine_stub(chapter: Chapter, file: str, root: Path = ROOT) -> str | None:
    """Return the original stub of a module from our solution or from a handout, or else None."""
    if (root / "solutions" / chapter.name / file).is_file():
        return stub_of(chapter, file, root)
    return _read(root / KEPT / chapter.name / file)


def write_stubs(root: Path = ROOT) -> tuple[list[str], list[str]]:
    """Write all stubs and stubs.lock. Return the paths written, and those edited and left alone."""
    locked = read_lock(root)
    written, left_alone = [], []
    hashes = complete_hashes(root)
    for path, text in make_stubs(root).items():
        current = _read(root / path)
        if current not in (text, None) and stub_hash(current or "") != locked.get(path):
            left_alone.append(path)
            hashes |= {path: locked[path]} if path in locked else {}
            continue
        hashes[path] = stub_hash(text)
        if current != text:
            replace_bytes(root / path, text.encode())
            written.append(path)
    replace_bytes(root / LOCK_NAME, (json.dumps(hashes, indent=1, sort_keys=True) + "\n").encode())
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
    """Turn a solution into a stub, in which each function of ``messages`` raises its message."""
    if missing := messages.keys() - functions(ast.parse(source)).keys():
        raise ValueError(f"the solution does not define {', '.join(sorted(missing))}")
    return without_unused(without_bodies(source.encode(), messages).decode(), source)


def without_bodies(source: bytes, messages: dict[str, str]) -> bytes:
    """Replace the body of each function in ``messages`` with an error that has this message."""
    bodies = {n: f"raise NotImplementedError({json.dumps(m)})" for n, m in messages.items()}
    return with_bodies(source, bodies)


def with_bodies(source: bytes, bodies: Mapping[str, str]) -> bytes:
    """Replace the bodies of some functions, keyed by names such as Vector3.dot, by other source.

    All else stays byte for byte. The source may have a BOM or the line ends of Windows.
    """
    newline = b"\r\n" if source.partition(b"\n")[0].endswith(b"\r") else b"\n"
    bom = codecs.BOM_UTF8 if source.startswith(codecs.BOM_UTF8) else b""
    text = source.removeprefix(bom)  # positions in the syntax tree do not count it
    lines = text.splitlines(keepends=True)
    starts = [0, *accumulate(map(len, lines))]
    for name, node in reversed(functions(ast.parse(source)).items()):
        if name not in bodies:
            continue
        first, last = node.body[0], node.end_lineno or 0
        before = lines[first.lineno - 1][: first.col_offset]
        begin = starts[first.lineno - 1] + first.col_offset
        end = starts[last - 1] + len(lines[last - 1].rstrip(b"\r\n"))
        indent = b" " * (node.col_offset + 4) if before.strip() else before
        body = bodies[name].strip().encode().splitlines()
        if ast.get_docstring(node, clean=False) is not None:
            ends = starts[(first.end_lineno or 0) - 1] + (first.end_col_offset or 0)
            body.insert(0, text[begin:ends])
        text = text[:begin].rstrip() + b"".join(newline + indent + b for b in body) + text[end:]
    return bom + text


def messages_of(chapter: Chapter, file: str) -> dict[str, str]:
    """Return the error message of each stub in a file, keyed by names such as Vector3.copy."""
    prefix = file.removesuffix(".py") + "."
    return {
        name.removeprefix(prefix): f"Exercise {exercise.id}: {exercise.title}"
        for exercise in chapter.exercises
        for name in exercise.edit
        if name.startswith(prefix)
    }
