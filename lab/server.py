"""Serve the lab's web page, and run a separate engine process for each page that is open."""

from __future__ import annotations

import asyncio
import contextlib
import json
from pathlib import Path
from typing import Any

from tornado.web import Application, HTTPError
from tornado.websocket import WebSocketClosedError, WebSocketHandler
from watchfiles import awatch

from autograder.commands import find_engine
from autograder.local_server import Files, Handler, Site, is_own_page
from autograder.manifest import ROOT
from lab.catalog import entries, find
from lab.engine_process import EngineProcess, recording

PAGE = Path(__file__).parent / "page"
REFERENCE = "solutions"


class Lab(Site):
    """The lab's local website, with the engines it offers and the connections to all open pages."""

    def __init__(self, engine: str, given: str = "") -> None:
        super().__init__()
        self.given = given
        self.engines = {"yours": engine}
        if (ROOT / REFERENCE).is_dir() and Path(engine).resolve() != ROOT / REFERENCE:
            self.engines["reference"] = REFERENCE
        self.sockets: set[EngineSocket] = set()

    def application(self) -> Application:
        below, shared = f"/{self.token}", {"site": self}
        return Application(
            [
                (f"{below}/engine", EngineSocket, {"lab": self}),
                (f"{below}/scenes.json", Scenes, shared),
                (f"{below}/record.gif", Recording, shared),
                (f"{below}/(.*)", Files, {**shared, "path": str(PAGE)}),
            ],
            websocket_max_message_size=100_000,
        )

    async def watch(self) -> None:
        """Notify every open page when the student saves a file of their engine."""
        async for changes in awatch(find_engine(self.engines["yours"])[0]):
            files = sorted({Path(path).name for _, path in changes if path.endswith(".py")})
            for socket in list(self.sockets) if files else ():
                await socket.saved(files)


class Scenes(Handler):
    """A request handler that returns the scenes and engines for the page's menus as JSON."""

    site: Lab

    def get(self) -> None:
        scenes = [{"name": e.name, "title": e.title, "chapter": e.chapter} for e in entries()]
        self.write({"scenes": scenes, "engines": list(self.site.engines)})


class Recording(Handler):
    """A request handler that returns an animation of the scene and parameters of the query."""

    site: Lab

    async def get(self) -> None:
        query = {name: self.get_query_argument(name) for name in self.request.query_arguments}
        engine = self.site.engines["yours"]
        try:
            find(scene := query.pop("scene", ""))
            gif = await recording(engine, self.site.given, scene, query)
        except ValueError as error:
            self.set_status(400)
            self.set_header("Content-Type", "text/plain; charset=utf-8")
            self.write(str(error))
            return
        self.set_header("Content-Type", "image/gif")
        self.write(gif)


class EngineSocket(WebSocketHandler):
    """The WebSocket connection to one open page, which has its own engine process."""

    def initialize(self, lab: Lab) -> None:
        self.lab = lab
        self.engine: EngineProcess | None = None
        self.turn = asyncio.Lock()

    def prepare(self) -> None:
        self.lab.check_host(self.request)
        origin = self.request.headers.get("Origin")  # only browsers send this header
        if origin is not None and not self.check_origin(origin):
            raise HTTPError(403)

    def check_origin(self, origin: str) -> bool:
        """Accept a WebSocket request from a browser only if it comes from the lab's own page."""
        return is_own_page(self.request, origin)

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
        """Stop the engine process, and tell the page to reload its scene with the saved files."""
        if self.engine is not None and self.get_query_argument("engine", "yours") == "yours":
            async with self.turn:
                await self.engine.end()
            with contextlib.suppress(WebSocketClosedError):  # the page was closed meanwhile
                await self.write_message(json.dumps({"kind": "saved", "files": files}))

    def on_close(self) -> None:
        self.lab.sockets.discard(self)
        if self.engine is not None:
            self.ending = asyncio.ensure_future(self.engine.close())


async def serve(lab: Lab, port: int, ready: Any) -> None:
    """Serve the lab's page, and call ``ready`` with its address as soon as it can be opened."""
    lab.listen(lab.application(), port)
    ready(lab.address)
    await lab.watch()
