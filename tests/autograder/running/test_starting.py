"""A template that is forked from the waiting process works like one in a new Python process."""

from __future__ import annotations

import socket
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

import pytest

from autograder.isolation import starting
from autograder.isolation.probe import best_level
from autograder.isolation.template import Template

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="orders need SOCK_SEQPACKET")


def hang() -> NoReturn:
    raise TimeoutError("hangs")


def state_of(process: int) -> list[str]:
    """Return what Linux says about a process: its state, its parent and more."""
    text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
    return text.rpartition(")")[2].split()


def parent_of(process: int) -> int:
    return int(state_of(process)[1])


def is_running(process: int) -> bool:
    return Path(f"/proc/{process}").exists()


@pytest.fixture
def waiting(monkeypatch: pytest.MonkeyPatch) -> Iterator[socket.socket]:
    """Start the process that forks templates, and yield the connection to it."""
    monkeypatch.setattr(starting, "_waiting", [])
    starting.start_waiting()
    (connection,) = starting._waiting
    yield connection
    connection.close()


@pytest.fixture
def template(tmp_path: Path) -> Iterator[Template]:
    level = best_level()
    if level.bubblewrap:
        pytest.skip("bubblewrap starts a new process for each template")
    if not level.seccomp:
        pytest.skip("without seccomp every worker has a template of its own")
    made = Template(level, [], str(tmp_path), tmp_path, 5.0)
    yield made
    made.close()


def worker_of(template: Template) -> int:
    assert template._worker is not None
    return template._worker.number


@pytest.mark.usefixtures("waiting")
def test_a_forked_template_serves_workers_and_ends_with_its_owner(template: Template) -> None:
    assert template.start_worker(hang).ask("length", [1, 2]) == 2
    worker = worker_of(template)
    own = parent_of(worker)
    assert template._process is None, "it is not a process of its owner"
    assert template.start_worker(hang).ask("length", [1]) == 1
    assert parent_of(worker_of(template)) == own
    template.stop_worker()
    template._end()
    for _ in range(100):
        if not is_running(own):
            break
        time.sleep(0.01)
    assert not is_running(own)
    assert not is_running(worker)


def test_the_waiting_process_ends_with_the_last_one_that_could_order(
    waiting: socket.socket, template: Template
) -> None:
    template.start_worker(hang)
    process = parent_of(parent_of(worker_of(template)))
    waiting.close()
    for _ in range(100):
        # This process was its parent, so what is left of it until we wait is a zombie.
        if state_of(process)[0] == "Z":
            break
        time.sleep(0.01)
    else:
        pytest.fail("it still waits for orders")
    assert template.start_worker(hang).ask("length", [1, 2]) == 2, "its templates go on"


def test_without_the_waiting_process_a_template_is_a_new_one(
    waiting: socket.socket, template: Template
) -> None:
    waiting.close()  # an order fails, as it does when the waiting process was killed
    assert template.start_worker(hang).ask("length", [1, 2]) == 2
    assert template._process is not None
