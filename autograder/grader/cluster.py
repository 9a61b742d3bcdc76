"""Grade a class on a Dask cluster, whose machines receive submissions and return reports.

If a worker dies, Dask gives its submission to another one. A grade must not depend on the machine,
so a worker refuses to grade unless it has the same versions and the same sandbox.
"""

from __future__ import annotations

import pickle
import tempfile
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console

from autograder.grader.conditions import Conditions, grader_digest, run_key
from autograder.grader.grading import (
    grade_staged,
    grade_submission,
    report_of_failure,
    staged_files,
)
from autograder.isolation.probe import choose_level
from autograder.isolation.sandbox import Level
from autograder.make_venv import shown_python
from autograder.manifest import ROOT
from autograder.reports.report import RunKey, StudentReport
from autograder.submissions.find import Submission
from autograder.submissions.stage import Staged

if TYPE_CHECKING:
    from distributed import Client

CONNECTED_WITHIN = 10.0  # seconds in which the scheduler must answer
WORKERS_WITHIN = 60.0  # seconds in which the first worker must appear
START = "start it in a folder with this repository: .venv/bin/python -m dask worker ADDRESS"

_GRADER = grader_digest()  # computed now, because the files of the loaded code may change later

Tree = dict[str, bytes | None]  # the files in a folder by path, where None stands for a subfolder


@dataclass(frozen=True)
class Job:
    """What a worker needs in order to grade for the instructor's machine."""

    conditions: Conditions
    key: RunKey  # a worker with another one refuses to grade
    hidden: Tree  # the hidden checks, because a worker may have no access to their folder
    home: Path = ROOT  # on the instructor's machine

    @classmethod
    def of(cls, conditions: Conditions) -> Job:
        public = replace(conditions, hidden=None)
        return cls(public, run_key(public), _tree(conditions.hidden))

    @property
    def here(self) -> Conditions:
        """The conditions, with the folder of the repository on this machine."""
        is_usual = self.conditions.root == self.home
        return replace(self.conditions, root=ROOT) if is_usual else self.conditions


@contextmanager
def connect(address: str, console: Console) -> Iterator[Client]:
    """Connect to the scheduler of a Dask cluster, and print how many workers it has."""
    try:
        from distributed import Client
    except ImportError as error:
        raise ValueError(
            "--cluster needs Dask, which is not installed. Run "
            f"{shown_python()} autograder/make_venv.py everything"
        ) from error
    with Client(address, timeout=CONNECTED_WITHIN, set_as_default=False) as client:
        console.print(f"Waiting for the workers of {address}.", markup=False)
        client.wait_for_workers(1, timeout=WORKERS_WITHIN)
        threads = client.nthreads()
        console.print(f"Workers: {len(threads)}. Submissions at a time: {sum(threads.values())}.")
        yield client


def grade_over(
    client: Client, conditions: Conditions, submissions: list[Submission]
) -> Generator[StudentReport]:
    """Grade submissions on the cluster, and yield each report when it arrives."""
    from distributed import KilledWorker, as_completed

    job = Job.of(conditions)
    whose = {}
    for submission in submissions:
        if submission.nothing:
            yield grade_submission(conditions, submission)
            continue
        with staged_files(conditions, submission) as (staged, box):
            call = _call(grade_there, job, submission, staged, _tree(box))
        whose[client.submit(*call, pure=False)] = submission
    for future in as_completed(list(whose), loop=client.loop):
        submission = whose[future]  # keeps the future alive, since its __del__ could swallow Ctrl-C
        try:
            report: StudentReport = future.result()
        except KilledWorker as error:
            died = error.allowed_failures + 1
            reason = f"every worker that tried to grade it died; workers lost: {died}"
            report = report_of_failure(conditions, submission.student, reason)
        except CancelledError as error:
            raise ConnectionError("the scheduler of the cluster is gone") from error
        except Exception as error:  # errors of grading are in the report
            raise ValueError(f"a worker cannot grade: {error or repr(error)}; {START}") from error
        yield report


_found: dict[str, Any] = {}  # on a worker, what is the same for all students, by assignment


def grade_there(job: Job, submission: Submission, staged: Staged, tree: Tree) -> StudentReport:
    """Grade one student's submission. Dask calls this function on a worker."""
    from distributed import get_worker

    check_worker(job)
    found = _found.setdefault(repr((str(job.here.root), job.key)), {})
    # Dask removes the folder of a worker, with all its files, however the worker dies.
    tempfile.tempdir = get_worker().local_directory
    try:
        with (
            tempfile.TemporaryDirectory(prefix="hidden-") as hidden,
            tempfile.TemporaryDirectory(prefix="submission-") as box,
        ):
            _write_tree(job.hidden, Path(hidden))
            _write_tree(tree, Path(box))
            own = Path(hidden) if job.hidden else None
            conditions = replace(job.here, hidden=own, found=found)
            return grade_staged(conditions, submission, staged, Path(box))
    except Exception as error:  # of the grader
        return report_of_failure(job.conditions, submission.student, repr(error))


def check_worker(job: Job) -> None:
    """Raise ValueError if this worker would not grade exactly as the instructor's machine does."""
    level = _level(unsafe=not job.conditions.level.is_sandbox)
    own = run_key(replace(job.here, level=level))
    if own.grader != _GRADER:
        raise ValueError("the autograder has changed since the worker was started: restart it")
    parts = ("python", "grader", "checks", "level")
    if other := [name for name in parts if getattr(own, name) != getattr(job.key, name)]:
        raise ValueError(f"it has another version of: {', '.join(other)}")


@cache  # because testing the sandbox takes a moment
def _level(*, unsafe: bool) -> Level:
    return choose_level(Path(), unsafe=unsafe)


class _Call:
    """An object that calls a function when a worker of the cluster unpickles it."""

    def __init__(self, *parts: Any) -> None:
        self.parts = parts

    def __reduce__(self) -> tuple[Any, ...]:
        function, *arguments = self.parts
        return function, tuple(arguments)


def _call(*parts: Any) -> tuple[Callable[[bytes], Any], bytes]:
    """Pack a function call so that only the worker imports the autograder to unpack it.

    The scheduler may lack it. A worker without it reports an error, instead of not responding.
    """
    return pickle.loads, pickle.dumps(_Call(*parts))


def _tree(folder: Path | None) -> Tree:
    """Read all files in a folder, by their paths relative to it."""
    return {
        path.relative_to(folder).as_posix(): None if path.is_dir() else path.read_bytes()
        for path in (sorted(folder.rglob("*")) if folder else ())
        if folder
    }


def _write_tree(tree: Tree, folder: Path) -> None:
    """Write received files, readable by all, because students' code may run under another user."""
    for name, content in tree.items():
        path = folder / name
        if content is None:
            path.mkdir()
        else:
            path.write_bytes(content)
        path.chmod(0o755 if content is None else 0o644)
