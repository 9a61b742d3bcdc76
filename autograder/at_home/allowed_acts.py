"""Keep a student's code from writing files, starting programs or threads, and opening sockets.

The grader's sandbox blocks all of these operations. Students run the checks at home without a
sandbox, so this module uses Python's audit events instead. For example, Python raises an audit
event just before it opens a file. If the student's code caused the event, this module raises the
same error that the sandbox would cause.

The purpose is to warn students early about operations that the grader will block. This does not
stop hostile code, because some operations, such as os.pipe, have no audit event.
"""

from __future__ import annotations

import _thread
import os
import socket
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from autograder.at_home.students_code import LIBRARY, StudentsCode
from autograder.diagnosis.faults import is_inside

WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
READABLE = [*LIBRARY, *map(Path, ("/lib", "/lib64", "/usr/lib", "/usr/lib64"))]
THREAD_STARTERS = "start_new_thread _start_new_thread start_joinable_thread _start_joinable_thread"
# We use the numbers that Linux gives these errors, because Python in a browser has others.
NOT_PERMITTED = 1, "Operation not permitted"
NOT_FOUND = 2, "No such file or directory"
DENIED = 13, "Permission denied"
NOT_STARTED = 32512  # what os.system returns if it cannot start a process

# We refuse these audit events. They are grouped by how many paths the error message names.
WITH_PATH = "os.mkdir os.remove os.rmdir os.chmod os.chown os.truncate os.chdir os.posix_spawn"
WITH_PATHS = "os.rename os.link os.symlink"
WITHOUT = (
    "os.utime os.fork os.forkpty os.exec subprocess.Popen os.kill os.killpg signal.pthread_kill "
    "socket.__new__ socket.gethostname"
)


def limit_acts(code: StudentsCode) -> None:
    """Block every operation of the student's code that the grader's sandbox would not allow.

    For example, the code cannot write files or start threads. The operations stay blocked until the
    process ends.
    """
    refusals: dict[str, Callable[..., None]] = {
        "open": lambda *arguments: _open(code, *arguments),
        "os.listdir": lambda path: _list(code, path),
        "os.scandir": lambda path: _list(code, path),
        "socket.getaddrinfo": _no_address,
    }
    refusals |= dict.fromkeys(WITH_PATH.split(), lambda path, *_: _not_permitted(path))
    refusals |= dict.fromkeys(WITH_PATHS.split(), lambda one, two, *_: _not_permitted(one, two))
    refusals |= dict.fromkeys(WITHOUT.split(), lambda *_: _not_permitted())

    def hear(event: str, arguments: tuple[Any, ...]) -> None:
        if event in refusals and code.is_calling():
            refusals[event](*arguments)

    sys.addaudithook(hear)
    real_system = os.system
    os.system = lambda command: NOT_STARTED if code.is_calling() else real_system(command)
    for module in (_thread, threading):  # not every version of Python has an event for these
        for name in THREAD_STARTERS.split():
            if hasattr(module, name):
                setattr(module, name, _no_threads(code, getattr(module, name)))


def _open(code: StudentsCode, path: Any, _: str | None, flags: int) -> None:
    if isinstance(path, int):
        return  # it is the descriptor of a file that is already open
    file = os.path.realpath(path)
    if flags & WRITING:
        if os.path.isdir(os.path.dirname(file)):  # noqa: PTH112, PTH120 - it may be bytes
            raise PermissionError(*DENIED, path)
    elif not os.path.exists(file):  # noqa: PTH110
        if sys.platform == "emscripten":
            raise FileNotFoundError(*NOT_FOUND, path)
    elif is_inside(os.fsdecode(file), code.folders):
        package, name = Path(os.fsdecode(file)).parts[-2:]
        if not code.is_graded(package, name):
            raise FileNotFoundError(*NOT_FOUND, path)
    else:
        _allow_reading(file, path)


def _list(code: StudentsCode, path: Any) -> None:
    folder = os.path.realpath("." if path is None else path) if not isinstance(path, int) else "/"
    if os.path.isdir(folder):  # noqa: PTH112
        _allow_reading(folder, path, code.folders)


def _allow_reading(file: Any, path: Any, more: list[Path] | None = None) -> None:
    """Raise a PermissionError if the sandbox would not let the student's code read this file.

    The code may read only Python's library and files inside the folders listed in ``more``.
    """
    inside = os.path.join(os.fsdecode(file), "x")  # noqa: PTH118 - a folder contains itself
    if not is_inside(inside, [*READABLE, *(more or []), Path(os.devnull)]):
        raise PermissionError(*DENIED, path)


def _not_permitted(one: Any = None, two: Any = None) -> None:
    raise PermissionError(*NOT_PERMITTED, one, None, two)


def _no_address(*_: Any) -> None:
    raise socket.gaierror(socket.EAI_AGAIN, "Temporary failure in name resolution")


def _no_threads(code: StudentsCode, start: Callable[..., Any]) -> Callable[..., Any]:
    def guarded_start(*arguments: Any, **keywords: Any) -> Any:
        if code.is_calling():
            raise RuntimeError("can't start new thread")
        return start(*arguments, **keywords)

    return guarded_start
