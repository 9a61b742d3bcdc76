"""Grade a class over a Dask cluster: submissions go out as data, and reports come back.

Dask schedules: it hands a submission whose worker has died to another one. A worker grades as the
machine of the instructor would, behind the same walls, or refuses to.
"""

from __future__ import annotations

import pickle
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console

from autograder.grader.assignment import Assignment, OnceForAll
from autograder.grader.grading import grade_submission, report_of_failure
from autograder.grader.run_key import grader_digest, run_key
from autograder.isolation.level import choose_level
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, load_chapters
from autograder.reports.report import RunKey, StudentReport
from autograder.submissions.find import Submission
from autograder.submissions.stage import Staged, stage

if TYPE_CHECKING:
    from distributed import Client

CONNECTED_WITHIN = 10.0  # seconds until the scheduler answers
WORKERS_WITHIN = 60.0  # seconds until the first worker is there
START = "start it in the folder of the same repository: .venv/bin/python -m dask worker ADDRESS"

_GRADER = grader_digest()  # of what is loaded: the files may change under a worker

Tree = dict[str, bytes | None]  # what is in a folder: contents by path, None for a folder


@dataclass(frozen=True)
class Work:
    """What every worker is told: what a class is graded on, and the machine that is asking.

    ``key`` is what must be the same at the worker; ``home`` is where the repository is here.
    Hidden checks are sent along.
    """

    assignment: Assignment
    key: RunKey
    hidden: Tree
    home: Path = ROOT

    @classmethod
    def of(cls, assignment: Assignment) -> Work:
        """Return what the workers are told about an assignment."""
        public = replace(assignment, hidden=None)
        return cls(public, run_key(public), _tree(assignment.hidden))


@contextmanager
def connect(address: str, assignment: Assignment, console: Console) -> Iterator[Client]:
    """Connect to a scheduler whose workers can grade this, and say how many there are.

    Raises ValueError where Dask is not installed, nobody answers, no worker comes, or one of the
    workers would not grade as this machine does.
    """
    try:
        from distributed import Client
    except ImportError as error:
        raise ValueError(
            "--cluster needs Dask, the extra 'cluster', which is not installed: "
            ".venv/bin/python -m pip install -r requirements.lock -r extras.lock"
        ) from error
    try:
        client = Client(address, timeout=CONNECTED_WITHIN, set_as_default=False)
    except (OSError, ValueError) as error:
        raise ValueError(
            "--cluster must be the address of a Dask scheduler, such as tcp://host:8786, "
            f"got {address!r}: {error}"
        ) from error
    with client:
        console.print(f"Waiting for the workers of {address}.", markup=False)
        try:
            client.wait_for_workers(1, timeout=WORKERS_WITHIN)
        except TimeoutError as error:
            raise ValueError(
                f"the cluster {address} had no workers within {WORKERS_WITHIN:g} seconds; {START}"
            ) from error
        outcomes = client.run(*_call(check_worker, Work.of(assignment)), on_error="return")
        for worker, outcome in outcomes.items():
            if isinstance(outcome, Exception):
                raise ValueError(_refusal(f"the worker {worker}", outcome)) from outcome
        threads = sum(client.nthreads().values())
        console.print(f"Workers: {len(outcomes)}. Submissions at a time: {threads}.")
        yield client


def grade_over(
    client: Client, assignment: Assignment, submissions: list[Submission]
) -> Iterator[StudentReport]:
    """Yield the reports on the submissions, each as it is made.

    Raises ValueError where a worker that has come later would not grade as this machine does, and
    OSError where a submission cannot be sent or the scheduler is gone.
    """
    from distributed import KilledWorker, as_completed

    work = Work.of(assignment)
    chapters = load_chapters(assignment.root)
    whose = {}
    for submission in submissions:  # what is read here is data there: nothing need be shared
        with tempfile.TemporaryDirectory(prefix="submission-") as folder:
            staged = stage(submission.path, chapters, Path(folder), assignment.root)
            box = _tree(Path(folder))
        call = _call(grade_there, work, submission.student, staged, box)
        future = client.submit(*call, pure=False)
        whose[future] = submission
    for future in as_completed(list(whose), loop=client.loop):
        submission = whose[future]  # and the future is kept: its __del__ would swallow a Ctrl-C
        try:
            report: StudentReport = future.result()
        except KilledWorker as error:
            died = error.allowed_failures + 1
            reason = f"every worker that graded it died, {died} in all"
            report = report_of_failure(assignment, submission.student, reason)
        except CancelledError as error:
            raise ConnectionError("the scheduler of the cluster is gone") from error
        except Exception as error:  # what grading meets is in the report
            raise ValueError(_refusal("a worker that came later", error)) from error
        yield report


