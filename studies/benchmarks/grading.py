"""What it costs to grade untrusted code in workers, next to running it beside the checks."""

from __future__ import annotations

import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from rich.console import Console

from autograder.arrange import Behind
from autograder.isolation.template import best_level
from autograder.manifest import ROOT, Chapter, load_chapters
from autograder.runner import run_checks
from autograder.submissions.find import find_submissions
from autograder.submissions.stage import stage
from studies.timing import Line, ratio

ENGINE = [ROOT / "solutions", ROOT / "chapters"]
AT_A_TIME = 2


def lines(console: Console) -> list[Line]:
    """Measure a check, a class of twenty, and the sample class."""
    behind = Behind(vars(best_level()))
    _, second, *_, last = load_chapters()
    # The target was set with chapter 3; later chapters import more modules and ask more.
    checks = [_one_check(second, behind, "at most 8"), _one_check(last, behind, "")]
    return [*checks, _twenty(behind, console), _sample_class(behind, console)]


def _one_check(chapter: Chapter, behind: Behind, target: str) -> Line:
    """Milliseconds that a check takes longer in a worker, its share of the start included."""
    count = len(run_checks(chapter, ENGINE, seed="1"))
    run_checks(chapter, ENGINE, seed="1", behind=behind)
    extra = []

    def seconds(where: Behind | None) -> float:
        start = time.perf_counter()
        run_checks(chapter, ENGINE, seed="1", behind=where)
        return time.perf_counter() - start

    for _ in range(9):
        extra.append((seconds(behind) - seconds(None)) / count * 1000)
    extra.sort()
    what = f"a check of chapter {chapter.number} in a worker - beside the checks, in milliseconds"
    return Line(what, extra[4], extra[2], extra[6], target)


def _twenty(behind: Behind, console: Console) -> Line:
    chapter = load_chapters()[0]

    def grade(fresh: bool) -> float:
        where = Behind(behind.level, fresh=fresh)
        start = time.perf_counter()
        with ThreadPoolExecutor(AT_A_TIME) as pool:
            run = partial(run_checks, chapter, ENGINE, behind=where, run_limit=600.0)
            for _ in pool.map(lambda seed: run(seed=str(seed)), range(20)):
                pass  # a fault of one would be raised here
        return time.perf_counter() - start

    console.print("twenty submissions, with a fresh interpreter a check: about two minutes")
    measured = ratio(lambda: grade(True), lambda: grade(False), 1, "twenty submissions")
    return Line("20 submissions, a fresh interpreter a check / forked", *measured, "at least 2")


def _sample_class(behind: Behind, console: Console) -> Line:
    submissions, _ = find_submissions(ROOT / "sample_class")
    chapters = load_chapters()

    def grade(where: Behind | None) -> float:
        start = time.perf_counter()
        with ThreadPoolExecutor(AT_A_TIME) as pool:
            for _ in pool.map(lambda one: grade_one(one.path, where), submissions):
                pass
        return time.perf_counter() - start

    def grade_one(path: Path, where: Behind | None) -> None:
        with tempfile.TemporaryDirectory() as box:
            stage(path, chapters, Path(box))
            for chapter in chapters:
                run_checks(chapter, [Path(box)], seed="1", behind=where)

    console.print("the sample class, whose endless loops are waited for: about a minute")
    measured = ratio(lambda: grade(behind), lambda: grade(None), 2, "sample class")
    return Line("the sample class in workers / beside the checks", *measured, "")
