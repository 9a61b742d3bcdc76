"""Recognize submitted files whose names are almost correct, such as "vector (1).py"."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from autograder.accepted_files import renamed_file, similar_name
from autograder.submissions.folders import Found, refuse


def renamed(place: tuple[str, ...], files: Sequence[str], there: Iterable[str]) -> list[Found]:
    """Find submitted files whose names are almost correct, and reject them.

    The reason for a rejection quotes the wrong name, so that the student can correct it. ``place``
    is the path of the chapter's folder in the submission, and ``there`` contains the names of the
    files in it. ``files`` contains the names that the grader expects.
    """
    names = set(there)
    found = []
    for file in files:
        if file not in names and (other := similar_name(file, names - {*files})):
            found.append(Found(place, file, refuse(str(renamed_file(file, other)))))
    return found
