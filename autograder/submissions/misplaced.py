"""Explain what else a student handed in: files in the wrong folder, and files of other kinds.

Such files are never read or graded, because the grader would have to guess where they belong. A
file exercises.py at the top of a zip, for example, could be the one of any chapter.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from autograder.accepted_files import HARMLESS
from autograder.answers import FILE as ANSWERS
from autograder.manifest import Chapter
from autograder.submissions.find import printable
from autograder.submissions.search import Found, is_skipped

SCENES = "scenes"  # a folder of every handout, which has a links.py of its own
MOST_PLACES = 3  # how many folders a message lists, if files of one name are in several
MOST_NAMES = 10  # how many of the other files are listed


def misplaced(
    chapter: Chapter, file: str, found: Iterable[Found], chapters: Iterable[Chapter]
) -> str:
    """Say where else a missing file was found, and what to do, or return "" if it was not found.

    A file in the folder of one of the ``chapters`` that has a file of this name is not misplaced.
    """
    at_home = {
        other.name for other in chapters if file in (*other.complete, *other.handed_in, ANSWERS)
    }
    places = sorted(
        {
            (len(one.place), one.place)
            for one in found
            if one.other and one.file == file
            if SCENES not in one.place and not at_home.intersection(one.place[-1:])
        }
    )
    if not places:
        return ""
    where = [_shown(place) for _, place in places[:MOST_PLACES]]
    if places[MOST_PLACES:]:
        where.append("elsewhere")
    which = f"the one for chapter {chapter.number}" if places[1:] else "it"
    return (
        f"{file} was found {' and '.join(where)}, and not in a folder {chapter.name}. "
        f"Put {which} into a folder {chapter.name} and hand in again"
    )


def names_of_others(found: Sequence[Found], taken: Iterable[Found]) -> list[str]:
    """List some files and folders at the top of a submission from which nothing was taken.

    The names of folders end with a slash. Of a zip in the submission, the contents are listed.
    """
    zips = {one.place[0] for one in found if one.other and one.place}
    zips &= {one.file for one in found if one.other and not one.place}
    used = {_top(one, zips) for one in taken}
    others = (_top(one, zips) for one in found if one.other and (one.place or one.file not in zips))
    names = {name for name in others if name not in used and not is_skipped(name)}
    return [printable(name) for name in sorted(names)[:MOST_NAMES]]


def _shown(place: tuple[str, ...]) -> str:
    if not place:
        return "at the top of what was handed in"
    harmless = all(HARMLESS.fullmatch(name) for name in place)
    return f"in '{'/'.join(place)}'" if harmless else "in another folder"


def _top(file: Found, zips: set[str]) -> str:
    """Return the first part of a file's path, or the first two if the first is a zip."""
    parts = (*file.place, file.file)
    shown = parts[: 2 if parts[0] in zips else 1]
    return "/".join(shown) + ("/" if len(shown) < len(parts) else "")
