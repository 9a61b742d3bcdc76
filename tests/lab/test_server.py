"""The server answers only its own page and survives the faults of a student's code."""

from __future__ import annotations

import asyncio
import json
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tornado.httpclient import AsyncHTTPClient, HTTPClientError, HTTPRequest, HTTPResponse
from tornado.websocket import websocket_connect

from autograder.manifest import ROOT, load_chapters
from copies import copy_tree
from served import served
from wrong import Wrong, write_wrong

LOAD = {"kind": "load", "scene": "one-spring", "values": {}, "peer": ""}


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    with served() as address:
        yield address


def get(address: str, **headers: str) -> HTTPResponse:
    """Fetch a page. An error status is returned as a response, too."""

    async def fetch() -> HTTPResponse:
        request = HTTPRequest(address, headers=headers)
        return await AsyncHTTPClient().fetch(request, raise_error=False)

    return asyncio.run(fetch())


def talk(address: str, *messages: dict[str, Any], engine: str = "yours") -> list[dict[str, Any]]:
    """Return all answers to messages. Every answer except "scene" is the last one of a message."""

    async def ask() -> list[dict[str, Any]]:
        url = f"{address.replace('http', 'ws', 1)}engine?engine={engine}"
        socket = await websocket_connect(HTTPRequest(url, headers={"Origin": address[:-24]}))
        answers = []
        for message in messages:
            await socket.write_message(json.dumps(message))
            while True:
                answers.append(json.loads(await socket.read_message()))
                if answers[-1]["kind"] != "scene":
                    break
        socket.close()
        return answers

    return asyncio.run(ask())


def test_the_page_and_its_files_are_served(address: str) -> None:
    page = get(address)
    assert page.code == 200
    assert b"<title>The lab</title>" in page.body
    assert "default-src 'self'" in page.headers["Content-Security-Policy"]
    for file in ("main.js", "styles/style.css", "vendor/uPlot.iife.min.js", "scenes.json"):
        assert get(address + file).code == 200, file


def test_without_the_token_there_is_nothing(address: str) -> None:
    top = address.rsplit("/", 2)[0]
    for path in ("/", "/index.html", "/main.js", "/engine", "/guess/"):
        assert get(top + path).code == 404, path


@pytest.mark.parametrize("path", ["../server.py", "%2e%2e/server.py", "vendor/../../server.py"])
def test_no_file_beside_the_page_is_served(address: str, path: str) -> None:
    assert get(address + path).code in (403, 404)


def test_another_host_is_refused(address: str) -> None:
    assert get(address, Host="evil.example").code == 403
    assert get(address + "scenes.json", Host="evil.example:80").code == 403


def test_a_socket_from_another_origin_is_refused(address: str) -> None:
    async def connect(**headers: str) -> None:
        url = address.replace("http", "ws", 1) + "engine"
        (await websocket_connect(HTTPRequest(url, headers=headers))).close()

    evil = "http://evil.example"
    for headers in (
        {"Origin": evil},
        {"Origin": "http://127.0.0.1:1"},
        {"Origin": "null"},
        {"Origin": "http://["},
        {"Origin": evil, "Sec-Fetch-Site": "same-origin"},
        {"Origin": evil, "Host": "evil.example"},  # a name that now leads to this machine
    ):
        with pytest.raises(HTTPClientError, match="403"):
            asyncio.run(connect(**headers))
    asyncio.run(connect(Origin=address.rsplit("/", 2)[0]))


def test_an_engine_plays_a_scene(address: str) -> None:
    scene, start, later = talk(address, LOAD, {"kind": "run", "frames": 30})
    assert scene["title"]
    assert (start["time"], later["time"]) == (0.0, pytest.approx(0.5))


ENDINGS = {
    "while True: pass": "forces.py, line",  # the position of the loop
    "import os; os._exit(3)": "ended on its own",
    "raise ValueError('no force today')": "no force today",
}


@pytest.mark.parametrize(("body", "words"), ENDINGS.items(), ids=ENDINGS.keys())
def test_code_that_hangs_or_dies_ends_itself_alone(body: str, words: str, tmp_path: Path) -> None:
    """The page gets an answer within three seconds, and the socket can load the next scene."""
    chapter = next(chapter for chapter in load_chapters() if chapter.name == "ch05_forces")
    copy_tree(ROOT / "solutions", tmp_path)
    wrong = Wrong("forces.ForceRegistry.update_forces", "", "", body=body)
    write_wrong(chapter, [wrong], tmp_path)
    with served(engine=str(tmp_path)) as address:
        started = time.monotonic()
        _, _, stopped = talk(address, LOAD, {"kind": "run", "frames": 1})
        assert time.monotonic() - started < 6.0  # including up to three to start the engine
        assert stopped["kind"] == "stopped"
        assert words in stopped["why"]
        assert talk(address, LOAD, engine="reference")[-1]["kind"] == "frame"


# The lab waits for a moment until an engine has ended, because its child keeps the pipe open.
LEAVES_A_CHILD = """
import ctypes, os, time

if ctypes.CDLL(None).fork() == 0:
    time.sleep(3)
    os._exit(0)
"""


def test_pages_that_close_leave_no_file_and_do_not_stop_the_lab(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They close while the lab tells one page after the other that a file was saved."""
    engine, temporary = tmp_path / "engine", tmp_path / "temporary"
    copy_tree(ROOT / "solutions", engine)
    temporary.mkdir()
    monkeypatch.setenv("TMPDIR", str(temporary))
    springs = engine / "ch06_springs/springs.py"
    with springs.open("a", encoding="utf-8") as file:
        file.write(LEAVES_A_CHILD)

    async def opened(address: str) -> Any:
        socket = await websocket_connect(address)
        await socket.write_message(json.dumps(LOAD))
        for _ in ("scene", "frame"):
            await asyncio.wait_for(socket.read_message(), 30.0)
        return socket

    async def use(address: str) -> None:
        sockets = [await opened(address), await opened(address)]
        springs.touch()
        heard = [asyncio.ensure_future(socket.read_message()) for socket in sockets]
        await asyncio.wait(heard, return_when=asyncio.FIRST_COMPLETED, timeout=10.0)
        first = 0 if heard[0].done() else 1
        sockets[1 - first].close()
        springs.touch()
        assert await asyncio.wait_for(sockets[first].read_message(), 10.0)
        sockets[first].close()
        for _ in range(100):
            if not [*temporary.iterdir()]:
                break
            await asyncio.sleep(0.05)

    with served(engine=str(engine)) as address:
        asyncio.run(use(address.replace("http", "ws", 1) + "engine"))
        assert [*temporary.iterdir()] == []
        assert get(address).code == 200
