"""Refuse at home what the grader's sandbox refuses, with the same errors.

Student code may import only the standard library and the files that the grader has. It may not
write files, start programs or threads, or open sockets. This does not stop hostile code, because
some operations, such as os.pipe, cannot be noticed here. In the grader, the sandbox does that.
"""

from __future__ import annotations

import builtins
import importlib
import importlib.util
import os
import re
import sys
import sysconfig
import threading
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from types import FrameType, ModuleType
from typing import Any

from autograder.diagnosis.faults import GOING_FURTHER, is_inside, short
from autograder.manifest import Chapter

LIBRARY = [Path(sysconfig.get_path(name)).resolve() for name in ("stdlib", "platstdlib")]
# The library may also be in a zip file beside that folder, as it is in a browser.
LIBRARY.append(LIBRARY[0].with_name(f"python{''.join(map(str, sys.version_info[:2]))}.zip"))
# These folders may be inside the library's folder, but they hold other packages.
PACKAGES = [folder / name for folder in LIBRARY for name in ("site-packages", "dist-packages")]
READABLE = [*LIBRARY, *map(Path, ("/lib", "/lib64", "/usr/lib", "/usr/lib64"))]
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
STANDARD_MODULES = sys.stdlib_module_names | {"__main__"}
CHAPTER = re.compile(r"ch\d\d_\w+")
# We refuse these audit events. The place in the list is the number of paths that the error names.
REFUSED = (
    "os.utime os.fork os.forkpty os.exec subprocess.Popen os.kill os.killpg signal.pthread_kill "
    "socket.__new__ socket.gethostname",
    "os.mkdir os.remove os.rmdir os.chmod os.chown os.truncate os.chdir os.posix_spawn",
    "os.rename os.link os.symlink",
)
THREAD_STARTERS = ("_start_new_thread", "_start_joinable_thread")  # the second since Python 3.13
# We use the numbers that Linux gives these errors, because Python in a browser has others.
NOT_PERMITTED = 1, "Operation not permitted"
NOT_FOUND = 2, "No such file or directory"
DENIED = 13, "Permission denied"
NOT_STARTED = 32512  # what os.system returns if it cannot start a process


def graded_files(chapters: Iterable[Chapter]) -> dict[str, list[str]]:
    """List the files of each chapter that will also be available in the grader."""
    return {chapter.name: [*chapter.handed_in, *chapter.complete] for chapter in chapters}


class StudentsCode:
    """Recognizes a student's code by the folder that contains it."""

    def __init__(
        self,
        folders: Iterable[Path],
        graded: Mapping[str, Collection[str]],
        ours: Collection[str] = (),
    ) -> None:
        self.folders = [folder.resolve() for folder in folders]
        self.graded = graded  # by chapter, the files that the grader will have; without entry all
        self.ours = ours  # files in the folders that the student did not write
        self._known: dict[str, bool | None] = {}

    change = __init__  # in a browser, one process runs the checks on one code after the other

    def is_calling(self) -> bool:
        """Return True if the innermost function outside of Python's library is the student's."""
        frame: FrameType | None = sys._getframe(2)
        while frame is not None:
            file = frame.f_code.co_filename
            if file not in self._known:
                self._known[file] = self._is_students(file)
            if (answer := self._known[file]) is not None:
                return answer
            frame = frame.f_back
        return False

    def _is_students(self, file: str) -> bool | None:
        """Return whether the student wrote a file, or None if its caller decides."""
        if file.startswith("<frozen importlib"):
            return False  # Python itself opens files during an import
        if file.startswith("<"):  # such as <string>, from exec, and <frozen os>
            return None
        if is_inside(file, self.folders):
            return short(file) not in self.ours
        library = is_inside(file, LIBRARY) and not is_inside(file, PACKAGES)
        return None if library else False

    def is_graded(self, package: str, file: str) -> bool:
        """Return True if a file of a chapter, or a probe of our checks, will be in the grader."""
        return (
            package not in self.graded or file in self.graded[package] or file.endswith("probes.py")
        )


def restrict(code: StudentsCode) -> None:
    """Refuse what a student's code may not import or do, until the process ends."""
    _restrict_imports(code)
    refusals: dict[str, Callable[..., None]] = {
        event: partial(_refuse, number)
        for number, events in enumerate(REFUSED)
        for event in events.split()
    }
    refusals["open"] = partial(_limit_opening, code)
    refusals["os.listdir"] = refusals["os.scandir"] = partial(_limit_listing, code)
    refusals["socket.getaddrinfo"] = _refuse_address

    def hear(event: str, arguments: tuple[Any, ...]) -> None:
        if event in refusals and code.is_calling():
            refusals[event](*arguments)

    sys.addaudithook(hear)
    real_system = os.system
    os.system = lambda command: NOT_STARTED if code.is_calling() else real_system(command)
    for name in filter(partial(hasattr, threading), THREAD_STARTERS):
        setattr(threading, name, _without_threads(code, getattr(threading, name)))


