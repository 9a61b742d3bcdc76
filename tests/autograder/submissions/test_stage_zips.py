"""What is taken from a submission that is a zip: odd, damaged, huge, and hostile ones."""

from __future__ import annotations

import os
import shutil
import stat
import struct
import time
import tracemalloc
import warnings
import zipfile
from pathlib import Path
from typing import Any

import pytest

from autograder.accepted_files import LARGEST_FILE
from autograder.submissions.search import LARGEST_ZIP
from staging import (
    CODE,
    CROWDED,
    DAMAGED,
    EXERCISES,
    LINKED,
    NO_FILE,
    NOTHING,
    SPOILT,
    TAKEN,
    TOO_LARGE,
    UNUSUAL,
    VECTOR,
    Outcome,
    boxed,
    make_zip,
    only,
    posix,
    refused,
    set_fields,
    special_zip,
)


@pytest.mark.parametrize("name", [f"./{VECTOR}", "my work\\a\\ch02_vectors\\vector.py"])
def test_paths_as_odd_tools_write_them(tmp_path: Path, name: str) -> None:
    assert boxed(special_zip(tmp_path, name)) == TAKEN


@pytest.mark.parametrize(("flags", "outcome"), [(0, TAKEN), (1 << 11, refused(DAMAGED))])
def test_names_in_any_encoding_are_read(tmp_path: Path, flags: int, outcome: Outcome) -> None:
    """Unless they promise, with bit 11, to be UTF-8."""
    made = special_zip(tmp_path, f"ab/{VECTOR}", flags=flags)
    made.write_bytes(made.read_bytes().replace(b"ab/", b"\x81\xff/"))
    assert boxed(made) == outcome


def test_a_name_does_not_end_at_a_nul(tmp_path: Path) -> None:
    made = special_zip(tmp_path, f"{VECTOR}?.txt")
    made.write_bytes(made.read_bytes().replace(b"?", b"\0"))
    assert boxed(made) == NOTHING


@pytest.mark.parametrize("above", ["/", "a/../../", "./../", "..\\", "\\\\host\\a\\", "C:\\"])
def test_paths_that_lead_out_of_the_zip(tmp_path: Path, above: str) -> None:
    assert boxed(special_zip(tmp_path, above + VECTOR)) == NOTHING
    assert not [path for path in tmp_path.rglob("vector.py") if ".box-" not in str(path)]
    # A sound path counts before it.
    assert boxed(make_zip(tmp_path, {above + VECTOR: b"1", f"a/{VECTOR}": CODE})) == TAKEN


@pytest.mark.parametrize(
    ("special", "why"),
    [
        ({"mode": stat.S_IFLNK | 0o777}, NO_FILE),
        ({"mode": stat.S_IFIFO | 0o644}, NO_FILE),
        ({"mode": stat.S_IFDIR | 0o755}, NO_FILE),
        ({"mode": 0, "name": f"{VECTOR}/"}, NO_FILE),
        ({"mode": 0, "name": "ch02_vectors\\vector.py\\"}, NO_FILE),
        ({"flags": 1}, "it is encrypted in the zip: zip it without a password"),
        ({"flags": 1 << 6}, SPOILT),  # another encryption
        ({"method": zipfile.ZIP_BZIP2}, UNUSUAL),
        ({"method": 97}, UNUSUAL),
        ({"method": zipfile.ZIP_DEFLATED}, SPOILT),
        ({"packed": 3}, SPOILT),
        ({"size": LARGEST_FILE + 1}, TOO_LARGE),
        ({"crc": 0}, SPOILT),
        ({"offset": 4_000_000_000}, SPOILT),
        ({"offset": 0xFFFF_FFFF, "extra": struct.pack("<2HQ", 1, 8, 1 << 63)}, SPOILT),  # zip64
    ],
)
def test_files_in_a_zip_that_are_not_taken(
    tmp_path: Path, special: dict[str, Any], why: str
) -> None:
    assert boxed(special_zip(tmp_path, **special)) == only(why)


@pytest.mark.parametrize(
    ("special", "outcome"),
    [
        ({"mode": 0}, TAKEN),  # from a system without modes
        ({"mode": stat.S_IFLNK | 0o777, "name": "a/ch02_vectors"}, LINKED),
        ({"version": 99}, refused(DAMAGED)),
    ],
)
def test_other_fields_of_a_zip(tmp_path: Path, special: dict[str, Any], outcome: Outcome) -> None:
    assert boxed(special_zip(tmp_path, **special)) == outcome


