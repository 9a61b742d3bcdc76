"""Copy the files to be graded from a student's submission into a new folder.

The grader imports only these copies, and never any other file of the submission.
"""

from __future__ import annotations

import hashlib
import itertools
import stat
from dataclasses import dataclass
from pathlib import Path

from autograder.accepted_files import (
    LARGEST_FILE,
    NotTakenError,
    cause,
    check_text,
    module_of,
    rejection,
    renamed,
)
from autograder.handouts.stubs import KEPT
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.submissions.find import printable
from autograder.submissions.folders import Found, refuse, refuse_all, search_folder
from autograder.submissions.misplaced import misplaced, names_of_others
from autograder.submissions.zips import search_zip, search_zips_in


@dataclass(frozen=True)
class Staged:
    """The result of copying the files to be graded from a student's submission.

    Attributes:
        missing: The rejected modules, such as ch02_vectors.vector, each with the reason.
        misplaced: Those of them whose files were found in the wrong folder.
        taken: The files that were copied, such as ch02_vectors/vector.py.
        others: The names of some files and folders at the top of the submission from which nothing
            was taken, such as report.pdf.
        notes: Notes for the instructor. They may quote the names of files and folders, but nothing
            else that the student wrote.
        refused: Why nothing of the submission could be read, such as a damaged zip, or "".
        digest: A hash of everything that was accepted or rejected. Submissions with the same digest
            get the same grade.
    """

    missing: dict[str, str]
    misplaced: list[str]
    taken: list[str]
    others: list[str]
    notes: list[str]
    digest: str
    refused: str = ""


def stage(submission: Path, chapters: list[Chapter], box: Path, root: Path = ROOT) -> Staged:
    """Assemble the engine to be graded, and write it to the folder ``box``.

    The engine consists of the student's files and of our copies of the modules that students do not
    edit. A missing file is not replaced with a stub or our solution, because neither would be the
    student's work. The submission is a folder or a zip file, and its contents are not trusted. The
    result lists any problems.

    Raises:
        OSError: The folder cannot be written, or a file of the repository cannot be read.
    """
    found, notes, refused = _search(submission, chapters)
    everywhere = load_chapters(root)
    missing: dict[str, str] = {}
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
                missing[module] = reason
            if file or reason:
                sizes = f"{chapter.name}/{name}\0{reason}\0{len(content)}\0"
                digest.update(sizes.encode() + content)
    if missing and not (readable or elsewhere):
        refused = refused or "; ".join(notes) or next(iter(missing.values()))
    return Staged(
        missing,
        elsewhere,
        [*taken],
        names_of_others(found, taken.values()),
        [printable(note) for note in notes],
        digest.hexdigest(),
        printable(refused),
    )


def _search(submission: Path, chapters: list[Chapter]) -> tuple[list[Found], list[str], str]:
    """Find the files of all chapters in a student's submission, with notes on any problems.

    The last result is the reason if nothing at all was read, or "". The submission may be a
    folder, a zip file, or a folder with zips in it.
    """
    wanted = {chapter.name: chapter.handed_in for chapter in chapters}
    try:
        mode = submission.lstat().st_mode
        if stat.S_ISLNK(mode):
            raise NotTakenError("the submission is a symbolic link")
        if not stat.S_ISDIR(mode):
            return *search_zip(submission, wanted), ""
        found, notes = search_folder(submission, wanted)
        inside, more = search_zips_in(submission, wanted)
        return found + inside, notes + more, ""
    except OSError as error:
        refused = NotTakenError(f"the submission cannot be read: {cause(error)}")
    except NotTakenError as error:
        refused = error
    everything = [refuse_all((name,), files, str(refused)) for name, files in wanted.items()]
    return list(itertools.chain(*everything)), [f"nothing was taken: {refused}"], str(refused)


def _choose(chapter: Chapter, found: list[Found]) -> tuple[dict[str, Found], list[str]]:
    """Choose one folder for a chapter in a submission, and return the files in it with notes.

    If there are several folders, the least deeply nested one is chosen. Ties are broken by name. A
    folder inside stubs/ is the last choice, because a handout keeps the original stubs there. A
    note tells the instructor which of several folders was chosen. A file that the student has
    renamed is rejected, and the reason gives its new name.
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
    """Return True if a file is one of the original stubs that every handout keeps in stubs/."""
    return KEPT in file.place[:-1]


def _make_folder(path: Path) -> None:
    path.mkdir(parents=True)
    path.chmod(0o755)  # another user will run the code, so the umask must not matter


def _write(path: Path, content: bytes) -> None:
    path.write_bytes(content)
    path.chmod(0o644)
