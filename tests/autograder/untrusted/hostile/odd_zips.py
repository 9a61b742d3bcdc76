"""Submissions that are zips, of all sorts."""

from __future__ import annotations

import io
import os
import stat
import struct
import zipfile
from pathlib import Path

from corpus import IDLE, RIGHT, World
from odd_files import SUMS, odd


def zipped(at: Path, entries: list[tuple[str | zipfile.ZipInfo, str]]) -> Path:
    """Write a zip in the place of the folder; return its path."""
    path = at.with_name(at.name + ".zip")
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in entries:
            file.writestr(name, content)
    return path


@odd("An ordinary zip.", "all")
def zip_right(at: Path, world: World) -> None:  # noqa: ARG001
    zipped(at, [("work/" + SUMS, RIGHT), ("work/readme.txt", "nothing")])


@odd("A zip of nothing.", "nothing")
def zip_empty(at: Path, world: World) -> None:  # noqa: ARG001
    zipped(at, [])


@odd("A file without a byte, called a zip.", "nothing")
def zip_of_no_bytes(at: Path, world: World) -> None:  # noqa: ARG001
    at.with_name(at.name + ".zip").touch()


@odd("A zip with its middle spoiled.", "nothing")
def zip_corrupt(at: Path, world: World) -> None:  # noqa: ARG001
    path = zipped(at, [(SUMS, RIGHT)])
    data = bytearray(path.read_bytes())
    data[60:120] = os.urandom(60)
    path.write_bytes(data)


@odd("The first half of a zip.", "nothing")
def zip_cut(at: Path, world: World) -> None:  # noqa: ARG001
    path = zipped(at, [(SUMS, RIGHT)])
    path.write_bytes(path.read_bytes()[:150])


@odd("A zip in which a small file becomes 200 megabytes.", "nothing")
def zip_bomb(at: Path, world: World) -> None:  # noqa: ARG001
    path = at.with_name(at.name + ".zip")
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file, file.open(SUMS, "w") as entry:
        for _ in range(200):
            entry.write(b"\n" * 1_000_000)


@odd("A zip that says that its 20 megabytes are a few bytes.", "nothing")
def zip_lies_about_size(at: Path, world: World) -> None:  # noqa: ARG001
    path = zipped(at, [(SUMS, RIGHT + "\n" * 20_000_000)])
    data = bytearray(path.read_bytes())
    struct.pack_into("<L", data, 22, 500)
    struct.pack_into("<L", data, data.rindex(b"PK\1\2") + 24, 500)
    path.write_bytes(data)


@odd("A zip that says that it has many more entries than it has.", "nothing")
def zip_lies_about_count(at: Path, world: World) -> None:  # noqa: ARG001
    path = zipped(at, [(SUMS, IDLE)])
    data = bytearray(path.read_bytes())
    struct.pack_into("<2H", data, data.rindex(b"PK\5\6") + 8, 60_000, 60_000)
    path.write_bytes(data)


@odd("A zip with paths that climb out of the folder.", "nothing")
def zip_climbs(at: Path, world: World) -> None:  # noqa: ARG001
    above = [("../" * depth + "hostile-climbed", "climbed") for depth in range(1, 6)]
    solution = ("../../root/solutions/" + SUMS, "spoiled")
    zipped(at, [*above, solution, ("..\\..\\hostile-climbed", "climbed"), (SUMS, IDLE)])


@odd("A zip with absolute paths.", "nothing")
def zip_absolute(at: Path, world: World) -> None:
    paths = (
        world.home / "hostile-climbed",
        world.root / "tests/shared/expect.py",
        world.root / SUMS,
    )
    zipped(at, [*((str(path), "climbed") for path in paths), (SUMS, IDLE)])


@odd("A zip in which sums.py is a link to the solution.", "nothing")
def zip_link(at: Path, world: World) -> None:
    entry = zipfile.ZipInfo(SUMS)
    entry.create_system, entry.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    zipped(at, [(entry, str(world.root / "solutions" / SUMS))])


@odd("A zip with a link to the solutions, and a file below the link.", "nothing")
def zip_linked_folder(at: Path, world: World) -> None:
    entry = zipfile.ZipInfo("ch90_sums")
    entry.create_system, entry.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    zipped(at, [(entry, str(world.root / "solutions/ch90_sums")), (SUMS, IDLE)])


@odd("A zip with a hundred thousand entries.", "nothing")
def zip_many_entries(at: Path, world: World) -> None:  # noqa: ARG001
    path = at.with_name(at.name + ".zip")
    with zipfile.ZipFile(path, "w") as file:
        file.writestr(SUMS, IDLE)
        for number in range(100_000):
            file.writestr(f"{number}", b"")


@odd("A zip that needs a password.", "nothing")
def zip_encrypted(at: Path, world: World) -> None:  # noqa: ARG001
    path = zipped(at, [(SUMS, RIGHT)])
    data = bytearray(path.read_bytes())
    data[6] |= 1
    data[data.rindex(b"PK\1\2") + 8] |= 1
    path.write_bytes(data)


@odd("A zip with two files of one name, both wrong.", "nothing")
def zip_twice(at: Path, world: World) -> None:  # noqa: ARG001
    path = zipped(at, [(SUMS, IDLE), ("ch90_sums/sumz.py", IDLE + "\n")])
    path.write_bytes(path.read_bytes().replace(b"sumz.py", b"sums.py"))


@odd("A zip with a zip in it.", "nothing")
def zip_in_a_zip(at: Path, world: World) -> None:  # noqa: ARG001
    inner = io.BytesIO()
    with zipfile.ZipFile(inner, "w") as file:
        file.writestr(SUMS, RIGHT)
    path = at.with_name(at.name + ".zip")
    with zipfile.ZipFile(path, "w") as file:
        file.writestr("work.zip", inner.getvalue())


@odd("A zip with names that are no text.", "nothing")
def zip_odd_names(at: Path, world: World) -> None:  # noqa: ARG001
    path = zipped(at, [("ch90_sums/XXXX.py", RIGHT), (SUMS, IDLE), ("\x1b[2J", "nothing")])
    path.write_bytes(path.read_bytes().replace(b"XXXX", b"\xff\xfe\x80\n"))


@odd("A picture that is called a zip.", "nothing")
def zip_of_another_kind(at: Path, world: World) -> None:  # noqa: ARG001
    at.with_name(at.name + ".zip").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(5000))