@pytest.mark.parametrize("second", ["ch02_vectors/vector.py", "ch02_vectors\\vector.py"])
def test_one_name_twice_is_refused(tmp_path: Path, second: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # zipfile doubts it too
        with zipfile.ZipFile(tmp_path / "ann.zip", "w") as file:
            for content in (b"good", b"bad", b"good"):
                file.writestr(VECTOR, content)
            file.writestr(second, b"other")
            file.writestr(EXERCISES, CODE)
    why = "it is in the zip twice"
    assert boxed(tmp_path / "ann.zip") == ({EXERCISES: CODE}, {VECTOR: why}, [])


@pytest.mark.parametrize("content", [b"", b"PK\5\6" + b"\0" * 17, b"Rar!\x1a\7", b"\xff" * 100_000])
def test_what_is_no_zip(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "ann.zip").write_bytes(content)
    assert boxed(tmp_path / "ann.zip") == refused(DAMAGED)


@pytest.mark.parametrize("method", [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED])
def test_a_zip_cut_or_changed_anywhere_is_told_and_never_raises(
    tmp_path: Path, method: int
) -> None:
    made = make_zip(tmp_path, {f"a/{VECTOR}": b"one", "ch02_vectors/x.txt": b"two"}, method)
    data = made.read_bytes()
    directory = data.index(b"PK\1\2")
    for length in range(0, len(data), 5):
        made.write_bytes(data[:length])
        assert boxed(made) == refused(DAMAGED)
    for position in range(len(data)):
        value = (0, 255, data[position] ^ 1)[position % 3]
        made.write_bytes(data[:position] + bytes([value]) + data[position + 1 :])
        files, missing, notes = boxed(made)
        assert files in ({}, {VECTOR: b"one"})
        if position < directory:
            assert (files, missing) in (({VECTOR: b"one"}, {}), ({}, {VECTOR: SPOILT}))
        elif position < directory + 4:  # "PK" and the kind of record
            assert (files, missing, notes) == refused(DAMAGED)
        shutil.rmtree(next(tmp_path.glob(".box-*")))


@posix
def test_a_submission_that_is_a_pipe_holds_nothing_up(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "ann.zip")
    assert boxed(tmp_path / "ann.zip") == refused("the zip is not a regular file")


def test_a_zip_that_is_too_large_is_not_opened(tmp_path: Path) -> None:
    assert boxed(make_zip(tmp_path, {VECTOR: CODE, "film": bytes(4_999_000)}, 0)) == TAKEN
    made = make_zip(tmp_path, {VECTOR: CODE, "film": bytes(5_000_000)}, 0)
    assert boxed(made) == refused(
        "the zip is larger than 5,000,000 bytes: zip only the folders of the chapters"
    )


def test_as_many_entries_as_allowed_are_read(tmp_path: Path) -> None:
    files = {VECTOR: CODE} | {f"{number}.txt": b"" for number in range(4_999)}
    assert boxed(make_zip(tmp_path, files)) == TAKEN
    made = make_zip(tmp_path, files | {"one more.txt": b""})
    assert boxed(made) == refused(CROWDED)


@pytest.mark.parametrize(
    ("name", "extra", "outcome"),
    [
        (b"a", b"", refused(CROWDED)),
        (b"a", bytes(65_532), NOTHING),  # of which zipfile makes sense at some length
        (b"a/" * 32_000 + VECTOR.encode(), b"", NOTHING),
    ],
)
def test_a_huge_directory_costs_little_time(
    tmp_path: Path, name: bytes, extra: bytes, outcome: Outcome
) -> None:
    """A zip that is all directory, and says that it has one entry."""
    fields = [b"PK\1\2", *[0] * 9, len(name), len(extra), *[0] * 5]
    entry = struct.pack("<4s6H3L5H2L", *fields) + name + extra
    directory = entry * ((LARGEST_ZIP - 22) // len(entry))
    end = struct.pack("<4s4H2LH", b"PK\5\6", 0, 0, 1, 1, len(directory), 0, 0)
    (tmp_path / "ann.zip").write_bytes(directory + end)
    begin = time.process_time()
    assert boxed(tmp_path / "ann.zip") == outcome
    assert time.process_time() - begin < 60.0  # it is 2 at most: a hang is what must not be


@pytest.mark.parametrize(("said", "why"), [(50_000_000, TOO_LARGE), (10, SPOILT)])
def test_a_bomb_is_never_unpacked(tmp_path: Path, said: int, why: str) -> None:
    made = set_fields(make_zip(tmp_path, {VECTOR: bytes(50_000_000)}), size=said)
    tracemalloc.start()
    try:
        assert boxed(made) == only(why)
        assert tracemalloc.get_traced_memory()[1] < 10_000_000  # of which 5 are for any zip
    finally:
        tracemalloc.stop()
