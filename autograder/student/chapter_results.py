"""The results of checking a student's code, from which the screen and the pages are made."""

from __future__ import annotations

from dataclasses import dataclass

from autograder.manifest import Chapter
from autograder.scores import Result


@dataclass(frozen=True)
class ChapterResults:
    """The results of checking a student's code for one chapter.

    ``on_reference`` are the results with our solutions in the earlier chapters, if the checks ran
    with them. ``suspects`` are earlier chapters whose mistakes may have caused failures.
    """

    chapter: Chapter
    results: list[Result]
    on_reference: list[Result]
    suspects: list[Chapter]
