"""The lab's web server. It serves the page and connects each open page to an engine.

It listens on 127.0.0.1 only. Every address begins with a random token, so that other pages and
other users of the machine cannot guess it. The server rejects requests for another host and
sockets opened by a page from another origin.
"""

from __future__ import annotations

import asyncio
import json
import secrets
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from tornado.httpserver import HTTPServer
from tornado.httputil import HTTPServerRequest
from tornado.netutil import bind_sockets
from tornado.web import Application, HTTPError, RequestHandler, StaticFileHandler
from tornado.websocket import WebSocketClosedError, WebSocketHandler
from watchfiles import awatch

from autograder.commands import find_engine
from autograder.manifest import ROOT
from lab.catalog import entries, find
from lab.engine_process import EngineProcess, recording

PAGE = Path(__file__).parent / "page"
REFERENCE = "solutions"
# The page may load files from this server only, and no other page may embed it.
POLICY = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:"
HEADERS = {
    "Content-Security-Policy": f"{POLICY}; frame-ancestors 'none'; base-uri 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-store",
}


class Lab:
    """The state that all handlers share: the available engines and the open sockets."""

    def __init__(self, engine: str, given: str = "") -> None:
        self.token = secrets.token_urlsafe(16)
        self.given = given
        self.engines = {"yours": engine}
        if (ROOT / REFERENCE).is_dir() and Path(engine).resolve() != ROOT / REFERENCE:
            self.engines["reference"] = REFERENCE
        self.sockets: set[EngineSocket] = set()
        self.port = 0

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.port}/{self.token}/"

    def application(self) -> Application:
        """Return the tornado application."""
        below, shared = f"/{self.token}", {"lab": self}
        return Application(
            [
                (f"{below}/engine", EngineSocket, shared),
                (f"{below}/scenes.json", Scenes, shared),
                (f"{below}/record.gif", Recording, shared),
                (
                    f"{below}/(.*)",
                    Files,
                    {**shared, "path": str(PAGE), "default_filename": "index.html"},
                ),
            ],
            websocket_max_message_size=100_000,
        )

    def check_host(self, request: HTTPServerRequest) -> None:
        """Reject a request for another host name, which a hostile site may have directed here."""
        if request.host not in (f"127.0.0.1:{self.port}", f"localhost:{self.port}"):
            raise HTTPError(403)

    async def watch(self) -> None:
        """Notify every page when a file of the student's engine is saved."""
        async for changes in awatch(find_engine(self.engines["yours"])[0]):
            files = sorted({Path(path).name for _, path in changes if path.endswith(".py")})
            for socket in list(self.sockets) if files else ():
                await socket.saved(files)


class Files(StaticFileHandler):
    """The page and its files."""

    def initialize(self, lab: Lab, path: str, default_filename: str) -> None:  # type: ignore[override]
        self.lab = lab
        super().initialize(path, default_filename)

    def prepare(self) -> None:
        self.lab.check_host(self.request)

    def set_extra_headers(self, path: str) -> None:  # noqa: ARG002 - tornado's signature
        for name, value in HEADERS.items():
            self.set_header(name, value)


class Scenes(RequestHandler):
    """The list of scenes and engines. It is available without importing an engine."""

    def initialize(self, lab: Lab) -> None:
        self.lab = lab

    def prepare(self) -> None:
        self.lab.check_host(self.request)

    def get(self) -> None:
        for name, value in HEADERS.items():
            self.set_header(name, value)
        scenes = [{"name": e.name, "title": e.title, "chapter": e.chapter} for e in entries()]
        self.write({"scenes": scenes, "engines": list(self.lab.engines)})


class Recording(RequestHandler):
    """An animation of a scene with the parameters in the query."""

    def initialize(self, lab: Lab) -> None:
        self.lab = lab

    def prepare(self) -> None:
        self.lab.check_host(self.request)

    async def get(self) -> None:
        query = {name: self.get_query_argument(name) for name in self.request.query_arguments}
        engine = self.lab.engines["yours"]
        try:
            find(scene := query.pop("scene", ""))
            gif = await recording(engine, self.lab.given, scene, query)
        except ValueError as error:
            self.set_status(400)
            self.set_header("Content-Type", "text/plain; charset=utf-8")
            self.write(str(error))
            return
        self.set_header("Content-Type", "image/gif")
        self.write(gif)


class EngineSocket(WebSocketHandler):
    """A WebSocket with its own engine process."""

    def initialize(self, lab: Lab) -> None:
        self.lab = lab
        self.engine: EngineProcess | None = None
        self.turn = asyncio.Lock()

    def prepare(self) -> None:
        self.lab.check_host(self.request)

    def check_origin(self, origin: str) -> bool:
        """Accept only sockets that the lab's own page opens."""
        return urlsplit(origin).netloc == self.request.host

    def open(self) -> None:
        engine = self.get_query_argument("engine", "yours")
        if engine not in self.lab.engines:
            self.close(1008, "no such engine")
            return
        given = self.lab.given if engine == "yours" else ""
        self.engine = EngineProcess(self.lab.engines[engine], given)
        self.lab.sockets.add(self)

    async def on_message(self, message: str | bytes) -> None:
        if self.engine is None or not isinstance(message, str) or "\n" in message:
            return
        async with self.turn:
            try:
                async for answer in self.engine.ask(message):
                    await self.write_message(answer)
            except WebSocketClosedError:
                pass

    async def saved(self, files: list[str]) -> None:
        """Stop the old engine and notify the page, which then reloads its scene."""
        if self.engine is not None and self.get_query_argument("engine", "yours") == "yours":
            async with self.turn:
                await self.engine.end()
            await self.write_message(json.dumps({"kind": "saved", "files": files}))

    def on_close(self) -> None:
        self.lab.sockets.discard(self)
        if self.engine is not None:
            self.ending = asyncio.ensure_future(self.engine.end())


async def serve(lab: Lab, port: int, ready: Any) -> None:
    """Serve until Ctrl-C. Calls ``ready`` with the address once the server is listening."""
    sockets = bind_sockets(port, "127.0.0.1")
    lab.port = sockets[0].getsockname()[1]
    server = HTTPServer(lab.application())
    server.add_sockets(sockets)
    ready(lab.address)
    await lab.watch()
