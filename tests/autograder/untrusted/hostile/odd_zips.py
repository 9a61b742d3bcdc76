"""Submissions that are zips, of all sorts."""

from __future__ import annotations

import io
import os
import stat
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path

from corpus import IDLE, RIGHT, World
from odd_files import SUMS, odd

Entries = dict[str, str | bytes]
CENTRAL = b"PK\1\2"  # begins the entry of a file in the list at the end
CLIMBING = ["../" * depth + "hostile-climbed" for depth in range(1, 6)]
CLIMBING += [f"../../root/solutions/{SUMS}", "..\\..\\hostile-climbed"]


def zip_of(entries: Entries, how: int = zipfile.ZIP_DEFLATED) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", how) as file:
        for name, content in entries.items():
            file.writestr(name, content)
    return stream.getvalue()


def write_zip(at: Path, content: bytes) -> None:
    """Write a zip in the place of the folder."""
    at.with_name(at.name + ".zip").write_bytes(content)


def odd_zip(name: str, content: Callable[[], bytes], earns: str = "nothing") -> None:
    odd(name, earns, {}, lambda at, _: write_zip(at, content()))


def spoiled(entries: Entries, spoil: Callable[[bytearray], object]) -> bytes:
    data = bytearray(zip_of(entries))
    spoil(data)
    return bytes(data)


def with_middle(data: bytearray) -> None:
    data[60:120] = os.urandom(60)


def lies_about_size(data: bytearray) -> None:
    struct.pack_into("<L", data, 22, 500)
    struct.pack_into("<L", data, data.rindex(CENTRAL) + 24, 500)


def lies_about_count(data: bytearray) -> None:
    struct.pack_into("<2H", data, data.rindex(b"PK\5\6") + 8, 60_000, 60_000)


def asks_for_a_password(data: bytearray) -> None:
    for place in (6, data.rindex(CENTRAL) + 8):
        data[place] |= 1


for name, content in {
    "zip_empty": lambda: zip_of({}),
    "zip_corrupt": lambda: spoiled({SUMS: RIGHT}, with_middle),
    "zip_bomb": lambda: zip_of({SUMS: b"\n" * 200_000_000}),
    "zip_lies_about_size": lambda: spoiled({SUMS: RIGHT + "\n" * 20_000_000}, lies_about_size),
    "zip_lies_about_count": lambda: spoiled({SUMS: IDLE}, lies_about_count),
    "zip_climbs": lambda: zip_of(dict.fromkeys(CLIMBING, "climbed") | {SUMS: IDLE}),
    "zip_many_entries": lambda: zip_of(
        {SUMS: IDLE} | {f"{number}": b"" for number in range(100_000)}, zipfile.ZIP_STORED
    ),
    "zip_encrypted": lambda: spoiled({SUMS: RIGHT}, asks_for_a_password),
    # Two files of one name, both wrong
    "zip_twice": lambda: zip_of({SUMS: IDLE, "ch90_sums/sumz.py": f"{IDLE}\n"}).replace(
        b"sumz.py", b"sums.py"
    ),
    "zip_in_a_zip": lambda: zip_of({"work.zip": zip_of({SUMS: RIGHT})}),
    "zip_odd_names": lambda: zip_of(
        {"ch90_sums/XXXX.py": RIGHT, SUMS: IDLE, "\x1b[2J": "nothing"}
    ).replace(b"XXXX", b"\xff\xfe\x80\n"),
    "zip_of_another_kind": lambda: b"\x89PNG\r\n\x1a\n" + bytes(5000),
}.items():
    odd_zip(name, content)
odd_zip("zip_right", lambda: zip_of({f"work/{SUMS}": RIGHT, "work/readme.txt": "nothing"}), "all")


def zip_absolute(at: Path, world: World) -> None:
    paths = world.home / "hostile-climbed", world.root / "tests/shared/expect.py", world.root / SUMS
    write_zip(at, zip_of(dict.fromkeys(map(str, paths), "climbed") | {SUMS: IDLE}))


def zip_linked(place: str, more: Entries) -> Callable[[Path, World], None]:
    """A zip with a link to the solution, and perhaps a file below the link."""

    def build(at: Path, world: World) -> None:
        entry = zipfile.ZipInfo(place)
        entry.create_system, entry.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
        write_zip(at, zip_of({entry: str(world.root / "solutions" / place)} | more))

    return build


odd("zip_absolute", "nothing", {}, zip_absolute)
odd("zip_link", "nothing", {}, zip_linked(SUMS, {}))
odd("zip_linked_folder", "nothing", {}, zip_linked("ch90_sums", {SUMS: IDLE}))
