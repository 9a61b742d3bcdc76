"""Run the checks in this process, and the student's code in a new worker process for each check.

When a check file imports a chapter, it gets placeholders for the student's functions and classes.
Whenever a check uses a placeholder, a request is sent to the current worker. Check files therefore
need to be imported only once, even though every check has its own worker.
"""

from __future__ import annotations

import base64
import contextlib
import hashlib
import os
import sys
import threading
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NoReturn

from autograder.at_home.in_process import Send
from autograder.checks.arrange import Workers
from autograder.checks.events import Broken, Imported, Importing
from autograder.diagnosis.explain import explain_import
from autograder.diagnosis.faults import Fault, StudentLeft
from autograder.diagnosis.undefined import while_imported
from autograder.isolation.handles import Session, WorkerFailure
from autograder.isolation.placeholders import ChapterFinder
from autograder.isolation.sandbox import Level
from autograder.isolation.template import Template
from autograder.message import Message

LARGE = 50_000  # bytes; a larger file is compiled in a new worker, which has all of its time left


class InWorker:
    """Runs the student's code in sandboxed worker processes, one for each check.

    Every worker imports the student's modules afresh, so one check cannot affect the next.
    """

    session: Session | None = None

    def __init__(
        self,
        engine: list[str],
        time_limit: float,
        stack_file: str,
        complete: Sequence[str],
        worker: Workers,
    ) -> None:
        self.engine = [Path(folder).resolve() for folder in engine]
        self.stack_file = Path(stack_file)
        self.complete = complete
        self.probes = Path(worker.probes)
        self.compiled = Path(worker.compiled)
        probes = dict.fromkeys([worker.probes, worker.hidden_probes])
        self.templates = [
            Template(
                Level(**worker.level),
                [str(folder) for folder in self.engine],
                folder,
                self.stack_file.parent,
                time_limit,
            )
            for folder in probes
        ]
        self.template = self.templates[0]  # the one that forks the current worker
        self.template.warm_up()  # starts while pytest collects the checks
        self.modules: list[str] = []
        self.broken: dict[str, Message] = {}

    def open(self, modules: list[str], broken: Mapping[str, Message], send: Send) -> None:
        """Let the check files import placeholders instead of the student's modules.

        The student's modules themselves are imported later, in the sandboxed workers.
        """
        threading.Thread(target=_exit_with_parent, daemon=True).start()
        sys.meta_path.insert(0, ChapterFinder(self))
        self.modules = modules
        self.broken = dict(broken)
        self.send = send

    def after_collection(self) -> None:
        """Compile the student's modules, and find out which of them cannot be imported.

        As a test, each module is imported once in a worker. If that fails, every check that needs
        the module fails with a message that says why.
        """
        compiled: dict[str, bytes] = {}
        for module, file in self._files().items():
            if module not in self.broken and (code := self._code_of(module, file)):
                compiled[module] = code
        self.stop()  # from here on the workers run the student's code
        for template in self.templates:
            template.hand_over(compiled)
        for module in self.modules:
            if module not in self.broken:
                self._import(module)
        self.stop()

    def _files(self) -> dict[str, Path]:
        """Find the files that a worker may import: the student's modules and the probes.

        Probes are helper functions of the checks that must run in the same process as the student's
        code.
        """
        packages = {module.partition(".")[0] for module in self.modules}
        found: dict[str, Path] = {}
        for folder in [*self.engine, self.probes]:
            for package in sorted(packages):
                for file in sorted((folder / package).rglob("*.py")):
                    module = ".".join(file.relative_to(folder).with_suffix("").parts)
                    found.setdefault(module, file)
        return found

    def _code_of(self, module: str, file: Path) -> bytes | None:
        """Return the bytecode of a student's module, or None if the file cannot be compiled.

        Bytecode from an earlier run of checks on the same submission is reused.
        """
        text = f"{file}\n".encode() + file.read_bytes()
        kept = self.compiled / hashlib.sha256(text).hexdigest()
        if kept.exists():
            return kept.read_bytes()
        code = self._compile(module, file)
        if code is not None:
            part = kept.with_suffix(".part")  # this process may be killed at any time
            part.write_bytes(code)
            part.replace(kept)
        return code

    def _compile(self, module: str, file: Path) -> bytes | None:
        """Compile a student's file in a worker that has not yet run any student code.

        All later workers will use this bytecode, so student code must not get a chance to tamper
        with it.
        """
        if module in self.modules:
            self.send(Importing(module))
        code = None
        with contextlib.suppress(WorkerFailure):  # Python itself may fail on the file
            code = self._worker(file.stat().st_size > LARGE).ask("compile", str(file))
        if module in self.modules:
            self.send(Imported())
        return base64.b64decode(code) if type(code) is str else None

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
            message = explain_import(fault, module, self.engine, self.complete)
        self.broken[module] = message
        self.send(Broken(module, message))
        self.stop()  # the next worker starts with this module marked as broken

    def definitions(self, file: Path) -> set[str] | None:
        """Ask the worker process for the names that a student's file defines.

        Return None if there is no valid answer, for example because the student's code has damaged
        the process.
        """
        if self.session is None or self.session.dead:
            return None
        try:
            found = self.session.ask("definitions", str(file))
        except (Exception, WorkerFailure, StudentLeft):  # the code may have damaged its process
            return None
        names = found if type(found) is list else []
        return {name for name in names if type(name) is str} or None

    def _worker(self, new: bool = False) -> Session:
        """Return the session with the current worker process, and start a worker if there is none.

        If ``new`` is set, a new worker is started in any case. Each call restarts the time limit.
        """
        if new or self.session is None or self.session.dead:
            self.start()
        assert self.session is not None
        self.session.deadline = time.monotonic() + self.template.seconds
        return self.session

    def start(self, *, hidden: bool = False) -> None:
        """Start a sandboxed worker process that runs the student's code for one check.

        Only the worker of a ``hidden`` check can read the probes of hidden checks.

        Raises:
            TemplateError: The worker did not start.
        """
        self.stop()
        self.template = self.templates[-1 if hidden else 0]
        self.session = self.template.start_worker(self._on_hang, self.broken)
        if self.broken:
            self.session.ask("begin", list(self.broken))

    def stop(self) -> str:
        """End the worker process after a check, and return what the student's code printed."""
        printed = self.template.printed() if self.session else ""
        self.session = None
        self.template.stop_worker()
        return printed

    def _on_hang(self) -> NoReturn:
        """Save a stack trace of student code that has taken too long, and exit this process.

        The runner then shows the student where the code was stuck, and starts another process for
        the remaining checks.
        """
        self.stack_file.write_text(
            self.template.stack() or "the worker wrote no stack", encoding="utf-8"
        )
        os._exit(1)  # then the template ends, and its worker too


def _exit_with_parent() -> None:
    """Exit as soon as standard input closes, which means that the grader's process has ended.

    Otherwise this process would keep running after the grader was killed.
    """
    while os.read(0, 1024):
        pass
    os._exit(1)