def grade_there(work: Work, student: str, staged: Staged, box: Tree) -> StudentReport:
    """Grade a submission at a worker. Raises ValueError where this machine must not do it."""
    from distributed import get_worker

    check_worker(work)
    # Dask removes its worker's folder whatever that dies of, and so all that is in it.
    tempfile.tempdir = get_worker().local_directory

    def fill(_path: Path, _chapters: Any, folder: Path, _root: Path) -> Staged:
        _write_tree(box, folder)
        return staged

    with tempfile.TemporaryDirectory(prefix="hidden-") as folder:
        _write_tree(work.hidden, Path(folder))
        hidden = Path(folder) if work.hidden else None
        assignment = replace(_at_home(work), hidden=hidden)
        return grade_submission(assignment, Submission(student, Path()), _shared(work), fill)


def check_worker(work: Work) -> None:
    """Raise ValueError where a report of this machine would not be that of the one that asks."""
    wanted = work.assignment.level
    level = _level(unsafe=not wanted.is_wall)
    own = run_key(replace(_at_home(work), level=level))
    if own.grader != _GRADER:
        raise ValueError("the autograder has changed since the worker was started: start it again")
    names = {
        "python": f"Python {own.python} and not {work.key.python}",
        "grader": "another version of autograder/",
        "checks": "another version of tests/, solutions/ or chapters/",
        "level": f"other walls: {level}",
    }
    ours, theirs = vars(own), vars(work.key)
    differences = [words for name, words in names.items() if ours[name] != theirs[name]]
    if differences:
        raise ValueError(f"it has {'; '.join(differences)}")


@cache  # to try the walls takes a moment
def _level(*, unsafe: bool) -> Level:
    return choose_level(Path(), unsafe=unsafe)


_once: dict[str, OnceForAll] = {}


def _shared(work: Work) -> OnceForAll:
    """Return what is worked out once here for all submissions of a run."""
    return _once.setdefault(repr((str(_at_home(work).root), work.key)), OnceForAll())


def _at_home(work: Work) -> Assignment:
    """Return the assignment with the repository of this machine."""
    if work.assignment.root == work.home:
        return replace(work.assignment, root=ROOT)
    return work.assignment


def _refusal(worker: str, error: Exception) -> str:
    if isinstance(error, ValueError):
        return f"{worker} cannot grade for this machine: {error}"
    return f"{worker} cannot load the autograder: {error!r}; {START}"


class _Call:
    """A call that is made where its pickle is loaded."""

    def __init__(self, *parts: Any) -> None:
        self.parts = parts

    def __reduce__(self) -> tuple[Any, ...]:
        function, *arguments = self.parts
        return function, tuple(arguments)


def _call(*parts: Any) -> tuple[Callable[[bytes], Any], bytes]:
    """Return a function and arguments that Dask can pass on without having our modules itself.

    Otherwise its scheduler would need them, and a worker that lacks them would go silent.
    """
    return pickle.loads, pickle.dumps(_Call(*parts))


def _tree(folder: Path | None) -> Tree:
    """Return all that is in a folder; nothing for None."""
    paths = sorted(folder.rglob("*")) if folder else []
    return {
        path.relative_to(folder or path).as_posix(): None if path.is_dir() else path.read_bytes()
        for path in paths
    }


def _write_tree(tree: Tree, folder: Path) -> None:
    """Write a tree into a folder, for every user to read: another one may run what is in it."""
    for name, content in tree.items():
        path = folder / name
        if content is None:
            path.mkdir()
        else:
            path.write_bytes(content)
        path.chmod(0o755 if content is None else 0o644)
