"""A class over a Dask cluster: what comes back, also when a worker dies or is another version."""

from __future__ import annotations

import os
import platform
import re
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from autograder.grader import cluster as over_cluster
from autograder.grader.conditions import Conditions
from autograder.isolation import probe
from autograder.isolation.sandbox import Level
from autograder.manifest import ROOT, load_chapters
from autograder.submissions.class_list import read_class
from graded import message_of
from small import RIGHT, hand_in
from small_class import HALF, grade, interrupt, results

distributed = pytest.importorskip("distributed")

WALL = Level(landlock=True, seccomp=True)
PATIENCE = 60.0  # seconds, and much for a busy machine
HIDDEN = '''
import pytest
from ch90_small import small
from ch90_small.hidden_probes import FACTOR


@pytest.mark.exercise("90.1")
def test_large():
    """Quadruple must hold for large numbers."""
    assert small.quadruple(1234) == FACTOR * 1234
'''


def start_cluster(workers: int) -> Any:
    return distributed.LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        processes=True,
        host="127.0.0.1",
        scheduler_port=0,
        dashboard_address="127.0.0.1:0",  # None would take port 8787 for its web server
    )


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    with start_cluster(2) as started:
        yield started


@pytest.fixture(scope="module")
def without_workers() -> Iterator[Any]:
    with start_cluster(0) as started:
        yield started


@pytest.fixture
def submissions(tmp_path: Path) -> Path:
    """A class: one half right, a zip, a file that is no text, and nothing at all."""
    folder = tmp_path / "class"
    hand_in(folder, "bob", HALF)
    with zipfile.ZipFile(folder / "cem.zip", "w") as zipped:
        zipped.writestr("my work/ch90_small/small.py", RIGHT)
    hand_in(folder, "dee", RIGHT + "\0")
    (folder / "eve").mkdir()
    return folder


def all_but_seconds(out: Path) -> dict[str, str]:
    """Return every file of a run, without what differs between two runs on one machine as well."""
    texts = {path: path.read_text(encoding="utf-8") for path in out.rglob("*") if path.is_file()}
    changing = r'0x[0-9a-f]+|"(seconds|execution_time)": [\d.]+'
    return {str(path.relative_to(out)): re.sub(changing, "", text) for path, text in texts.items()}


def test_a_cluster_gives_what_this_machine_gives(
    cluster: Any, submissions: Path, root: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hidden = tmp_path / "hidden"
    (hidden / "ch90_small").mkdir(parents=True)
    (hidden / "ch90_small/test_more.py").write_text(HIDDEN, encoding="utf-8")
    (hidden / "ch90_small/hidden_probes.py").write_text("FACTOR = 4\n", encoding="utf-8")
    here, there = tmp_path / "here", tmp_path / "there"
    assert grade(submissions, here, root, hidden=hidden) == 0
    capsys.readouterr()
    assert grade(submissions, there, root, hidden=hidden, cluster=cluster.scheduler_address) == 0
    said = capsys.readouterr().out
    assert "Workers: 2. Submissions at a time: 2." in said
    lines = re.findall(r"(?m)^(\d)/4 (\w+)$", said)
    assert [place for place, _ in lines] == list("1234")
    assert sorted(student for _, student in lines) == ["bob", "cem", "dee", "eve"]
    scores = {student: report["score"] for student, report in results(there).items()}
    assert scores.pop("eve") is None, "an empty folder is nothing to grade"
    # Bob has one of three checks; scores have two decimals.
    assert scores == pytest.approx({"bob": 4 + 2 / 3, "cem": 6.0, "dee": 0.0}, abs=0.005)
    assert all_but_seconds(there) == all_but_seconds(here)


@pytest.mark.parametrize("allowed_failures", [3, 0])
def test_what_a_killed_worker_was_at_is_done_by_another(
    cluster: Any,
    root: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    allowed_failures: int,
) -> None:
    """Dask gives it to another worker; where it may not, that is an error and never a zero."""
    monkeypatch.setattr(cluster.scheduler, "allowed_failures", allowed_failures)
    submissions, out = tmp_path / "class", tmp_path / "out"
    hand_in(submissions, "ann", RIGHT)
    assert grade(submissions, out, root, time_limit=2.0) == 0
    ann = results(out)["ann"]
    hand_in(submissions, "slow", RIGHT.replace("return x + x", "while True: pass"))
    with (
        distributed.Client(cluster.scheduler_address, set_as_default=False) as client,
        ThreadPoolExecutor(1) as pool,
    ):
        client.wait_for_workers(2, timeout=PATIENCE)
        folders = dict(client.run(_pid_and_folder).values())
        options = {"time_limit": 2.0, "cluster": cluster.scheduler_address}
        running = pool.submit(grade, submissions, out, root, **options)
        checks = lambda: [pid for pid, own in folders.items() if [*own.glob("checks-*")]]  # noqa: E731
        assert _becomes_true(lambda: bool(checks())), "a worker runs the checks"
        pid = checks()[0]
        folder = folders[pid]
        os.kill(pid, signal.SIGKILL)
        assert "slow" not in results(out), "it was killed in the middle"
        status = running.result(PATIENCE)
    landed = results(out)
    assert sorted(landed) == ["ann", "slow"]
    assert landed["ann"] == ann, "down to the seconds that it took: it is not graded again"
    said = capsys.readouterr().out
    assert "1 of 2 reports" in said
    assert said.count("/2 slow") == 1
    assert _becomes_true(lambda: not folder.exists()), "nothing is left of it on its machine"
    slow = landed["slow"]
    told = {message_of(check) for r in slow["results"] for check in r["checks"]}
    if allowed_failures:
        assert (status, slow["score"]) == (0, 2.0)
    else:
        assert (status, slow["status"]) == (1, "error, retry")
        assert told == {"every worker that tried to grade it died; workers lost: 1"}


def _pid_and_folder(dask_worker: Any) -> tuple[int, Path]:
    return os.getpid(), Path(dask_worker.local_directory)


def _becomes_true(condition: Callable[[], bool]) -> bool:
    deadline = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.01)
    return True


