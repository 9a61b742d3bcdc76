"""Run the engines of the site's pages in Node, with the page's own scripts and with Pyodide."""

from __future__ import annotations

import atexit
import json
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from autograder.manifest import ROOT, Chapter
from course_site import BELOW, built

_running: dict[Path, NodeEngines] = {}
SCRIPT = ROOT / "tests" / "web" / "engines.mjs"


class NodeEngines:
    def __init__(self, site: Path) -> None:
        self.process = subprocess.Popen(
            ["node", str(SCRIPT), str(site)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            encoding="utf-8",
        )

    def ask(self, what: str, **request: Any) -> dict[str, Any]:
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        print(json.dumps({"what": what, **request}), file=self.process.stdin, flush=True)
        answer: dict[str, Any] = json.loads(self.process.stdout.readline())
        return answer

    def check(
        self, files: dict[str, str], chapter: Chapter, exercise: str | None = None, **asked: Any
    ) -> dict[str, Any]:
        """Return the report on a chapter or an exercise, as the page receives it."""
        asked |= {"files": files, "chapter": chapter.name, "exercise": exercise}
        answer = self.ask("check", asked=asked)
        assert "report" in answer, answer.get("error")
        report: dict[str, Any] = answer["report"]
        return report

    def scene(self, link: int, kind: str, **message: Any) -> list[dict[str, Any]]:
        answers: list[dict[str, Any]] = self.ask(
            "scene", link=link, message={"kind": kind, **message}
        )["answers"]
        return answers

    def close(self) -> None:
        self.process.stdin.close()
        self.process.wait()


def engines(tmp_path_factory: pytest.TempPathFactory) -> NodeEngines:
    """Return the engines of the site, for a fixture. All tests share one process."""
    site = built(tmp_path_factory) / BELOW
    if site not in _running:
        _running[site] = NodeEngines(site)
        atexit.register(_running[site].close)
    return _running[site]


def engines_of(site: Path) -> Iterator[NodeEngines]:
    engines = NodeEngines(site)
    yield engines
    engines.close()
