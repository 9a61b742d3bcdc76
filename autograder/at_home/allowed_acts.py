"""Keep a student's code from writing files, starting programs or threads, and opening sockets.

This module uses Python's audit events. For example, Python raises an audit event just before it
opens a file. If the student's code caused the event, this module raises an error. It is used at
home and in the grader, so a student sees the same error in both, whatever the system would say.

The purpose is to warn students early about operations that are not allowed. This does not stop
hostile code, because some operations, such as os.pipe, have no audit event. In the grader, the
sandbox does that.
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
    """Block the operations of a student's code that an engine does not need, such as writing files.

    The operations stay blocked until the process ends.
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
    if flags & WRITING:
        raise PermissionError(*DENIED, path)
    file = Path(os.fsdecode(os.path.realpath(path)))
    if inside := _inside_engine(code, file):
        if not (len(inside) == 2 and code.is_graded(*inside)):
            raise FileNotFoundError(*NOT_FOUND, path)
    elif not is_inside(str(file), READABLE) and file != Path(os.devnull):
        raise _outside(path)
    if not file.exists():
        raise FileNotFoundError(*NOT_FOUND, path)  # as on Linux, also in a browser


def _list(code: StudentsCode, path: Any) -> None:
    if path is None or isinstance(path, int):
        path = "/"  # the current folder, or a descriptor, which may belong to any folder
    folder = Path(os.fsdecode(os.path.realpath(path)))
    if folder in code.folders or is_inside(str(folder / "x"), READABLE):
        return
    inside = _inside_engine(code, folder)
    if not inside:
        raise _outside(path)
    if len(inside) > 1:  # the grader does not copy the subfolders of a chapter
        raise FileNotFoundError(*NOT_FOUND, path)


def _inside_engine(code: StudentsCode, path: Path) -> tuple[str, ...]:
    """Return the parts of a path below the engine's folder, or () if it is somewhere else."""
    for folder in code.folders:
        if path.is_relative_to(folder):
            return path.relative_to(folder).parts
    return ()


def _outside(path: Any) -> OSError:
    """Return the error for reading a path outside the engine and Python's library.

    The sandbox may hide a file or only refuse to read it, depending on the machine. The error must
    not depend on that, so it is chosen by the path alone. The current folder is /, so the file with
    a relative path counts as missing.
    """
    if os.path.isabs(path) or os.fsdecode(path) == ".":  # noqa: PTH117 - it may be bytes
        return PermissionError(*DENIED, path)
    return FileNotFoundError(*NOT_FOUND, path)


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
