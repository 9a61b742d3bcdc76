"""A worker, the handles that checks hold of what is in it, and the walls around it."""

from __future__ import annotations

import contextlib
import math
import os
import struct
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NoReturn

import pytest

from autograder.diagnosis.faults import CheckEnded, StudentLeft
from autograder.isolation.handles import Session, WorkerFailure
from autograder.isolation.launcher import Launcher, LauncherError
from autograder.isolation.probe import HELD_BY_LANDLOCK, HELD_BY_SECCOMP, best_level, what_fails
from autograder.isolation.sandbox import (
    Level,
    landlock_version,
    seccomp_filter,
    seccomp_works_here,
)

MODULE = """
import os


class Box:
    '''Holds a number; as many operators as a check may use.'''

    def __init__(self, n=0):
        self.n = n

    def __iadd__(self, other):
        self.n += other
        return self

    __add__ = lambda self, other: Box(self.n + (other.n if isinstance(other, Box) else other))
    __radd__ = __add__
    __neg__ = lambda self: Box(-self.n)
    __len__ = lambda self: 3
    __iter__ = lambda self: iter([self.n, self])
    __getitem__ = lambda self, place: (self.n, place)
    __eq__ = lambda self, other: True
    __repr__ = lambda self: f"Box({self.n})\\x1b[2J"


class Lie(float):
    __eq__ = lambda self, other: True


class Odd(ZeroDivisionError):
    pass


class Impostor(BaseException):
    pass


Impostor.__name__ = "ValueError"
LIMIT = 7
same = lambda x: x
apply = lambda f, *arguments: f(*arguments)
who = lambda: (os.getuid(), os.geteuid())
nested = lambda depth: [nested(depth - 1)] if depth else 1
leave = lambda code: os._exit(code)
crash = lambda: __import__("ctypes").string_at(0)


def fail(kind):
    raise {"odd": Odd("no"), "exit": SystemExit(3), "impostor": Impostor()}[kind]


def tries(f):
    try:
        f()
    except Exception as error:
        return f"{type(error).__name__}: {error}"


def sleep_for_ever():
    while True:
        pass


def close_everything():
    os.closerange(0, 99)
    sleep_for_ever()
"""


@pytest.fixture(scope="module")
def level() -> Level:
    return best_level()


@pytest.fixture
def engine(tmp_path: Path) -> Path:
    """An engine of one module, ch91_box/box.py."""
    module = tmp_path / "engine/ch91_box/box.py"
    module.parent.mkdir(parents=True)
    module.write_text(MODULE, encoding="utf-8")
    return tmp_path / "engine"


@pytest.fixture
def start(level: Level, engine: Path) -> Iterator[Callable[[], Session]]:
    launcher = Launcher(level, [str(engine)], str(engine), seconds=2.0)
    yield partial(launcher.start_worker, hang)
    launcher.close()


def hang() -> NoReturn:
    raise TimeoutError("hangs")


@pytest.fixture
def session(start: Callable[[], Session]) -> Session:
    return start()


def name(session: Session, wanted: str) -> Any:
    return session.ask("name", "ch91_box.box", wanted)


def test_what_checks_do_with_objects(session: Session) -> None:
    kind = name(session, "Box")
    box = kind(4)
    assert (box.n, (box + 1).n, (1 + box).n, (box + box).n, (-box).n) == (4, 5, 5, 8, -4)
    alias = box
    box += 10
    assert alias.n == 14
    box.n = 2.5
    assert alias.n == 2.5
    assert len(box) == 3
    assert box["x"] == (2.5, "x")
    number, again = box
    assert (number, again.n) == (2.5, 2.5)
    assert isinstance(box, kind)
    assert not isinstance(3, kind)
    assert name(session, "LIMIT") == 7


USES = "box == 4; box != 4; box > 3; bool(box); float(box); math.sqrt(box); 4 in box; [1, 2][box]"


@pytest.mark.parametrize("use", USES.split("; "))
def test_no_verdict_hangs_on_what_an_object_says_of_itself(session: Session, use: str) -> None:
    with pytest.raises(CheckEnded, match=r"plain value is expected: Box\(4\)\\x1b\[2J"):
        eval(use, {"box": name(session, "Box")(4), "math": math})


def test_only_exact_types_cross_by_value(session: Session) -> None:
    lie = name(session, "Lie")(2.0)
    assert type(lie) is not float
    with pytest.raises(CheckEnded):
        assert lie == 2.0
    with pytest.raises(TypeError, match="only plain data"):
        name(session, "same")(1j)


def test_what_is_too_much_is_said_and_is_no_result(session: Session) -> None:
    same, nested = name(session, "same"), name(session, "nested")
    assert nested(20) is not None
    with pytest.raises(WorkerFailure, match="a list nested in more than 20 others"):
        nested(22)
    with pytest.raises(WorkerFailure, match="an integer of 5001 bits"):
        session.ask("operate", "lshift", [1, 5000])
    with pytest.raises(WorkerFailure, match="a list of more than 20000 items"):
        session.ask("operate", "mul", [[0], 20001])
    assert same(1) == 1, "the worker goes on"


