"""Copy the files to be graded from a student's submission into a new folder.

The grader imports only these copies, and never any other file of the submission. A file in the
wrong folder is named and never taken, because the grader would have to guess where it belongs.
"""

from __future__ import annotations

import hashlib
import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from autograder.accepted_files import (
    HARMLESS,
    LARGEST_FILE,
    NotTakenError,
    check_text,
    module_of,
    refuse_renamed,
    rejection,
)
from autograder.answers import FILE as ANSWERS
from autograder.handouts.stubs import KEPT
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.submissions.find import printable
from autograder.submissions.search import Found, refuse, refuse_all, search

SCENES = "scenes"  # a folder of every handout, which has a links.py of its own


@dataclass(frozen=True)
class Staged:
    """The result of copying the files to be graded from a student's submission."""

    rejected: dict[str, str]  # modules such as ch02_vectors.vector, each with the reason
    misplaced: list[str]  # those of them whose files were found in the wrong folder
    taken: list[str]  # files such as ch02_vectors/vector.py
    notes: list[str]  # for the instructor; they may quote names of files, but nothing else
    digest: str  # of everything accepted or rejected; with the same one, the grade is the same
    refused: str = ""  # why nothing of the submission could be read, such as a damaged zip


def stage(submission: Path, chapters: list[Chapter], box: Path, root: Path = ROOT) -> Staged:
    """Write the student's files, and our copies of the modules that students do not edit, to a box.

    A missing file is not replaced, because a stub or our solution is not the student's work.
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
        target.mkdir(parents=True)
        for name in chapter.complete:
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(root / "chapters" / chapter.name / name, target / name)
        files, more_notes = _choose(chapter, found)
        notes += more_notes
        readable = readable or not all(file.doubtful for file in files.values())
        for name in chapter.handed_in:
            file, content, reason = files.get(name), b"", ""
            module = module_of(chapter.name, name)
            if file is None or _is_stub(file):
                reason = _misplaced(chapter, name, found, everywhere)
                elsewhere += [module] if reason else []
            if file and not reason:
                try:
                    content = check_text(file.read(LARGEST_FILE))
                    (target / name).write_bytes(content)
                    taken[f"{chapter.name}/{name}"] = file
                except NotTakenError as error:
                    reason = rejection(chapter.name, name, error)
            if reason:
                rejected[module] = reason
            if file or reason:
                digest.update(f"{chapter.name}/{name}\0{reason}\0{len(content)}\0".encode())
                digest.update(content)
        for path in (target, *target.rglob("*")):
            # Another user will run the code, so the umask must not matter.
            path.chmod(0o755 if path.is_dir() else 0o644)
    if rejected and not (readable or elsewhere):
        refused = refused or "; ".join(notes) or next(iter(rejected.values()))
    return Staged(
        rejected,
        elsewhere,
        [*taken],
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
    for name in {*chapter.handed_in} - there:
        try:
            refuse_renamed(chapter, name, there)
        except NotTakenError as error:
            chosen.append(Found(place, name, refuse(str(error))))
    return {file.file: file for file in chosen}, notes


def _is_stub(file: Found) -> bool:
    return KEPT in file.place[:-1]


def _misplaced(
    chapter: Chapter, file: str, found: Iterable[Found], chapters: Iterable[Chapter]
) -> str:
    """Say where else a missing file was found, and what to do, or return "" if it was not found.

    A file in the folder of one of the ``chapters`` that has a file of this name is not misplaced.
    """
    homes = [c.name for c in chapters if file in (*c.complete, *c.handed_in, ANSWERS)]
    others = {one.place for one in found if one.other and one.file == file}
    places = [p for p in others if SCENES not in p and not (p and p[-1] in homes)]
    if not places:
        return ""
    place = min(places, key=lambda place: (len(place), place))
    where = "at the top of what was handed in"
    if place:
        is_harmless = all(map(HARMLESS.fullmatch, place))
        where = f"in '{'/'.join(place)}'" if is_harmless else "in another folder"
    which = f"the one for chapter {chapter.number}" if places[1:] else "it"
    return (
        f"{file} was found {where}, and not in a folder {chapter.name}. "
        f"Put {which} into a folder {chapter.name} and hand in again"
    )