def _refuse(paths: int, *arguments: Any) -> None:
    one, two, *_ = [*arguments[:paths], None, None]
    raise PermissionError(*NOT_PERMITTED, one, None, two)


def _refuse_address(*_: Any) -> None:
    import socket  # which takes a while, unless the student's code has imported it

    raise socket.gaierror(socket.EAI_AGAIN, "Temporary failure in name resolution")


def _without_threads(code: StudentsCode, start: Callable[..., Any]) -> Callable[..., Any]:
    def guarded_start(*arguments: Any, **keywords: Any) -> Any:
        if code.is_calling():
            raise RuntimeError("can't start new thread")
        return start(*arguments, **keywords)

    return guarded_start


def _limit_opening(code: StudentsCode, path: Any, _: str | None, flags: int) -> None:
    if isinstance(path, int):
        return  # it is the descriptor of a file that is already open
    if flags & WRITING:
        raise PermissionError(*DENIED, path)
    file, inside = _readable(code, path)
    is_graded = not inside or (len(inside) == 2 and code.is_graded(*inside))
    if not (is_graded and file.exists()):
        raise FileNotFoundError(*NOT_FOUND, path)


def _limit_listing(code: StudentsCode, path: Any) -> None:
    if path is None or isinstance(path, int):
        path = "/"  # the current folder, or a descriptor, which may belong to any folder
    _, inside = _readable(code, path)
    if len(inside) > 1:  # the grader does not copy the subfolders of a chapter
        raise FileNotFoundError(*NOT_FOUND, path)


def _readable(code: StudentsCode, path: Any) -> tuple[Path, tuple[str, ...]]:
    """Return a path that may be read, and its parts below the engine's folder.

    Depending on the machine, the sandbox may hide another file or only refuse to read it. So the
    path alone decides the error. A relative path counts as missing, as the current folder is /.
    """
    place = Path(os.fsdecode(os.path.realpath(path)))
    for folder in code.folders:
        if place.is_relative_to(folder):
            return place, place.relative_to(folder).parts
    if is_inside(str(place / "x"), READABLE):
        return place, ()
    if os.path.isabs(path) or os.fsdecode(path) == ".":  # noqa: PTH117 - it may be bytes
        raise PermissionError(*DENIED, path)
    raise FileNotFoundError(*NOT_FOUND, path)


def _restrict_imports(code: StudentsCode) -> None:
    real_import, real_import_module = builtins.__import__, importlib.import_module

    def guarded_import(
        name: str,
        globals: Mapping[str, Any] | None = None,  # noqa: A002 - Python's own names
        locals: Mapping[str, Any] | None = None,  # noqa: A002
        fromlist: Sequence[str] | None = (),
        level: int = 0,
    ) -> ModuleType:
        name_given = "." * level + name
        if not _is_standard(name_given) and code.is_calling():
            package = (globals or {}).get("__package__")
            _limit_import(code, name_given, package, fromlist or ())
        return real_import(name, globals, locals, fromlist or (), level)

    def guarded_import_module(name: str, package: str | None = None) -> ModuleType:
        if not _is_standard(name) and code.is_calling():
            _limit_import(code, name, package, ())
        return real_import_module(name, package)

    builtins.__import__ = guarded_import
    importlib.import_module = guarded_import_module


def _is_standard(name: str) -> bool:
    return name.partition(".")[0] in STANDARD_MODULES


def _limit_import(
    code: StudentsCode, name: str, package: str | None, fromlist: Sequence[str]
) -> None:
    """Raise ImportError, with Python's own words, if an import would fail in the grader."""
    if name.startswith("."):
        try:
            name = importlib.util.resolve_name(name, package)
        except ImportError:
            return  # Python itself raises the error
    if _is_standard(name):
        return
    top, _, rest = name.partition(".")
    if not CHAPTER.fullmatch(top):
        raise ModuleNotFoundError(f"No module named {top!r}", name=top)
    if rest not in ("", GOING_FURTHER):
        if not code.is_graded(top, f"{rest.replace('.', '/')}.py"):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        return
    folder = f"{rest}/" if rest else ""
    for wanted in fromlist:
        if not (wanted.startswith(("_", "*")) or code.is_graded(top, f"{folder}{wanted}.py")):
            raise ImportError(
                f"cannot import name {wanted!r} from {name!r} (unknown location)", name=name
            )
