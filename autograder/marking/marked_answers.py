"""Remember which answer each mark was given for, so that no mark outlives a change of its answer.

The record is a hidden file beside marks.csv. Marks that are typed into marks.csv count as given for
the answer that is there when the class is next graded or marked.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

from autograder.reports.marks import Mark
from autograder.reports.texts import replace_file

NAME = ".marked-answers.json"


def hash_of(answer: str) -> str:
    """Return a short hash of a written answer."""
    return hashlib.sha256(answer.encode("utf-8", "surrogatepass")).hexdigest()[:16]


class MarkedAnswers:
    """The record of a class: for each student and exercise, the mark and a hash of the answer.

    A student is called by ``Submission.owner``, which stays the same if the class is graded with
    codes, or if a newer download has other file names.
    """

    def __init__(self, folder: Path) -> None:
        self.path = folder / NAME
        self._marked = self._read()
        self._new: dict[str, Any] = {}  # what this object has recorded

    def is_changed(self, owner: str, exercise: str, mark: Mark, answer: str) -> bool:
        """Return True if this mark was given for another answer. ``answer`` is a hash."""
        key = f"{exercise} {owner}"
        new = [mark.points, mark.comment, answer]
        before = self._marked.get(key)
        if not isinstance(before, list) or before[:2] != new[:2]:
            self._marked[key] = self._new[key] = before = new
        return bool(before[2:] != [answer])

    def marked_now(self, owner: str, exercise: str, mark: Mark, answer: str) -> None:
        """Record that a person gave this mark after reading this answer."""
        key = f"{exercise} {owner}"
        self._marked[key] = self._new[key] = [mark.points, mark.comment, answer]
        self.save()

    def save(self) -> None:
        """Add what is new to the record. Another command may have added to it in the meantime."""
        if self._new:
            self._marked = self._read() | self._new
            replace_file(self.path, json.dumps(self._marked, indent=1, sort_keys=True) + "\n")

    def _read(self) -> dict[str, Any]:
        if not self.path.exists():
            return {}
        try:
            return dict(json.loads(self.path.read_text(encoding="utf-8")))
        except (ValueError, TypeError) as error:
            raise ValueError(
                f"{self.path} is damaged. Delete it; answers that have changed since they were "
                "marked are then not recognized"
            ) from error
