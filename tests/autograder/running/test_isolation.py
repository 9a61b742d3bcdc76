"""A worker, and the handles that checks hold of what is in it."""

from __future__ import annotations

import base64
import math
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, NoReturn

import pytest

from autograder.diagnosis.faults import CheckEnded, StudentLeft
from autograder.isolation.handles import Session, WorkerFailure
from autograder.isolation.launcher import Launcher
from autograder.isolation.probe import best_level
from autograder.isolation.sandbox import Level

MODULE = """
import os


class Box:
    '''Holds a number; as many operators as a check may use.'''

    def __init__(self, n=0):
        self.n = n

    def __add__(self, other):
        return Box(self.n + (other.n if isinstance(other, Box) else other))

    __radd__ = __add__

    def __iadd__(self, other):
        self.n += other
        return self

    def __neg__(self):
        return Box(-self.n)

    def __len__(self):
        return 3

    def __iter__(self):
        return iter([self.n, self])

    def __getitem__(self, place):
        return (self.n, place)

    def __eq__(self, other):
        return True

    def __repr__(self):
        return f"Box({self.n})\\x1b[2J"


class Lie(float):
    def __eq__(self, other):
        return True


class Odd(ZeroDivisionError):
    pass


class Impostor(BaseException):
    pass


Impostor.__name__ = "ValueError"
LIMIT = 7


def same(x):
    return x


def fail(kind):
    raise {"odd": Odd("no"), "exit": SystemExit(3), "impostor": Impostor()}[kind]


def apply(f, *arguments):
    return f(*arguments)


def tries(f):
    try:
        f()
    except Exception as error:
        return f"{type(error).__name__}: {error}"


def nested(depth):
    return [nested(depth - 1)] if depth else 1


def sleep_for_ever():
    while True:
        pass


def who():
    return os.getuid(), os.geteuid()


def leave(code):
    os._exit(code)


def crash():
    import ctypes

    ctypes.string_at(0)


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
def start(level: Level, engine: Path, tmp_path: Path) -> Iterator[Callable[[], Session]]:
    """Starts workers over that engine."""
    (tmp_path / "own").mkdir()
    launcher = Launcher(level, [str(engine)], str(engine), tmp_path / "own", seconds=2.0)
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


NUMBERS = [True, 0, -(2**70), 0.1, math.inf, -0.0]


@pytest.mark.parametrize(
    "value", [None, *NUMBERS, "", "é\ud800\n", [], (1, [2, (3,)]), {"a": {1: 2}}], ids=repr
)
def test_plain_values_cross_as_they_are(session: Session, value: Any) -> None:
    back = name(session, "same")(value)
    assert type(back) is type(value)
    assert repr(back) == repr(value)


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


def test_compiled_code_runs_anew_in_each_worker(
    start: Callable[[], Session], tmp_path: Path
) -> None:
    launcher: Launcher = start.func.__self__  # type: ignore[attr-defined]
    file = tmp_path / "engine/ch91_box/box.py"
    code = start().ask("compile", str(file))
    launcher.hand_over({"ch91_box.box": base64.b64decode(code)})
    file.write_text("raise ImportError('this text was read again')", encoding="utf-8")
    for _ in range(2):
        box = name(start(), "Box")
        with pytest.raises(AttributeError):
            box.left_behind  # noqa: B018
        box.left_behind = 1
