"""The page for marking and the lab, killed at random moments while they are in use.

KILLS=40 in the environment kills each of them so often, in place of once.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from http.client import HTTPException
from pathlib import Path
from random import Random
from typing import Any
from urllib.parse import urlsplit
from urllib.request import Request, urlopen

import pytest
from tornado.httpclient import HTTPClientError
from tornado.iostream import StreamClosedError
from tornado.websocket import WebSocketClosedError, websocket_connect

from autograder.manifest import ROOT
from killed import MARK, survivors

KILLS = int(os.environ.get("KILLS", "1"))
SEED = int(os.environ.get("KILL_SEED", "1"))
GONE = (OSError, HTTPException, HTTPClientError, StreamClosedError, WebSocketClosedError)


@contextlib.contextmanager
def killed_after(seconds: float, *command: str) -> Iterator[str]:
    """Start a server, yield its address, and kill it after so long. Nothing of it remains."""
    mark = os.urandom(8).hex()
    process = subprocess.Popen(
        [sys.executable, "-m", *command, "--no-browser"],
        cwd=ROOT,
        env=os.environ | {MARK: mark},
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    assert process.stdout
    address = process.stdout.readline().split()[-1]
    timer = threading.Timer(seconds, process.send_signal, [signal.SIGKILL])
    timer.start()
    try:
        yield address
    finally:
        timer.join()
        process.wait()
        process.stdout.close()
    assert survivors(mark, patience=15.0) == []


def ask(address: str, path: str, sent: Any = None) -> Any:
    """Return what the server answers to a GET, or to a POST of something."""
    where = urlsplit(address)
    headers = {"Content-Type": "application/json", "Origin": f"http://{where.netloc}"}
    data = None if sent is None else json.dumps(sent).encode()
    with urlopen(Request(address + path, data, headers), timeout=10.0) as answer:
        return json.loads(answer.read())


def test_no_saved_mark_is_lost_when_the_page_is_killed(tmp_path: Path) -> None:
    for student in ("ann", "bob", "cem"):
        (tmp_path / student / "ch02_vectors").mkdir(parents=True)
        shutil.copy(ROOT / "chapters/ch02_vectors/answers.md", tmp_path / student / "ch02_vectors")
    rng = Random(SEED)
    command = ("autograder", "mark", str(tmp_path), "--chapters", "2")
    saved: dict[str, Any] = {}
    asked: tuple[str, Any] | None = None  # without an answer, so it may be saved or not
    changes = 0
    for _ in range(KILLS + 1):
        with killed_after(rng.uniform(0.1, 0.4), *command) as address, contextlib.suppress(*GONE):
            codes = [a["code"] for a in ask(address, "questions.json")["questions"][0]["answers"]]
            known = ask(address, "marks.json")["marks"]["2.2b"]
            if asked:
                assert known in (saved, {**saved, asked[0]: asked[1]})
            saved, asked = known, None
            while True:
                code = rng.choice(codes)
                points, comment = rng.choice([0.0, 0.5, 1.0]), "x" * rng.randrange(3000)
                mark = {"points": points, "comment": comment, "changed": False}
                asked = (code, mark)
                sent = {"exercise": "2.2b", "code": code, "mark": mark, "seen": saved.get(code)}
                saved = ask(address, "marks.json", sent)["marks"]["2.2b"]
                assert saved[code] == mark
                changes += 1
    assert changes
    print(f"mark: killed {KILLS + 1} times, {changes} marks were saved")


def test_nothing_remains_of_a_lab_that_is_killed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No engine outlives it. The engines remove the files that the lab has made for them."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    rng = Random(SEED)
    frames = 0

    async def play(address: str) -> None:
        nonlocal frames
        socket = await websocket_connect(f"{address.replace('http', 'ws', 1)}engine")
        message = {"kind": "load", "scene": "one-spring", "values": {}, "peer": ""}
        await socket.write_message(json.dumps(message))
        while (answer := await socket.read_message()) is not None:
            if json.loads(answer)["kind"] == "frame":
                frames += 1
                await socket.write_message('{"kind": "run", "frames": 1}')

    async def use(address: str) -> None:
        await asyncio.gather(*(play(address) for _ in range(2)))

    command = ("lab", "serve", "--engine", "solutions")
    for number in range(KILLS):
        seconds = rng.uniform(0.0, 1.0) if number else 1.5
        with killed_after(seconds, *command) as address, contextlib.suppress(*GONE):
            if number % 4 == 3:
                ask(address, "record.gif?scene=one-spring")
            else:
                asyncio.run(use(address))
        if number == 0:  # later kills may come while an engine starts, or during a recording
            assert [*tmp_path.iterdir()] == []
    assert frames
    print(f"lab: killed {KILLS} times after {frames} frames")
