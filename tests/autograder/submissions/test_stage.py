"""What is taken from a submission, folder or zip, and what is said of the rest."""

from __future__ import annotations

import errno
import os
import shutil
import socket
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from autograder.accepted_files import LARGEST_FILE
from autograder.manifest import ROOT, load_chapters
from autograder.submissions.stage import stage
from staging import (
    CHAPTERS,
    CODE,
    DENIED,
    EDITED,
    EXERCISES,
    FOLDER,
    GONE,
    LINK,
    LINKED,
    NO_FILE,
    NO_UTF8,
    NOTHING,
    OF_CH03,
    TAKEN,
    TOO_LARGE,
    UNKNOWN,
    UNSEARCHED,
    VECTOR,
    HandIn,
    Outcome,
    boxed,
    make_folder,
    make_zip,
    only,
    posix,
    refused,
)

# Both kinds of submission


def test_edited_files_are_taken_byte_for_byte_and_nothing_else(hand_in: HandIn) -> None:
    run = b"open('ran.txt', 'w')"
    wanted = {
        VECTOR: "# Å\r\nx = 1".encode(),
        EXERCISES: b"",
        "ch03_laws_of_motion/particle.py": b"\xef\xbb\xbfthis is no Python (",
        "ch03_laws_of_motion/exercises.py": run + b"#" * (LARGEST_FILE - len(run)),
    }
    others = {
        "ch02_vectors/arguments.py": run,  # complete: ours is taken
        "ch02_vectors/__init__.py": run,
        "ch02_vectors/more.py": run,
        "ch02_vectors/vector.pyc": CODE,
        "ch03_laws_of_motion/vector.py": CODE,
        "ch99_other/vector.py": CODE,
        "conftest.py": run,
    }
    assert boxed(hand_in(wanted | others)) == (wanted, {}, [])
    assert not Path("ran.txt").exists()


def test_only_the_chapters_that_are_asked_for_are_staged(hand_in: HandIn) -> None:
    submission = hand_in({VECTOR: CODE, "ch03_laws_of_motion/particle.py": b"\0"})
    box = submission.parent / "box"
    assert stage(submission, CHAPTERS[:1], box).rejected == {}
    assert [path.name for path in box.iterdir()] == ["ch02_vectors"]


def in_ch02(place: str, name: str = "vector.py") -> dict[str, bytes]:
    return {place.replace("*", "ch02_vectors") + "/" + name: CODE}


def renamed_to(
    name: str, beside: dict[str, bytes] | None = None
) -> tuple[dict[str, bytes], Outcome]:
    others = beside or {}
    why = f"its name is '{name}', so rename it to vector.py"
    return others | in_ch02("*", name), (others, {VECTOR: why}, [])


def several(places: str, taken: str) -> tuple[dict[str, bytes], Outcome]:
    others = [place for place in places.split() if place != taken]
    # The other files of a folder that does not count are not taken either.
    files = {f"{place}/{name}": CODE for place in others for name in (VECTOR, EXERCISES)}
    path = f"{taken}/ch02_vectors"
    note = f"there are {len(others) + 1} folders called ch02_vectors: '{path}' was used"
    return {**files, f"{taken}/{VECTOR}": b"taken"}, ({VECTOR: b"taken"}, {}, [note])


def bad(content: bytes, why: str) -> tuple[dict[str, bytes], Outcome]:
    return {VECTOR: content, EXERCISES: CODE}, ({EXERCISES: CODE}, {VECTOR: why}, [])


DAMPING = "ch03_laws_of_motion/damping.py"


