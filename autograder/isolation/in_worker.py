"""Run the checks in this process, and the student's code in a new worker process for each check.

A check file imports placeholders for the student's functions and classes. Each use of one sends a
request to the current worker. Check files are therefore imported only once, although every check
has its own worker.
"""

from __future__ import annotations

import base64
import contextlib
import importlib.abc
import importlib.util
import os
import re
import sys
import threading
from collections.abc import Callable, Mapping, Sequence
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

from autograder.at_home.in_process import Send
from autograder.checks.arrange import Config
from autograder.checks.events import Broken, Imported, Importing
from autograder.diagnosis.explain import explain_import
from autograder.diagnosis.faults import GOING_FURTHER, Fault, StudentLeft
from autograder.diagnosis.undefined import while_imported
from autograder.files import replace_bytes
from autograder.isolation.handles import ObjectHandle, Session, WorkerFailure
from autograder.isolation.launcher import Launcher
from autograder.isolation.sandbox import Level
from autograder.message import Message

# The beginning of bytecode that Python does not compare with the source.
NOT_COMPARED = importlib.util.MAGIC_NUMBER + bytes([1]) + bytes(11)
PACKAGE = re.compile(rf"ch\d\d_\w+(\.{GOING_FURTHER})?")
CHAPTER_MODULE = re.compile(rf"{PACKAGE.pattern}(\.\w+)?")
Current = Callable[[], Session | None]  # returns the session of the current check, if there is one


class InWorker:
    """Runs the student's code in sandboxed workers, one for each check.

    Every worker imports the student's modules afresh, so one check cannot affect the next. Probes,
    which are helper functions of the checks, run there too. The workers of hidden checks come from
    a second launcher, because only they may read the probes of hidden checks.
    """

    session: Session | None = None

    def __init__(self, config: Config) -> None:
        self.config = config
        self.engine = [Path(folder).resolve() for folder in config.engine]
        self.launchers = [
            Launcher(
                Level(**(config.level or {})),
                [str(folder) for folder in self.engine],
                probes,
                config.time_limit,
                config.compiled,
            )
            for probes in config.probes
        ]
        self.launcher = self.launchers[0]  # the one that forks the current worker
        self.launcher.start()  # in the background, while pytest collects the checks
        self.modules: list[str] = []
        self.broken: dict[str, Message] = {}

    def open(self, modules: list[str], broken: Mapping[str, Message], send: Send) -> None:
        """Let the check files import placeholders instead of the student's modules."""
        threading.Thread(target=_exit_with_parent, daemon=True).start()
        sys.meta_path.insert(0, ChapterFinder(lambda: self.session))
        self.modules = modules
        self.broken = dict(broken)
        self.send = send

    def after_collection(self) -> None:
        """Compile the student's modules, and find out which of them cannot be imported."""
        for module, file in self._files().items():
            if module not in self.broken:
                self._compile(module, file)
        self.stop()  # from here on the workers run the student's code
        for module in self.modules:
            if module not in self.broken:
                self._import(module)
        self.stop()

    def _files(self) -> dict[str, Path]:
        """Find the files that a worker may import: the student's modules and the probes."""
        packages = sorted({module.partition(".")[0] for module in self.modules})
        found: dict[str, Path] = {}
        for folder in [*self.engine, Path(self.config.probes[0])]:
            for package in packages:
                for file in sorted((folder / package).rglob("*.py")):
                    module = ".".join(file.relative_to(folder).with_suffix("").parts)
                    found.setdefault(module, file)
        return found

    def _compile(self, module: str, file: Path) -> None:
        """Compile a file where Python looks for its bytecode, unless an earlier run has done so.

        All later workers load this bytecode, so a worker that runs no student code makes it.
        """
        name = f"{file.stem}.{sys.implementation.cache_tag}.pyc"
        kept = Path(self.config.compiled, *file.parent.parts[1:], name)
        if kept.exists():
            return
        if module in self.modules:
            self.send(Importing(module))
        code = None
        with contextlib.suppress(WorkerFailure):  # Python itself may fail on the file
            code = self._worker().ask("compile", str(file))
        if module in self.modules:
            self.send(Imported())
        if type(code) is str:
            replace_bytes(kept, NOT_COMPARED + base64.b64decode(code))

    def _import(self, module: str) -> None:
        self.send(Importing(module))
        session = self._worker()
        try:
            session.ask("import", module)
            self.send(Imported())
            return
        except WorkerFailure as error:
            message = while_imported(module, error.message) if session.dead else error.message
        except (Exception, StudentLeft) as error:
            if not isinstance(fault := getattr(error, "fault", None), Fault):
                raise
            message = explain_import(fault, module, self.engine, self.config.complete)
        self.broken[module] = message
        self.send(Broken(module, message))
        self.stop()  # the next worker starts with this module marked as broken

    def _worker(self) -> Session:
        """Return the session with the current worker or a new one, with all of its time left."""
        session = self.session
        if session is None or session.dead:
            session = self.start()
        session.restart_clock()
        return session

    def start(self, *, hidden: bool = False) -> Session:
        """Start a worker that runs the student's code for one check."""
        self.stop()
        self.launcher = self.launchers[-1 if hidden else 0]
        self.session = session = self.launcher.start_worker(self._on_hang, self.broken)
        if self.broken:
            session.ask("begin", list(self.broken))
        return session

    def stop(self) -> str:
        """End the worker after a check, and return what the student's code printed."""
        self.session = None
        return self.launcher.stop_worker()

    def _on_hang(self) -> NoReturn:
        """Save a stack trace of student code that has taken too long, and exit this process."""
        stack = self.launcher.stack() or "the worker wrote no stack"
        Path(self.config.stack_file).write_text(stack, encoding="utf-8")
        os._exit(1)  # then the launcher ends, and its worker too


def _exit_with_parent() -> None:
    """Exit as soon as standard input closes, which means that the grader has been killed."""
    while os.read(0, 1024):
        pass
    os._exit(1)


class ChapterFinder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """An import hook that gives check files placeholders when they import a chapter."""

    def __init__(self, current: Current) -> None:
        self.current = current

    def find_spec(
        self,
        name: str,
        path: Sequence[str] | None,  # noqa: ARG002
        target: ModuleType | None = None,  # noqa: ARG002
    ) -> ModuleSpec | None:
        if CHAPTER_MODULE.fullmatch(name):
            return ModuleSpec(name, self, is_package=bool(PACKAGE.fullmatch(name)))
        return None

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        if spec.submodule_search_locations is None:
            return ChapterModule(self.current, spec.name)
        return ModuleType(spec.name)

    def exec_module(self, module: ModuleType) -> None:
        """Do not execute the module, because student code may run only in workers."""


class ChapterModule(ModuleType):
    """The stand-in that a check file gets when it imports a student's module.

    During a check, its attributes are read from the worker. Outside a check, they are placeholders.
    Such a placeholder serves all checks of a file: in each, it is a handle on the class or function
    in the worker of that check.
    """

    def __init__(self, current: Current, name: str) -> None:
        super().__init__(name)
        self._current = current

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if (now := self._current()) is not None:
            return now.ask("name", self.__name__, name)

        def session() -> Session:
            if (found := self._current()) is None:
                raise AttributeError(f"{self.__name__}.{name} is used while no check is running")
            return found

        return ObjectHandle(session, {"name": [self.__name__, name]})
