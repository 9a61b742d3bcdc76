"""Recognize submitted files whose names are almost correct, such as "vector (1).py"."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Sequence

from autograder.submissions.folders import Found, refuse

HARMLESS = re.compile(r"[\w .()+-]{1,80}")  # names that can be shown in a report
SIMILAR = 0.8  # least similarity, from 0 to 1; "vector (1).py" and "vector.py" have 0.82


def renamed(place: tuple[str, ...], files: Sequence[str], there: Iterable[str]) -> list[Found]:
    """Find submitted files whose names are almost correct, and reject them.

    The reason for a rejection quotes the wrong name, so that the student can correct it. ``place``
    is the path of the chapter's folder in the submission, and ``there`` contains the names of the
    files in it. ``files`` contains the names that the grader expects.
    """
    names = set(there)
    others = [name for name in sorted(names - {*files}) if HARMLESS.fullmatch(name)]
    found = []
    for file in files:
        if file in names:
            continue
        ending = f".{file.rpartition('.')[2]}"
        alike = [name for name in others if name.endswith(ending)]
        for name in difflib.get_close_matches(file, alike, 1, SIMILAR):
            reason = f"it was handed in as '{name}', so rename it and hand it in again"
            found.append(Found(place, file, refuse(reason)))
    return found