def test_ctrl_c_leaves_what_has_landed(cluster: Any, tmp_path: Path) -> None:
    said = interrupt(tmp_path / "out", "--cluster", cluster.scheduler_address)
    assert "Run the same command again to resume." in said


def test_a_worker_of_another_version_is_refused(
    without_workers: Any, submissions: Path, root: Path, tmp_path: Path
) -> None:
    """And also one that was started before its files became those of this version."""
    other, out = tmp_path / "other", tmp_path / "out"
    shutil.copytree(ROOT / "autograder", other / "autograder")
    scores = other / "autograder/scores.py"
    same = scores.read_text(encoding="utf-8")
    scores.write_text(f"{same}# another version\n", encoding="utf-8")
    with _worker_in(other, without_workers) as address:
        with pytest.raises(ValueError, match=r"cannot grade: .* another version of: grader; start"):
            grade(submissions, out, root, cluster=address)
        scores.write_text(same, encoding="utf-8")
        with pytest.raises(ValueError, match="since the worker was started: restart it"):
            grade(submissions, out, root, cluster=address)
    assert results(out) == {}


@contextmanager
def _worker_in(folder: Path, cluster: Any) -> Iterator[str]:
    """Have a worker that was started in this folder, as by hand; yield the scheduler's address."""
    address = cluster.scheduler_address
    options = ["--nworkers", "1", "--nthreads", "1", "--no-dashboard", "--host", "127.0.0.1"]
    with subprocess.Popen(
        [sys.executable, "-m", "dask", "worker", address, *options],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    ) as process:
        try:
            yield address
        finally:
            process.terminate()
    assert _becomes_true(lambda: not cluster.scheduler.workers)


def test_a_worker_refuses_what_differs_and_never_runs_code_as_root_without_a_wall(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    over_cluster._level.cache_clear()
    monkeypatch.setattr(probe, "best_level", lambda: WALL)
    job = over_cluster.Job.of(Conditions(load_chapters(root), "1", WALL, root=root))
    over_cluster.check_worker(job)
    checks = root / "tests/ch90_small/test_small.py"
    checks.write_text(checks.read_text(encoding="utf-8") + "\n# new\n", encoding="utf-8")
    monkeypatch.setattr(platform, "python_version", lambda: "3.99.0")
    with pytest.raises(ValueError, match=r"another version of: python, checks$"):
        over_cluster.check_worker(job)
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    for best, wanted, words in (
        (replace(WALL, bubblewrap=True), WALL, r"another version of: .*level$"),
        (Level(), Level(), "never runs as root"),
    ):
        over_cluster._level.cache_clear()
        monkeypatch.setattr(probe, "best_level", lambda best=best: best)
        with pytest.raises(ValueError, match=words):
            over_cluster.check_worker(
                replace(job, conditions=replace(job.conditions, level=wanted))
            )
    over_cluster._level.cache_clear()


def test_a_cluster_that_cannot_grade_is_told(
    without_workers: Any,
    submissions: Path,
    root: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(over_cluster, "CONNECTED_WITHIN", 0.5)
    monkeypatch.setattr(over_cluster, "WORKERS_WITHIN", 0.2)
    here = without_workers.scheduler_address
    for address, options, words in (
        (here, {}, "Only 0/1 workers arrived"),
        (here, {"jobs": 2}, "--jobs is for this machine"),
        ("tcp://127.0.0.1:1", {}, "tcp://127.0.0.1:1"),
        ("nowhere://host:1", {}, "nowhere"),
    ):
        with pytest.raises((ValueError, OSError), match=words):
            grade(submissions, tmp_path / "out", root, cluster=address, **options)
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ValueError, match=r"needs Dask, .* autograder/make_venv\.py everything"):
        grade(submissions, tmp_path / "out", root, cluster=here)


def test_a_scheduler_that_goes_away_is_told(submissions: Path, root: Path) -> None:
    conditions = Conditions(load_chapters(root), "1", WALL, root=root)
    everyone = read_class(submissions).submissions
    with (
        start_cluster(0) as going,
        distributed.Client(going.scheduler_address, set_as_default=False) as client,
        ThreadPoolExecutor(1) as pool,
    ):
        waiting = pool.submit(list, over_cluster.grade_over(client, conditions, everyone))
        assert _becomes_true(lambda: len(going.scheduler.tasks) == 4)
        going.close()
        with pytest.raises(ConnectionError, match="the scheduler of the cluster is gone"):
            waiting.result(PATIENCE)