@pytest.mark.parametrize(
    ("files", "outcome"),
    [
        # Neither stubs nor solutions are taken for what is not there.
        *((files, NOTHING) for files in ({}, {"readme.txt": CODE})),
        *(
            (in_ch02("*", n), NOTHING)
            for n in ("vector.txt", "my_helpers.py", "vector\x1b.py", "._vector.py.py")
        ),
        # A chapter may be three levels down, but nowhere else.
        *((in_ch02(at), TAKEN) for at in ("*", "a/*", "a/b/*", "[x] Ångström\n/$(b)/*")),
        *((in_ch02(at), NOTHING) for at in ("a/b/c/*", ".hidden/*", "a/.git/*", "__MACOSX/*")),
        *((in_ch02(at), NOTHING) for at in ("a/b/c/d", ".hidden")),
        # A file under a similar name is named.
        *(renamed_to(n) for n in ("vector (1).py", "Vector.py", "vectors.py", "vector_.py")),
        *(renamed_to(n, {EXERCISES: CODE}) for n in ("Vector.py", "vector (1).py")),
        # The shallowest folder counts, and then the first by name.
        *(several("b a/b", "b"), several("b a", "a"), several("a/a b", "b")),
        *(several("z a/a b/a", "z"), several("b/a a/z", "a/z")),
        # One bad file stops no other.
        bad(b"#" * (LARGEST_FILE + 1), TOO_LARGE),
        bad(b"x = 1\0", "it contains NUL bytes: save it as UTF-8 in your editor"),
        *(bad(content, NO_UTF8) for content in (b"x = '\xe9'", b"x = '\xed\xa0\x80'")),
        bad("x = 1".encode("utf-16"), NO_UTF8),
        # The stubs that a handout keeps are not what was handed in.
        (in_ch02("work/chapters/*") | {f"stubs/{VECTOR}": b"stub"}, TAKEN),
        # A folder without edited files does not count, as when a zip is unpacked into itself.
        (
            {"ch02_vectors/x.txt": b"", f"ch02_vectors/{VECTOR}": b"2", f"b/{DAMPING}": b"3"},
            ({VECTOR: b"2", DAMPING: b"3"}, {}, []),
        ),
    ],
)
def test_what_is_taken_of_a_submission(
    hand_in: HandIn, files: dict[str, bytes], outcome: Outcome
) -> None:
    assert boxed(hand_in(files)) == outcome


@posix
def test_another_user_can_read_the_box_whatever_the_umask(hand_in: HandIn) -> None:
    submission = hand_in({VECTOR: CODE})
    if submission.is_dir():
        (submission / VECTOR).chmod(0o4700)
    box = submission.parent / "box"
    before = os.umask(0o077)
    try:
        stage(submission, load_chapters(), box)  # chapter 6 has a folder in its folder
    finally:
        os.umask(before)
    for path in box.rglob("*"):
        assert stat.S_IMODE(path.stat().st_mode) == (0o755 if path.is_dir() else 0o644)


def test_a_submission_that_is_not_there_or_a_link(hand_in: HandIn, tmp_path: Path) -> None:
    assert boxed(tmp_path / "ann") == refused(f"the submission cannot be read: {GONE}")
    (tmp_path / "bob").symlink_to(hand_in({VECTOR: CODE}))
    assert boxed(tmp_path / "bob") == refused("the submission is a symbolic link")


# The digest


def digest(folder: Path, files: dict[str, bytes]) -> str:
    folder.mkdir()
    return stage(make_zip(folder, files), CHAPTERS, folder / "box").digest


def test_equal_digests_mean_that_the_same_was_taken(tmp_path: Path) -> None:
    bases: list[dict[str, bytes]] = [
        {},
        {VECTOR: b""},
        {VECTOR: b"a"},
        {EXERCISES: b"a"},
        {"ch03_laws_of_motion/exercises.py": b"a"},
        {VECTOR: b"a", EXERCISES: b""},
        {VECTOR: b"", EXERCISES: b"a"},
        {VECTOR: b"\0"},
        {VECTOR: b"\xff"},
    ]
    digests = [digest(tmp_path / str(i), files) for i, files in enumerate(bases)]
    assert len(set(digests)) == len(bases)
    assert all(len(text) == 64 and int(text, 16) >= 0 for text in digests)
    again = bases[5] | {"notes.txt": b"more", "ch02_vectors/arguments.py": b"mine"}
    assert digest(tmp_path / "again", again) == digests[5]
    moved = {f"deeper/{name}": content for name, content in bases[5].items()}
    assert digest(tmp_path / "moved", moved) == digests[5]


def test_a_folder_and_a_zip_of_it_are_one_submission(tmp_path: Path) -> None:
    ada = ROOT / "sample_class/ada"
    zipped = Path(shutil.make_archive(str(tmp_path / "ada"), "zip", ada))
    assert stage(ada, CHAPTERS, tmp_path / "1") == stage(zipped, CHAPTERS, tmp_path / "2")
    files, missing, notes = boxed(zipped)
    assert (sorted(files), missing, notes) == (sorted(EDITED), {}, [])


# Folders


