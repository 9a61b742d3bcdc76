"""The results of checking a student's code, from which the screen and the pages are made."""

from __future__ import annotations

from dataclasses import dataclass

from autograder.manifest import Chapter
from autograder.scores import Result


@dataclass(frozen=True)
class Report:
    """The results of checking a student's code for one chapter.

    Attributes:
        results: The results with the student's own code in the earlier chapters.
        on_reference: The results with our solutions in the earlier chapters. The list is empty if
            the checks did not run with our solutions.
        suspects: The earlier chapters whose mistakes may have caused failures.
    """

    chapter: Chapter
    results: list[Result]
    on_reference: list[Result]
    suspects: list[Chapter]
