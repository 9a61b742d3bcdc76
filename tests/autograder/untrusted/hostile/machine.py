"""What a machine is like around a run: its files, its processes, and the services on it."""

from __future__ import annotations

import contextlib
import hashlib
import os
import socket
import stat
import threading
from pathlib import Path

from corpus import TOKENS, World

# Where attacks leave files that begin with "hostile-", if nothing stops them.
OPEN_FOLDERS = ("/tmp", "/var/tmp", "/dev/shm", "/run/lock")
SEGMENT = "0x00048ac5"  # the key of the shared memory that the attack system_v_memory makes


class Services:
    """The servers that attacks try to reach. They answer any message with a token."""

    def __init__(self, home: Path, run: str) -> None:
        self.heard: list[bytes] = []
        tcp, udp = socket.socket(), socket.socket(type=socket.SOCK_DGRAM)
        file, abstract = socket.socket(socket.AF_UNIX), socket.socket(socket.AF_UNIX)
        tcp.bind(("127.0.0.1", 0))
        udp.bind(("127.0.0.1", 0))
        with contextlib.chdir(home):  # the path of a socket must be short
            file.bind("service")
        abstract.bind(f"\0hostile-{run}")
        self.tcp, self.udp = tcp.getsockname()[1], udp.getsockname()[1]
        datagrams = [udp]
        with contextlib.suppress(OSError):  # where there is IPv6
            udp6 = socket.socket(socket.AF_INET6, socket.SOCK_DGRAM)
            udp6.bind(("::1", self.udp))
            datagrams.append(udp6)
        for server in (tcp, file, abstract):
            server.listen()
            threading.Thread(target=self._serve, args=[server], daemon=True).start()
        for server in datagrams:
            threading.Thread(target=self._receive, args=[server], daemon=True).start()

    def _receive(self, server: socket.socket) -> None:
        while True:
            self.heard.append(server.recv(1000))

    def _serve(self, server: socket.socket) -> None:
        while True:
            with contextlib.suppress(OSError), server.accept()[0] as connection:
                connection.settimeout(0.5)
                self.heard.append(connection.recv(1000))
                connection.sendall(TOKENS["the network"].encode())


def snapshot(world: World) -> dict[str, str]:
    """Return what every file outside the box is like, and what lies in folders open to all."""
    found = {}
    for place in (world.root, world.submissions, world.home):
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


def status_of(pid: int) -> list[str]:
    """Return the state of a process, its parent and more; where it has ended, that it is gone."""
    with contextlib.suppress(OSError):
        text = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8")
        return text.rpartition(")")[2].split()
    return ["Z", "0"]


def descendants() -> set[int]:
    pids = [int(path.name) for path in Path("/proc").glob("[0-9]*")]
    parents = {pid: int(status_of(pid)[1]) for pid in pids}
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
        command = Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ")
        return "" if status_of(pid)[0] == "Z" else f"{pid} {command[:200]!r}"
    return ""