def bind(path: Path) -> None:
    """Make a socket; its own path may not be long."""
    with pytest.MonkeyPatch.context() as patch, socket.socket(socket.AF_UNIX) as listener:
        patch.chdir(path.parent)
        listener.bind(path.name)


def sparse(path: Path) -> None:
    path.write_bytes(b"")
    os.truncate(path, 1 << 40)


@posix
@pytest.mark.parametrize("late", [False, True])
@pytest.mark.parametrize(
    ("make", "why", "why_late"),
    [
        (lambda path: path.symlink_to(ROOT / "solutions" / VECTOR), LINK, LINK),
        (lambda path: path.symlink_to("nowhere"), LINK, LINK),
        (lambda path: path.symlink_to(path.name), LINK, LINK),
        (lambda path: os.mkfifo(path), NO_FILE, NO_FILE),
        (bind, NO_FILE, "it cannot be read: No such device or address"),
        (lambda path: path.mkdir(), FOLDER, "it cannot be read: Is a directory"),
        (sparse, TOO_LARGE, TOO_LARGE),
        (lambda _: None, None, f"it cannot be read: {GONE}"),
    ],
)
def test_what_is_no_file_or_is_none_any_more_when_it_is_opened(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    make: Callable[[Path], object],
    why: str | None,
    why_late: str,
    late: bool,
) -> None:
    path = make_folder(tmp_path, {VECTOR: CODE}) / VECTOR
    real = os.open

    def changed(opened: Any, *arguments: Any, **keywords: Any) -> int:
        if Path(opened) == path:
            path.unlink()
            make(path)
        return real(opened, *arguments, **keywords)

    if late:
        monkeypatch.setattr(os, "open", changed)
        assert boxed(tmp_path / "ann") == only(why_late)
    else:
        path.unlink()
        make(path)
        assert boxed(tmp_path / "ann") == (only(why) if why else NOTHING)


def test_a_file_that_grows_while_it_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One byte more than allowed is read, however many there are by now."""
    path = make_folder(tmp_path, {VECTOR: CODE}) / VECTOR
    real = os.fstat

    def grown(descriptor: int) -> os.stat_result:
        status = real(descriptor)
        if status.st_ino == path.stat().st_ino:
            path.write_bytes(b"#" * (LARGEST_FILE + 1))
        return status

    monkeypatch.setattr(os, "fstat", grown)
    assert boxed(tmp_path / "ann") == only(TOO_LARGE)


def test_linked_folders_are_not_searched_and_told_if_there_is_no_other(tmp_path: Path) -> None:
    ann = make_folder(tmp_path, {})
    (ann / "mine").symlink_to(ROOT / "solutions")
    (ann / "round").symlink_to(".")
    assert boxed(ann) == NOTHING
    (ann / "ch02_vectors").symlink_to(ROOT / "solutions/ch02_vectors")
    assert boxed(ann) == LINKED
    assert boxed(make_folder(tmp_path, {f"z/{VECTOR}": CODE})) == TAKEN


@pytest.mark.parametrize(
    ("locked", "outcome"),
    [
        ("other", ({VECTOR: CODE}, dict.fromkeys(OF_CH03, UNKNOWN), [f"'other' {UNSEARCHED}"])),
        (".", refused(f"the submission cannot be read: {DENIED}")),
    ],
)
def test_what_may_not_be_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, locked: str, outcome: Outcome
) -> None:
    ann = make_folder(tmp_path, {VECTOR: CODE, "other/readme.txt": CODE})
    real = os.scandir

    def scandir(path: Any) -> Any:
        if path == ann / locked:
            raise PermissionError(errno.EACCES, DENIED)
        return real(path)

    monkeypatch.setattr(os, "scandir", scandir)
    assert boxed(ann) == outcome


def test_the_search_in_a_crowd_stops_and_says_so(tmp_path: Path) -> None:
    # With a, its ch02_vectors and vector.py: 5,000.
    ann = make_folder(tmp_path, {f"a/{VECTOR}": CODE} | {f"{n}.txt": b"" for n in range(4_997)})
    assert boxed(ann) == TAKEN
    make_folder(tmp_path, {"1.csv": b"", "2.csv": b"", "3.csv": b""})
    why = "it is not among the first 5,000 files and folders handed in"
    stopped = "the search stopped after 5,000 files and folders"
    assert boxed(ann) == ({}, dict.fromkeys(EDITED, why), [stopped])
