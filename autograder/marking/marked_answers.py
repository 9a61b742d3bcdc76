"""Remember which answer each mark was given for, so that no mark outlives a change of its answer.

The record is a hidden file beside marks.csv. Marks that are typed into marks.csv count as given for
the answer that is there when the class is next graded or marked.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from autograder.file_lock import locked
from autograder.reports.marks import Mark
from autograder.reports.texts import replace_file

NAME = ".marked-answers.json"


class MarkedAnswers:
    """The record of a class, by ``Submission.owner``, which stays the same in a newer download."""

    def __init__(self, folder: Path) -> None:
        self.path = folder / NAME
        self._kept = self._read()
        self._new: dict[str, list[Any]] = {}

    def is_changed(self, owner: str, exercise: str, mark: Mark, answer: str) -> bool:
        """Return True if this mark was given for another answer than that with this hash."""
        key, now = f"{exercise} {owner}", [mark.points, mark.comment, answer]
        before = self._new.get(key) or self._kept.get(key)
        if before is None or before[:2] != now[:2]:
            self._new[key] = before = now
        return before != now

    def mark_now(self, owner: str, exercise: str, mark: Mark, answer: str) -> None:
        """Record that a person gave this mark after reading this answer."""
        self._new[f"{exercise} {owner}"] = [mark.points, mark.comment, answer]
        self.save()

    def save(self) -> None:
        """Write what is new, and keep what make grade or make mark has written in the meantime."""
        if self._new:
            with locked(self.path.with_name(f"{NAME}.lock")):
                self._kept = self._read() | self._new
                text = json.dumps(self._kept, indent=1, sort_keys=True, ensure_ascii=False)
                replace_file(self.path, text + "\n")
            self._new = {}

    def _read(self) -> dict[str, list[Any]]:
        try:
            return dict(json.loads(self.path.read_text(encoding="utf-8")))
        except FileNotFoundError:
            return {}
        except (ValueError, TypeError) as error:
            raise ValueError(
                f"{self.path} is damaged. Delete it; answers that have changed since they were "
                "marked are then not recognized"
            ) from error
