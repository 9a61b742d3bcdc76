"""Run several scenes of a page in one Python interpreter, each with its own engine.

The modules of all engines have the same names. For each scene, a Link keeps the modules that the
scene has imported. It adds them to sys.modules for each message, and removes them afterward.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from types import ModuleType

from autograder.accepted_files import rejected_modules
from autograder.at_home.restrictions import graded_files
from autograder.diagnosis.earlier_chapters import with_given
from autograder.manifest import load_chapters
from lab.broken_off import FIRST_LIMIT, TIME_LIMIT, why_it_broke_off
from lab.host import Host, Message
from scenes.engine import rejected
from scenes.reason import reason
from web.python.browser.folder import CHAPTERS, Folder
from web.python.browser.process import SHALLOW, code, forget_folders
from web.python.browser.watchdog import watchdog

NOT_HERE = {"pymunk": "pymunk is not available in the browser."}
# An engine's modules, and their importers.
OF_A_LINK = re.compile(r"(ch\d\d_|(lab|plots|scenes|studies)\.)")
SHARED = set(sys.modules)  # modules that all links share


class Link:
    """The connection between a scene on the page and the engine that runs the scene."""

    def __init__(self, folder: Folder) -> None:
        self.folder = folder
        self.host = Host(reason)
        self.modules: dict[str, ModuleType] = {}
        self.engine: list[Path] = []
        self.known: tuple[list[Path], dict[str, list[str]], list[str]] = ([], {}, [])
        self.rejected: dict[str, str] = {}
        self.loaded: tuple[dict[str, str], list[int]] | None = None
        self.given = ExitStack()  # the reference's modules, kept until the link is closed

    def receive(self, message: Message) -> list[Message]:
        """Answer a message about this scene. A message that loads it has the student's files."""
        limit = TIME_LIMIT
        try:
            if message.get("kind") == "load":
                limit = FIRST_LIMIT
                if why := NOT_HERE.get(message.get("peer", "")):
                    return [{"kind": "stopped", "why": why}]
                self._choose(message.pop("files"), message.pop("given"))
            watchdog.explain = lambda stack: {"why": why_it_broke_off(stack, self.engine, limit)}
            watchdog.start(limit)
            with self._at_work():
                return self.host.receive(message)
        except (ValueError, OSError) as error:  # for example, a chapter that cannot be given
            return [{"kind": "stopped", "why": str(error)}]
        finally:
            watchdog.stop()

    def close(self) -> None:
        """Delete the temporary folders of this scene's engine."""
        self.given.close()

    def _choose(self, files: dict[str, str], numbers: list[int]) -> None:
        """Build the engine from the student's files, with skipped chapters from the reference."""
        if self.loaded == (files, numbers):
            return
        self.loaded = None
        self.close()
        self.modules, self.host = {}, Host(reason)
        self.folder.lay(files)
        forget_folders()
        chapters = load_chapters()
        given = [chapter for chapter in chapters if chapter.number in numbers]
        self.engine = self.given.enter_context(with_given(given, [CHAPTERS]))
        ours = [f"{chapter.name}/{file}" for chapter in chapters for file in chapter.complete]
        self.known = self.engine, graded_files(chapters), ours
        self.rejected = rejected_modules(chapters, self.engine)
        self.loaded = files, numbers

    @contextmanager
    def _at_work(self) -> Iterator[None]:
        """Make the scene's engine importable in a with block, under the usual limits."""
        code.change(*self.known)
        rejected.reasons = self.rejected
        sys.setrecursionlimit(SHALLOW)
        path, sys.path = sys.path, [*sys.path, *map(str, self.engine)]
        sys.dont_write_bytecode = True  # stale bytecode could hide a quick change
        sys.modules.update(self.modules)
        try:
            yield
        finally:
            sys.path = path
            sys.dont_write_bytecode = False
            for name in [name for name in sys.modules if OF_A_LINK.match(name)]:
                if name not in SHARED:
                    self.modules[name] = sys.modules.pop(name)
