"""Messages and requests that the lab's page never sends, and what a stopped lab leaves behind."""

from __future__ import annotations

import asyncio
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from tornado.httpclient import HTTPClientError, HTTPRequest
from tornado.websocket import WebSocketClosedError, websocket_connect

from autograder.manifest import ROOT
from lab.child import answered
from lab.engine_process import EngineProcess
from lab.host import Host, Message
from lab.server import EngineSocket
from studies.reason import reason

LOAD = b'{"kind": "load", "scene": "one-spring", "values": {}, "peer": ""}'
RUN = b'{"kind": "run", "frames": 1}'
LARGE = 400 * b"9"


@pytest.fixture
def host() -> Host:
    host = Host(reason)
    answered(host, LOAD)
    return host


@pytest.mark.parametrize(
    "line",
    [b"hello", b"", b"\xff", b"\0", 20_000 * b"[", b'{"a":' + 5000 * b"9" + b"}", RUN + RUN],
    ids=["no JSON", "empty", "no text", "NUL", "nested", "long number", "two messages"],
)
def test_what_is_no_json_is_refused_and_the_scene_goes_on(host: Host, line: bytes) -> None:
    assert [json.loads(answer)["kind"] for answer in answered(host, line)] == ["refused"]
    assert json.loads(answered(host, RUN)[0])["time"] > 0.0


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        (b"[]", "stopped"),
        (b"null", "stopped"),
        (b'{"kind": "run", "frames": -5}', "frame"),
        (b'{"kind": "click", "x": NaN, "y": Infinity}', "frame"),
        (b'{"kind": "click", "x": %s, "y": 1}' % LARGE, "stopped"),
        (b'{"kind": "set", "name": "stiffness", "value": %s}' % LARGE, "refused"),
        (b'{"kind": "set", "name": "\\ud800", "value": 1}', "refused"),
        (b'{"kind": "load", "scene": "../x", "values": {}, "peer": ""}', "stopped"),
        (b'{"kind": "load", "scene": "one-spring", "values": {}, "peer": "__class__"}', "stopped"),
    ],
)
def test_every_other_message_gets_one_answer(host: Host, line: bytes, kind: str) -> None:
    assert [json.loads(answer)["kind"] for answer in answered(host, line)] == [kind]
    assert json.loads(answered(host, b'{"kind": "restart"}')[-1])["kind"] == "frame"


def test_an_answer_that_json_does_not_have_stops_the_scene(
    host: Host, monkeypatch: pytest.MonkeyPatch
) -> None:
    for value in (float("nan"), object()):
        monkeypatch.setattr(host, "_frame", lambda value=value: {"kind": "frame", "x": value})
        (answer,) = answered(host, RUN)
        assert json.loads(answer)["kind"] == "stopped"


def test_a_page_that_closes_while_a_file_is_saved_does_not_stop_the_lab() -> None:
    class Closed(EngineSocket):
        def __init__(self) -> None:
            self.engine = EngineProcess("solutions")
            self.turn = asyncio.Lock()

        def get_query_argument(self, *_: Any) -> str:
            return "yours"

        def write_message(self, *_: Any) -> Any:
            raise WebSocketClosedError

    socket = Closed()
    asyncio.run(socket.saved(["spring.py"]))
    assert socket.engine
    asyncio.run(socket.engine.close())


def test_an_answer_without_end_stops_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    async def talk() -> list[str]:
        engine = EngineProcess("solutions")
        try:
            return [answer async for answer in engine.ask(LOAD.decode())]
        finally:
            await engine.close()

    monkeypatch.setattr("lab.engine_process.LONGEST_LINE", 100)
    (stopped,) = asyncio.run(talk())
    assert "draws more than the lab can show" in json.loads(stopped)["why"]


def test_nothing_remains_of_a_lab_that_is_killed(tmp_path: Path) -> None:
    """Neither a process nor a file remains, and no request from elsewhere got an answer."""
    process = subprocess.Popen(
        [sys.executable, "-m", "lab", "serve", "--no-browser", "--engine", "solutions"],
        cwd=ROOT,
        env=os.environ | {"TMPDIR": str(tmp_path)},
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    assert process.stdout
    address = process.stdout.readline().split()[-1]

    async def talk() -> list[Message]:
        url = f"{address.replace('http', 'ws', 1)}engine"
        evil = "http://evil.example"
        for headers in (
            {"Origin": "http://["},
            {"Origin": evil, "Sec-Fetch-Site": "cross-site"},
            {"Origin": evil, "Sec-Fetch-Site": "same-origin"},
            {"Origin": evil, "Host": "evil.example"},  # a name that now leads to this machine
        ):
            with pytest.raises(HTTPClientError, match="403"):
                await websocket_connect(HTTPRequest(url, headers=headers))
        socket = await websocket_connect(url)
        for message in (LOAD, b"no JSON", RUN):
            await socket.write_message(message.decode())
        answers = [json.loads(str(await socket.read_message())) for _ in range(4)]
        other = await websocket_connect(url)
        await other.write_message(LOAD.decode())
        await other.read_message()
        other.close()
        for _ in range(100):
            if len([*tmp_path.iterdir()]) == 1:
                break
            await asyncio.sleep(0.02)
        assert len([*tmp_path.iterdir()]) == 1, "the files of a closed page are removed"
        process.send_signal(signal.SIGKILL)
        return answers

    answers = asyncio.run(talk())
    assert [answer["kind"] for answer in answers] == ["scene", "frame", "refused", "frame"]
    process.wait()
    process.stdout.close()
    deadline = time.monotonic() + 10.0
    while [*tmp_path.iterdir()] and time.monotonic() < deadline:
        time.sleep(0.02)
    assert [*tmp_path.iterdir()] == []
