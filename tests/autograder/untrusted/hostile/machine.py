"""What a machine is like around a run: its files, its processes, and the services on it."""

from __future__ import annotations

import contextlib
import hashlib
import os
import selectors
import socket
import stat
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from corpus import TOKENS, World

# Where attacks leave files that begin with "hostile-", if nothing stops them.
OPEN_FOLDERS = ("/tmp", "/var/tmp", "/dev/shm", "/run/lock")
SEGMENT = "0x00048ac5"  # the key of the shared memory that the attack system_v_memory makes


class Services:
    """What attacks try to talk to: it hands a token to whoever sends something."""

    def __init__(self, home: Path, run: str) -> None:
        self.heard: list[bytes] = []
        tcp, udp = socket.socket(), socket.socket(type=socket.SOCK_DGRAM)
        file, abstract = socket.socket(socket.AF_UNIX), socket.socket(socket.AF_UNIX)
        tcp.bind(("127.0.0.1", 0))
        udp.bind(("127.0.0.1", 0))
        with _inside(home):  # the path of a socket must be short
            file.bind("service")
        abstract.bind(f"\0hostile-{run}")
        self.tcp, self.udp = tcp.getsockname()[1], udp.getsockname()[1]
        self._datagrams = [udp]
        with contextlib.suppress(OSError):  # where there is IPv6
            udp6 = socket.socket(socket.AF_INET6, socket.SOCK_DGRAM)
            udp6.bind(("::1", self.udp))
            self._datagrams.append(udp6)
        self._listening = [tcp, file, abstract]
        for server in self._listening:
            server.listen()
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def _serve(self) -> None:
        selector = selectors.DefaultSelector()
        for server in (*self._listening, *self._datagrams):
            selector.register(server, selectors.EVENT_READ)
        while not self._stop.is_set():
            for key, _ in selector.select(0.1):
                server: Any = key.fileobj
                if server in self._datagrams:
                    self.heard.append(server.recv(1000))
                    continue
                with contextlib.suppress(OSError):
                    connection, _ = server.accept()
                    with connection:
                        connection.settimeout(0.5)
                        self.heard.append(connection.recv(1000))
                        connection.sendall(TOKENS["the network"].encode())

    def close(self) -> None:
        self._stop.set()
        self._thread.join()
        for server in (*self._listening, *self._datagrams):
            server.close()


@contextlib.contextmanager
def _inside(folder: Path) -> Iterator[None]:
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)


def snapshot(world: World) -> dict[str, str]:
    """Return what every file outside the box is like, and what lies in folders open to all."""
    found = {}
    for place in (world.root, world.submissions, world.home, world.base / "kept"):
        for path in (place, *place.rglob("*")) if place.exists() else ():
            if {"__pycache__", ".pytest_cache"} & {*path.parts}:
                continue
            status = path.lstat()
            kind = stat.S_IFMT(status.st_mode)
            about = f"{status.st_mode:o} {status.st_uid} {status.st_gid}"
            if kind == stat.S_IFREG:
                with path.open("rb") as file:
                    digest = hashlib.file_digest(file, "sha256").hexdigest()
                about += f" {status.st_size} {status.st_mtime_ns} {os.listxattr(path)} {digest}"
            elif kind == stat.S_IFLNK:
                about += f" {path.readlink()}"
            found[str(path)] = about
    for path in world.temporary.iterdir():
        found[str(path)] = "in the folder for temporary files"
    for folder in OPEN_FOLDERS:
        for path in Path(folder).glob("hostile-*"):
            if path != world.base:
                found[str(path)] = "in a folder open to all"
    if SEGMENT in shared_memory():
        found["shared memory"] = SEGMENT
    return found


def shared_memory() -> str:
    """Return the table of shared memory, with keys as other tools write them."""
    with contextlib.suppress(OSError):
        rows = Path("/proc/sysvipc/shm").read_text(encoding="utf-8").splitlines()[1:]
        return " ".join(f"0x{int(row.split()[0]) & 0xFFFFFFFF:08x}" for row in rows)
    return ""


def descendants() -> set[int]:
    """Return our children, theirs, and so on."""
    parents: dict[int, int] = {}
    for path in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            parents[int(path.parent.name)] = int(
                path.read_text(encoding="utf-8").rpartition(")")[2].split()[1]
            )
    found = {os.getpid()}
    while new := {pid for pid, parent in parents.items() if parent in found} - found:
        found |= new
    return found - {os.getpid()}


def bearing_the_mark_of(world: World) -> set[int]:
    """Return the processes that have the environment of this run's grader."""
    found, mark = set(), f"HOSTILE_RUN={world.run}"
    for path in Path("/proc").glob("[0-9]*/environ"):
        with contextlib.suppress(OSError):
            if mark.encode() in path.read_bytes():
                found.add(int(path.parent.name))
    return found


def process_name(pid: int) -> str:
    """Return what a process is; nothing where it has ended."""
    with contextlib.suppress(OSError):
        state = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0]
        command = Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ")
        return "" if state == "Z" else f"{pid} {command[:200]!r}"
    return ""
