"""Grade a class on a Dask cluster, whose machines receive submissions and return reports.

Dask distributes the submissions among its workers. If a worker dies, its submission goes to another
worker. A grade must not depend on the machine that computed it. A worker therefore refuses to grade
unless it has the same kind of sandbox as the instructor's machine.
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
from autograder.isolation.probe import choose_level
from autograder.isolation.sandbox import Level
from autograder.make_venv import shown_python
from autograder.manifest import ROOT, load_chapters
from autograder.reports.report import RunKey, StudentReport
from autograder.submissions.find import Submission
from autograder.submissions.stage import Staged, stage

if TYPE_CHECKING:
    from distributed import Client

CONNECTED_WITHIN = 10.0  # seconds in which the scheduler must answer
WORKERS_WITHIN = 60.0  # seconds in which the first worker must appear
START = "start it in a folder with this repository: .venv/bin/python -m dask worker ADDRESS"

_GRADER = grader_digest()  # computed now, because the files of the loaded code may change later

Tree = dict[str, bytes | None]  # the files in a folder by path, where None stands for a subfolder


@dataclass(frozen=True)
class Work:
    """Everything that a worker of a cluster needs in order to grade an assignment.

    Attributes:
        key: The conditions of grading on the instructor's machine, such as the versions of Python
            and the checks. A worker refuses to grade if its own conditions differ.
        hidden: The contents of the hidden checks.
        home: The path of the repository on the instructor's machine.
    """

    assignment: Assignment
    key: RunKey
    hidden: Tree
    home: Path = ROOT

    @classmethod
    def of(cls, assignment: Assignment) -> Work:
        """Collect everything that a worker of the cluster needs in order to grade an assignment.

        The hidden checks are read into memory, because the workers may have no access to their
        folder.
        """
        public = replace(assignment, hidden=None)
        return cls(public, run_key(public), _tree(assignment.hidden))


@contextmanager
def connect(address: str, assignment: Assignment, console: Console) -> Iterator[Client]:
    """Connect to the scheduler of a Dask cluster, and print how many workers can grade.

    Raises:
        ValueError: Dask is not installed, the scheduler does not answer, there are no workers, or a
            worker would not grade exactly as this machine does.
    """
    try:
        from distributed import Client
    except ImportError as error:
        raise ValueError(
            "--cluster needs Dask, which is not installed. Run "
            f"{shown_python()} autograder/make_venv.py everything"
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
                f"the cluster {address} had no worker within {WORKERS_WITHIN:g} seconds; {START}"
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
    """Grade the submissions of a class on the cluster, and yield each report when it arrives.

    The files of a submission are sent as data, so the machines need no shared disk.

    Raises:
        ValueError: A worker that joined later would not grade exactly as this machine does.
        OSError: A submission cannot be sent, or the scheduler does not answer.
    """
    from distributed import KilledWorker, as_completed

    work = Work.of(assignment)
    chapters = load_chapters(assignment.root)
    whose = {}
    for submission in submissions:  # sent as data, so that no files are shared
        if submission.nothing:
            yield grade_submission(assignment, submission)
            continue
        with tempfile.TemporaryDirectory(prefix="submission-") as folder:
            staged = stage(submission.path, chapters, Path(folder), assignment.root)
            box = _tree(Path(folder))
        call = _call(grade_there, work, submission, staged, box)
        future = client.submit(*call, pure=False)
        whose[future] = submission
    for future in as_completed(list(whose), loop=client.loop):
        submission = whose[future]  # keeps the future alive, since its __del__ could swallow Ctrl-C
        try:
            report: StudentReport = future.result()
        except KilledWorker as error:
            died = error.allowed_failures + 1
            reason = f"every worker that tried to grade it died; workers lost: {died}"
            report = report_of_failure(assignment, submission.student, reason)
        except CancelledError as error:
            raise ConnectionError("the scheduler of the cluster is gone") from error
        except Exception as error:  # errors of grading are in the report
            raise ValueError(_refusal("a worker that joined later", error)) from error
        yield report


def grade_there(work: Work, submission: Submission, staged: Staged, box: Tree) -> StudentReport:
    """Grade one student's submission on a worker of the cluster.

    Dask calls this function on the worker.

    Raises:
        ValueError: The worker would not grade exactly as the instructor's machine does.
    """
    from distributed import get_worker

    check_worker(work)
    # Dask removes the folder of a worker, with all its files, however the worker dies.
    tempfile.tempdir = get_worker().local_directory

    def fill(_path: Path, _chapters: Any, folder: Path, _root: Path) -> Staged:
        _write_tree(box, folder)
        return staged

    with tempfile.TemporaryDirectory(prefix="hidden-") as folder:
        _write_tree(work.hidden, Path(folder))
        hidden = Path(folder) if work.hidden else None
        assignment = replace(_at_home(work), hidden=hidden)
        return grade_submission(assignment, submission, _shared(work), fill)


def check_worker(work: Work) -> None:
    """Raise ValueError if this worker would not grade exactly as the instructor's machine does.

    Otherwise a student's grade could depend on the machine that happened to compute it. The worker
    must have the same versions of Python, the grader and the checks, and the same kind of sandbox.
    """
    wanted = work.assignment.level
    level = _level(unsafe=not wanted.is_sandbox)
    own = run_key(replace(_at_home(work), level=level))
    if own.grader != _GRADER:
        raise ValueError("the autograder has changed since the worker was started: restart it")
    names = {
        "python": f"Python {own.python} instead of {work.key.python}",
        "grader": "another version of autograder/",
        "checks": "another version of tests/, solutions/ or chapters/",
        "level": f"another sandbox: {level}",
    }
    ours, theirs = vars(own), vars(work.key)
    differences = [words for name, words in names.items() if ours[name] != theirs[name]]
    if differences:
        raise ValueError(f"it has {'; '.join(differences)}")


@cache  # because testing the sandbox takes a moment
def _level(*, unsafe: bool) -> Level:
    return choose_level(Path(), unsafe=unsafe)


_once: dict[str, OnceForAll] = {}


def _shared(work: Work) -> OnceForAll:
    """Return this worker's cache of check results that are the same for all students.

    There is one cache for each assignment.
    """
    return _once.setdefault(repr((str(_at_home(work).root), work.key)), OnceForAll())


def _at_home(work: Work) -> Assignment:
    """Return the assignment, adapted to the location of the repository on this machine.

    Each machine of a cluster may have the repository in a different folder.
    """
    if work.assignment.root == work.home:
        return replace(work.assignment, root=ROOT)
    return work.assignment


def _refusal(worker: str, error: Exception) -> str:
    if isinstance(error, ValueError):
        return f"{worker} cannot grade for this machine: {error}"
    return f"{worker} cannot load the autograder: {error!r}; {START}"


class _Call:
    """An object that calls a function when a worker of the cluster unpickles it."""

    def __init__(self, *parts: Any) -> None:
        self.parts = parts

    def __reduce__(self) -> tuple[Any, ...]:
        function, *arguments = self.parts
        return function, tuple(arguments)


def _call(*parts: Any) -> tuple[Callable[[bytes], Any], bytes]:
    """Pack a function call so that Dask can send it to a worker without importing the autograder.

    If Dask had to import the autograder, the scheduler would need it as well. A worker without the
    autograder would then stop responding instead of reporting an error.
    """
    return pickle.loads, pickle.dumps(_Call(*parts))


def _tree(folder: Path | None) -> Tree:
    """Read all the files in a folder into a dict that can be sent to a worker of the cluster.

    The keys are paths relative to the folder, such as "ch02_vectors/vector.py". If ``folder`` is
    None, the dict is empty.
    """
    paths = sorted(folder.rglob("*")) if folder else []
    return {
        path.relative_to(folder or path).as_posix(): None if path.is_dir() else path.read_bytes()
        for path in paths
    }


def _write_tree(tree: Tree, folder: Path) -> None:
    """Write the files received from the instructor's machine to a folder on this worker.

    The files are readable by all users, because the student's code may run under another account.
    """
    for name, content in tree.items():
        path = folder / name
        if content is None:
            path.mkdir()
        else:
            path.write_bytes(content)
        path.chmod(0o755 if content is None else 0o644)
