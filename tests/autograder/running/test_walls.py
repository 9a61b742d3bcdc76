"""The walls around a worker, and what gets through where one is missing."""

from __future__ import annotations

import contextlib
import os
import struct
import tempfile
from pathlib import Path
from typing import NoReturn

import pytest

from autograder.isolation.launcher import Launcher, LauncherError
from autograder.isolation.probe import HELD_BY_LANDLOCK, HELD_BY_SECCOMP, best_level, what_fails
from autograder.isolation.sandbox import (
    Level,
    landlock_version,
    seccomp_filter,
    seccomp_works_here,
)


def hang() -> NoReturn:
    raise TimeoutError("hangs")


@pytest.fixture(scope="module")
def level() -> Level:
    return best_level()


@pytest.mark.skipif(landlock_version() == 0, reason="there is no Landlock here")
def test_the_walls_hold_what_gets_through_without_them(tmp_path: Path, level: Level) -> None:
    if not (level.landlock and level.seccomp):
        pytest.skip("Landlock and seccomp do not stand here")
    attempts = [*HELD_BY_LANDLOCK, *HELD_BY_SECCOMP]
    (tmp_path / "forbidden").touch()
    through = []
    for number, walls in enumerate([Level(), Level(landlock=True), Level(seccomp=True), level]):
        own = tmp_path / str(number)
        own.mkdir()
        launcher = Launcher(walls, [], str(own), own, 5.0)
        with contextlib.closing(launcher):
            session = launcher.start_worker(hang)
            path = str(tmp_path / "forbidden")
            through.append(set(session.ask("test_walls", attempts, path)))
    nothing, landlock, seccomp, all_of_them = through
    assert nothing >= {*HELD_BY_LANDLOCK, "sending a signal"}
    assert landlock.isdisjoint(HELD_BY_LANDLOCK)
    assert seccomp.isdisjoint(HELD_BY_SECCOMP)
    assert seccomp >= {*HELD_BY_LANDLOCK}
    assert all_of_them == set()


@pytest.mark.parametrize("most", range(20, 34))
def test_a_sandbox_works_however_many_files_its_runner_has_open(level: Level, most: int) -> None:
    """Some descriptors of a worker have fixed numbers, up to 31."""
    with contextlib.ExitStack() as files:
        while files.enter_context(Path(os.devnull).open(encoding="utf-8")).fileno() < most:
            pass
        assert what_fails(level) == ""


CAPABILITIES = """
import ctypes
import struct


def of_this_process():
    header, data = struct.pack("Ii", 0x20080522, 0), ctypes.create_string_buffer(24)
    if ctypes.CDLL(None).capget(header, data):
        return "the filter refuses to tell"
    return struct.unpack("6I", data.raw)[0]
"""


@pytest.mark.skipif(
    landlock_version() == 0 or os.geteuid() != 0, reason="only root has privileges to lose"
)
def test_a_worker_without_the_filter_keeps_no_privilege_of_root(tmp_path: Path) -> None:
    """With it, open_by_handle_at would read any file. The filter refuses that call."""
    with contextlib.ExitStack() as stack:
        engine = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        engine.chmod(0o755)  # without the privilege, the worker is an ordinary user
        (engine / "ch90_small").mkdir()
        (engine / "ch90_small/small.py").write_text(CAPABILITIES, encoding="utf-8")
        launcher = Launcher(Level(landlock=True), [str(engine)], str(engine), tmp_path, 5.0)
        stack.enter_context(contextlib.closing(launcher))
        session = launcher.start_worker(hang)
        assert session.ask("name", "ch90_small.small", "of_this_process")() == 0


def test_a_wall_that_cannot_be_put_up_is_not_believed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("autograder.isolation.launcher.python_folders", lambda: ["/"])
    level = Level(landlock=True, seccomp=seccomp_works_here())
    assert what_fails(level), "everything can be read"


def test_a_launcher_that_cannot_start_says_so(
    tmp_path: Path, level: Level, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("autograder.isolation.starting.ROOT", tmp_path)  # it has no autograder
    launcher = Launcher(level, [], str(tmp_path), tmp_path, 1.0)
    with (
        contextlib.closing(launcher),
        pytest.raises(LauncherError, match=r"(?s)did not start: .*No module named"),
    ):
        launcher.start_worker(hang)


def test_the_filter_refuses_what_it_does_not_name() -> None:
    """Run the program by hand, as the kernel does: 8 bytes an instruction."""

    def verdict(architecture: int, number: int) -> int:
        program = seccomp_filter()
        place, loaded = 0, 0
        while True:
            code, yes, no, value = struct.unpack_from("=HBBI", program, 8 * place)
            place += 1
            match code:
                case 0x20:
                    loaded = architecture if value == 4 else number
                case 0x15:
                    place += yes if loaded == value else no
                case 0x35:
                    place += yes if loaded >= value else no
                case 0x06:
                    return value

    allow, refuse, kill = 0x7FFF0000, 0x00050001, 0x80000000
    x86_64 = 0xC000003E
    read, write, exit_group, statx = 0, 1, 231, 332
    for number in (read, write, exit_group, statx):
        assert verdict(x86_64, number) == allow
    # ioctl, socket, clone, fork, vfork, execve, kill, ptrace, fcntl, prlimit64, memfd_create,
    # execveat, clone3, name_to_handle_at, open_by_handle_at, and the 32-bit way in.
    refused = (16, 41, 56, 57, 58, 59, 62, 101, 72, 302, 319, 322, 435, 303, 304, 0x40000000 | 1)
    for number in refused:
        assert verdict(x86_64, number) == refuse
    assert verdict(0x40000003, read) == kill, "another architecture"
