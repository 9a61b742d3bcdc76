"""The course's site, which is built once for all processes of a test run and served locally."""

from __future__ import annotations

import contextlib
import fcntl
import functools
import io
import json
import lzma
import os
import shutil
import threading
import zipfile
import zlib
from collections.abc import Callable, Iterator
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

from browser import need
from web.__main__ import build
from web.node import missing
from web.pack import pack

BELOW = "some/where"  # the site must work from any path


def built(factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the site below BELOW, which the first process builds."""
    need(missing())
    return _made_once(factory, "site", functools.partial(build, with_solutions=False))


def built_with_solutions(factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the same pages, but with the pack that `make site SOLUTIONS=1` makes."""
    site = built(factory) / BELOW

    def make(below: Path) -> None:
        shutil.copytree(site, below)
        pack(below, with_solutions=True)
        course = {**data_in(below, "course"), "solutions": True}
        file = below / "data" / "course.data"
        file.write_bytes(zlib.compress(json.dumps(course).encode()))

    return _made_once(factory, "site-with-solutions", make)


def data_in(site: Path, name: str) -> dict[str, Any]:
    """Return the data of a site about the course, or about one chapter."""
    data: dict[str, Any] = json.loads(
        zlib.decompress((site / "data" / f"{name}.data").read_bytes())
    )
    return data


def pack_in(site: Path) -> zipfile.ZipFile:
    return zipfile.ZipFile(io.BytesIO(lzma.decompress((site / "course.xz").read_bytes())))


def _made_once(factory: pytest.TempPathFactory, name: str, make: Callable[[Path], object]) -> Path:
    """Return a folder that all processes share. The first process fills the part below BELOW."""
    shared = factory.getbasetemp()
    if os.environ.get("PYTEST_XDIST_WORKER"):
        shared = shared.parent
    folder = shared / name
    with (shared / f"{name}.lock").open("w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not folder.exists():
            part = shared / f"{name}.part"
            make(part / BELOW)
            part.rename(folder)
    return folder


class Quiet(SimpleHTTPRequestHandler):
    """Serves files without printing a log."""

    def log_message(self, *_: object) -> None:
        """Print nothing."""

    def copyfile(self, source: Any, outputfile: Any) -> None:
        """Send a file. Ignore the error if the page that requested it has been closed."""
        with contextlib.suppress(ConnectionError):
            super().copyfile(source, outputfile)


class Served:
    """A server for a folder, which can be stopped and started again at the same address."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.port = 0
        self.start()

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.port}/{BELOW}/"

    def start(self) -> None:
        handler = functools.partial(Quiet, directory=str(self.folder))
        self.server = ThreadingHTTPServer(("127.0.0.1", self.port), handler)
        self.port = self.server.server_address[1]
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def stop(self) -> None:
        """Stop the server, so that requests are no longer answered."""
        self.server.shutdown()
        self.server.server_close()


def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    with served_site(built(tmp_path_factory)) as server:
        yield server


@contextlib.contextmanager
def served_site(folder: Path) -> Iterator[Served]:
    """Yield a server of a folder that ``built`` has returned."""
    server = Served(folder)
    try:
        yield server
    finally:
        server.stop()
