"""Copy the files to be graded from a student's submission into a new folder.

The grader imports only these copies, and never any other file of the submission.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

from autograder.accepted_files import (
    LARGEST_FILE,
    NotTakenError,
    check_text,
    module_of,
    rejection,
    renamed,
)
from autograder.handouts.stubs import KEPT
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.submissions.find import printable
from autograder.submissions.misplaced import misplaced, names_of_others
from autograder.submissions.search import Found, refuse, refuse_all, search


@dataclass(frozen=True)
class Staged:
    """The result of copying the files to be graded from a student's submission."""

    rejected: dict[str, str]  # modules such as ch02_vectors.vector, each with the reason
    misplaced: list[str]  # those of them whose files were found in the wrong folder
    taken: list[str]  # files such as ch02_vectors/vector.py
    others: list[str]  # names at the top of the submission from which nothing was taken
    notes: list[str]  # for the instructor; they may quote names of files, but nothing else
    digest: str  # of everything accepted or rejected; with the same one, the grade is the same
    refused: str = ""  # why nothing of the submission could be read, such as a damaged zip


def stage(submission: Path, chapters: list[Chapter], box: Path, root: Path = ROOT) -> Staged:
    """Write the student's files, and our copies of the modules that students do not edit, to a box.

    A missing file is not replaced with a stub or our solution, because neither would be the
    student's work.

    Raises:
        OSError: The folder cannot be written, or a file of the repository cannot be read.
    """
    wanted = {chapter.name: chapter.handed_in for chapter in chapters}
    refused = ""
    try:
        found, notes = search(submission, wanted)
    except NotTakenError as error:
        refused = str(error)
        found, notes = refuse_all(wanted, refused), [f"nothing was taken: {refused}"]
    everywhere = load_chapters(root)
    rejected: dict[str, str] = {}
    elsewhere: list[str] = []
    taken: dict[str, Found] = {}
    readable = False
    digest = hashlib.sha256()
    for chapter in chapters:
        target = box / chapter.name
        _make_folder(target)
        for name in chapter.complete:
            if not (target / name).parent.exists():
                _make_folder((target / name).parent)
            _write(target / name, (root / "chapters" / chapter.name / name).read_bytes())
        files, more_notes = _choose(chapter, found)
        notes += more_notes
        readable = readable or not all(file.doubtful for file in files.values())
        for name in chapter.handed_in:
            file, content, reason = files.get(name), b"", ""
            module = module_of(chapter.name, name)
            if file is None or _is_stub(file):
                reason = misplaced(chapter, name, found, everywhere)
                elsewhere += [module] if reason else []
            if file and not reason:
                try:
                    content = check_text(file.read(LARGEST_FILE))
                    _write(target / name, content)
                    taken[f"{chapter.name}/{name}"] = file
                except NotTakenError as error:
                    reason = rejection(chapter.name, name, error)
            if reason:
                rejected[module] = reason
            if file or reason:
                digest.update(f"{chapter.name}/{name}\0{reason}\0{len(content)}\0".encode())
                digest.update(content)
    if rejected and not (readable or elsewhere):
        refused = refused or "; ".join(notes) or next(iter(rejected.values()))
    return Staged(
        rejected,
        elsewhere,
        [*taken],
        names_of_others(found, taken.values()),
        [printable(note) for note in notes],
        digest.hexdigest(),
        printable(refused),
    )


def _choose(chapter: Chapter, found: list[Found]) -> tuple[dict[str, Found], list[str]]:
    """Choose the folder of a chapter in a submission, and return the files in it with notes.

    The least deeply nested one is chosen, and then the first by name, but one in stubs/ last,
    because a handout keeps the original stubs there.
    """
    all_of_it = [file for file in found if file.place[-1:] == (chapter.name,)]
    mine = [file for file in all_of_it if not file.other]
    places = sorted(
        {(file.doubtful, _is_stub(file), len(file.place), file.place) for file in mine or all_of_it}
    )
    if not places:
        return {}, []
    doubtful, _, _, place = places[0]
    notes = []
    if (several := sum(not doubtful and not kept for doubtful, kept, _, _ in places)) > 1:
        path = "/".join(place)
        notes.append(f"there are {several} folders called {chapter.name}: '{path}' was used")
    chosen = [file for file in mine if (file.doubtful, file.place) == (doubtful, place)]
    there = {file.file for file in all_of_it if file.place == place}
    for name in chapter.handed_in:
        if name not in there and (error := renamed(chapter, name, there)):
            chosen.append(Found(place, name, refuse(str(error))))
    return {file.file: file for file in chosen}, notes


def _is_stub(file: Found) -> bool:
    return KEPT in file.place[:-1]


def _make_folder(path: Path) -> None:
    path.mkdir(parents=True)
    path.chmod(0o755)  # another user will run the code, so the umask must not matter


def _write(path: Path, content: bytes) -> None:
    path.write_bytes(content)
    path.chmod(0o644)