def test_errors_come_as_the_built_in_ones_with_the_students_line(session: Session) -> None:
    fail = name(session, "fail")
    with pytest.raises(ZeroDivisionError, match="no") as caught:
        fail("odd")
    fault = caught.value.fault  # type: ignore[attr-defined]
    assert fault.type == "Odd"
    assert str(fault.frames[-1]).startswith("ch91_box/box.py, line ")
    assert str(fault.frames[-1]).endswith("in fail")
    for kind in ("exit", "impostor"):
        with pytest.raises(StudentLeft) as left:
            fail(kind)
        assert not isinstance(left.value, Exception)


def test_call_backs_may_use_objects_and_raise(session: Session) -> None:
    apply, tries, kind = (name(session, wanted) for wanted in ("apply", "tries", "Box"))
    assert apply(lambda box: box + box.n, kind(5)).n == 10
    assert apply(lambda: apply(lambda: 9)) == 9

    def refuses() -> None:
        raise KeyError("mine")

    assert tries(refuses) == "KeyError: 'mine'"
    assert apply(abs, -3) == 3, "nothing is out of step"


def test_a_call_back_that_ends_the_check_is_not_caught_by_the_student(session: Session) -> None:
    with pytest.raises(pytest.fail.Exception, match="enough"):
        name(session, "tries")(lambda: pytest.fail("enough"))
    with pytest.raises(WorkerFailure, match="a callback of the check failed"):
        name(session, "LIMIT")


@pytest.mark.parametrize(
    ("wanted", "arguments", "words"),
    [
        ("leave", [0], "ended early, with exit code 0"),
        ("leave", [3], "ended early, with exit code 3"),
        ("crash", [], "ended early: Python crashed .Segmentation fault"),
        ("close_everything", [], "stopped answering: the code closed its connection"),
    ],
)
def test_a_worker_that_leaves_is_no_exception_that_a_check_may_expect(
    session: Session, wanted: str, arguments: list[int], words: str
) -> None:
    with pytest.raises(WorkerFailure, match=words) as caught:
        name(session, wanted)(*arguments)
    assert not isinstance(caught.value, Exception)
    with pytest.raises(WorkerFailure, match=words):
        name(session, "LIMIT")


def test_a_worker_that_does_not_answer_is_a_hang(session: Session) -> None:
    start = time.monotonic()
    with pytest.raises(TimeoutError):
        name(session, "sleep_for_ever")()
    assert 1.0 < time.monotonic() - start < 30.0


def test_each_worker_starts_from_nothing(start: Callable[[], Session]) -> None:
    first = start()
    box = name(first, "Box")(1)
    name(first, "Box").left_behind = 99
    second = start()
    with pytest.raises(AttributeError):
        name(second, "Box").left_behind  # noqa: B018
    with pytest.raises(WorkerFailure):
        box.n = 2
    with pytest.raises(WorkerFailure, match="another check"):
        name(second, "same")(box)


def test_a_worker_is_no_root(session: Session, level: Level) -> None:
    if not level.is_sandbox:
        pytest.skip("this machine has no sandbox")
    assert 0 not in name(session, "who")()


# The walls, and what gets through where one is missing


@pytest.mark.skipif(landlock_version() == 0, reason="there is no Landlock here")
def test_the_walls_hold_what_gets_through_without_them(tmp_path: Path, level: Level) -> None:
    if not (level.landlock and level.seccomp):
        pytest.skip("Landlock or seccomp does not work here")
    attempts = [*HELD_BY_LANDLOCK, *HELD_BY_SECCOMP]
    (tmp_path / "forbidden").touch()
    through = []
    for number, walls in enumerate([Level(), Level(landlock=True), Level(seccomp=True), level]):
        own = tmp_path / str(number)
        own.mkdir()
        launcher = Launcher(walls, [], str(own), 5.0)
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


@pytest.mark.parametrize("most", [20, 28, 30, 33])
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
def test_a_worker_without_the_filter_keeps_no_privilege_of_root() -> None:
    """With it, open_by_handle_at would read any file. The filter refuses that call."""
    with contextlib.ExitStack() as stack:
        engine = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        engine.chmod(0o755)  # without the privilege, the worker is an ordinary user
        (engine / "ch90_small").mkdir()
        (engine / "ch90_small/small.py").write_text(CAPABILITIES, encoding="utf-8")
        launcher = Launcher(Level(landlock=True), [str(engine)], str(engine), 5.0)
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
    monkeypatch.setattr("autograder.isolation.launcher.ROOT", tmp_path)  # it has no autograder
    launcher = Launcher(level, [], str(tmp_path), 1.0)
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
