"""What is taken from a submission, folder or zip, and what is said of the rest."""

from __future__ import annotations

import os
import shutil
import socket
import stat
import struct
import tempfile
import time
import tracemalloc
import warnings
import zipfile
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from autograder.manifest import ROOT, load_chapters
from autograder.submissions.find import file_name, find_submissions
from autograder.submissions.stage import LARGEST_FILE, Staged, stage

CHAPTERS = load_chapters()[:2]
MODULES = {f"{c.name}.{f.removesuffix('.py')}" for c in CHAPTERS for f in c.edited_files}
CODE = b"x = 1\n"
HandIn = Callable[[dict[str, bytes]], Path]


@pytest.fixture(params=["folder", "zip"])
def hand_in(request: pytest.FixtureRequest, tmp_path: Path) -> HandIn:
    """Make a submission of files by path, once as a folder and once as a zip."""

    def as_folder(files: dict[str, bytes]) -> Path:
        (tmp_path / "ann").mkdir()
        for name, content in files.items():
            (tmp_path / "ann" / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / "ann" / name).write_bytes(content)
        return tmp_path / "ann"

    def as_zip(files: dict[str, bytes]) -> Path:
        return make_zip(tmp_path, files)

    return as_folder if request.param == "folder" else as_zip


@pytest.fixture
def ann(tmp_path: Path) -> Path:
    """A folder with a chapter's folder that is still empty."""
    (tmp_path / "ann/ch02_vectors").mkdir(parents=True)
    return tmp_path / "ann"


def make_zip(folder: Path, files: dict[str, bytes], method: int = zipfile.ZIP_DEFLATED) -> Path:
    with zipfile.ZipFile(folder / "ann.zip", "w", method) as file:
        for name, content in files.items():
            file.writestr(name, content)
    return folder / "ann.zip"


def special_zip(
    folder: Path,
    name: str = "ch02_vectors/vector.py",
    mode: int = 0o100644,
    fields: dict[str, int] | None = None,
) -> Path:
    """A zip with one file, of which fields in the directory are set to other values."""
    info = zipfile.ZipInfo(name)
    info.create_system, info.external_attr = 3, mode << 16
    with zipfile.ZipFile(folder / "ann.zip", "w") as file:
        file.writestr(info, CODE)
    data = bytearray((folder / "ann.zip").read_bytes())
    places = {"flags": (8, "H"), "method": (10, "H"), "packed": (20, "L"), "size": (24, "L")}
    for field, value in (fields or {}).items():
        offset, form = places[field]
        struct.pack_into(f"<{form}", data, data.index(b"PK\1\2") + offset, value)
    (folder / "ann.zip").write_bytes(data)
    return folder / "ann.zip"


def boxed(submission: Path, root: Path = ROOT) -> tuple[Staged, dict[str, bytes]]:
    """Stage a submission into a new box; return what is said, and the students' files in it."""
    box = Path(tempfile.mkdtemp(dir=submission.parent, prefix=".box-"))
    staged = stage(submission, CHAPTERS, box, root)
    complete = {f"{chapter.name}/{name}" for chapter in CHAPTERS for name in chapter.complete}
    files = {str(p.relative_to(box)): p.read_bytes() for p in box.rglob("*") if p.is_file()}
    assert complete <= files.keys()
    return staged, {name: files[name] for name in files.keys() - complete}


def reason(submission: Path, root: Path = ROOT) -> str:
    """Return why ch02_vectors/vector.py is not taken, which is all that there is."""
    staged, files = boxed(submission, root)
    assert files == {}
    assert staged.missing.keys() == {"ch02_vectors.vector"}
    sentence = staged.missing["ch02_vectors.vector"]
    assert sentence.startswith("ch02_vectors/vector.py was not taken: ")
    return sentence.partition(": ")[2]


def reason_for_all(submission: Path, root: Path = ROOT) -> str:
    """Return why no file at all is taken, which the instructor is told as well."""
    staged, files = boxed(submission, root)
    assert files == {}
    assert staged.missing.keys() == MODULES
    (why,) = {sentence.partition(": ")[2] for sentence in staged.missing.values()}
    assert staged.notes == [f"nothing was taken: {why}"]
    return why


# Both kinds of submission


def test_edited_files_are_taken_byte_for_byte_and_nothing_else(hand_in: HandIn) -> None:
    wanted = {
        "ch02_vectors/vector.py": "# Å\r\nx = 1".encode(),
        "ch02_vectors/exercises.py": b"",
        "ch03_laws_of_motion/particle.py": b"\xef\xbb\xbfthis is no Python (",
    }
    others = {
        "ch02_vectors/plots.py": b"raise SystemExit",
        "ch02_vectors/__init__.py": CODE,
        "ch02_vectors/more.py": CODE,
        "ch02_vectors/vector.pyc": CODE,
        "ch03_laws_of_motion/vector.py": CODE,
        "ch99_other/vector.py": CODE,
        "conftest.py": CODE,
    }
    submission = hand_in(wanted | others)
    staged, files = boxed(submission)
    assert files == wanted
    assert (staged.missing, staged.notes) == ({}, [])


def test_complete_modules_are_ours_and_nothing_is_a_stub_or_a_solution(hand_in: HandIn) -> None:
    submission = hand_in({"ch02_vectors/plots.py": b"mine", "readme.txt": CODE})
    box = submission.parent / "box"
    staged = stage(submission, CHAPTERS, box)
    for chapter in CHAPTERS:
        assert {path.name for path in (box / chapter.name).iterdir()} == set(chapter.complete)
        for name in chapter.complete:
            ours = (ROOT / "chapters" / chapter.name / name).read_bytes()
            assert (box / chapter.name / name).read_bytes() == ours
    assert (staged.missing, staged.notes) == ({}, [])


def test_complete_modules_come_from_the_root_that_is_given(ann: Path, tmp_path: Path) -> None:
    for chapter in CHAPTERS:
        (tmp_path / "root/chapters" / chapter.name).mkdir(parents=True)
        for name in chapter.complete:
            (tmp_path / "root/chapters" / chapter.name / name).write_text("other")
    stage(ann, CHAPTERS, tmp_path / "box", tmp_path / "root")
    assert (tmp_path / "box/ch02_vectors/plots.py").read_text() == "other"


def test_only_the_chapters_that_are_asked_for_are_staged(hand_in: HandIn) -> None:
    submission = hand_in({"ch02_vectors/vector.py": CODE, "ch03_laws_of_motion/particle.py": b"\0"})
    box = submission.parent / "box"
    assert stage(submission, CHAPTERS[:1], box).missing == {}
    assert [path.name for path in box.iterdir()] == ["ch02_vectors"]


@pytest.mark.parametrize("above", ["", "a/", "a/b/", "[x] Ångström\n/$(b)/"])
def test_a_chapter_may_stand_three_levels_down(hand_in: HandIn, above: str) -> None:
    staged, files = boxed(hand_in({f"{above}ch02_vectors/vector.py": CODE}))
    assert files == {"ch02_vectors/vector.py": CODE}
    assert (staged.missing, staged.notes) == ({}, [])


@pytest.mark.parametrize(
    "path",
    [
        "a/b/c/ch02_vectors/vector.py",
        ".hidden/ch02_vectors/vector.py",
        "a/.git/ch02_vectors/vector.py",
        "__MACOSX/ch02_vectors/vector.py",
        "my_ch02_vectors/vector.py",
        "ch02_vectors (1)/vector.py",
        "ch02_vectors/src/vector.py",
        "vector.py",
    ],
)
def test_elsewhere_nothing_is_searched(hand_in: HandIn, path: str) -> None:
    staged, files = boxed(hand_in({path: CODE}))
    assert (staged.missing, staged.notes, files) == ({}, [], {})


@pytest.mark.parametrize(
    ("places", "taken"),
    [
        (["b", "a/b"], "b"),
        (["b", "a"], "a"),
        (["a/a", "b"], "b"),
        (["z", "a/a", "b/a"], "z"),
        (["b/a", "a/z"], "a/z"),
        (["."], "."),
    ],
)
def test_the_shallowest_folder_counts_and_then_the_first_by_name(
    hand_in: HandIn, places: list[str], taken: str
) -> None:
    files = {f"{place}/ch02_vectors/vector.py": place.encode() for place in places}
    # The other files of a folder that does not count are not taken either.
    files |= {f"{place}/ch02_vectors/exercises.py": CODE for place in places if place != taken}
    staged, found = boxed(hand_in(files))
    assert found == {"ch02_vectors/vector.py": taken.encode()}
    if len(places) > 1:
        said = f"there are {len(places)} folders called ch02_vectors: {taken}/ch02_vectors was"
        assert [note.startswith(said) for note in staged.notes] == [True]
    else:
        assert staged.notes == []


def test_a_folder_without_any_edited_file_does_not_count(hand_in: HandIn) -> None:
    """As when a zip is unpacked into a folder of its own name."""
    staged, files = boxed(
        hand_in({"ch02_vectors/readme.txt": CODE, "ch02_vectors/ch02_vectors/vector.py": CODE})
    )
    assert files == {"ch02_vectors/vector.py": CODE}
    assert staged.notes == []


def test_chapters_may_stand_in_different_folders(hand_in: HandIn) -> None:
    submission = hand_in(
        {"a/ch02_vectors/vector.py": b"2", "b/ch03_laws_of_motion/damping.py": b"3"}
    )
    assert boxed(submission)[1] == {
        "ch02_vectors/vector.py": b"2",
        "ch03_laws_of_motion/damping.py": b"3",
    }


def test_a_file_of_the_largest_size_is_taken(hand_in: HandIn) -> None:
    content = b"#" * LARGEST_FILE
    assert boxed(hand_in({"ch02_vectors/vector.py": content}))[1] == {
        "ch02_vectors/vector.py": content
    }


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"#" * (LARGEST_FILE + 1), "it is larger than 1,000,000 bytes"),
        (b"x = 1\0", "it has NUL bytes in it: it is no text"),
        (b"x = '\xe9'", "it is not UTF-8: save it as UTF-8 in your editor"),
        ("x = 1".encode("utf-16"), "it is not UTF-8: save it as UTF-8 in your editor"),
        (b"x = '\xed\xa0\x80'", "it is not UTF-8: save it as UTF-8 in your editor"),
    ],
)
def test_content_that_is_not_taken(hand_in: HandIn, content: bytes, words: str) -> None:
    assert reason(hand_in({"ch02_vectors/vector.py": content})) == words


def test_one_bad_file_stops_no_other(hand_in: HandIn) -> None:
    submission = hand_in({"ch02_vectors/vector.py": b"\0", "ch02_vectors/exercises.py": CODE})
    staged, files = boxed(submission)
    assert files == {"ch02_vectors/exercises.py": CODE}
    assert staged.missing.keys() == {"ch02_vectors.vector"}


def test_source_is_never_run(hand_in: HandIn) -> None:
    flag = "ran.txt"
    code = f"open({flag!r}, 'w')".encode()
    submission = hand_in({f"ch02_vectors/{name}": code for name in ("vector.py", "__init__.py")})
    boxed(submission)
    assert not Path(flag).exists()


@pytest.mark.skipif(os.name != "posix", reason="modes are POSIX's")
def test_another_user_can_read_the_box_whatever_the_umask(hand_in: HandIn) -> None:
    submission = hand_in({"ch02_vectors/vector.py": CODE})
    if submission.is_dir():
        (submission / "ch02_vectors/vector.py").chmod(0o4700)
    box = submission.parent / "box"
    before = os.umask(0o077)
    try:
        stage(submission, CHAPTERS, box)
    finally:
        os.umask(before)
    for path in box.rglob("*"):
        assert stat.S_IMODE(path.stat().st_mode) == (0o755 if path.is_dir() else 0o644)


def test_a_box_that_cannot_be_filled_is_the_graders_fault(hand_in: HandIn, tmp_path: Path) -> None:
    submission = hand_in({"ch02_vectors/vector.py": CODE})
    (tmp_path / "box").write_text("a file")
    with pytest.raises(OSError, match="box"):
        stage(submission, CHAPTERS, tmp_path / "box")


def test_a_submission_that_is_not_there(tmp_path: Path) -> None:
    why = reason_for_all(tmp_path / "ann")
    assert why == "the submission cannot be read: No such file or directory"


@pytest.mark.parametrize("kind", ["folder", "zip"])
def test_a_submission_that_is_a_link(tmp_path: Path, kind: str) -> None:
    made = make_zip(tmp_path, {"ch02_vectors/vector.py": CODE})
    target = made if kind == "zip" else ROOT / "solutions"
    (tmp_path / f"bob.{kind}").symlink_to(target)
    assert reason_for_all(tmp_path / f"bob.{kind}") == "the submission is a symbolic link"


# The digest


def digest(folder: Path, files: dict[str, bytes]) -> str:
    folder.mkdir()
    return boxed(make_zip(folder, files))[0].digest


def test_equal_digests_mean_that_the_same_was_taken(tmp_path: Path) -> None:
    bases: list[dict[str, bytes]] = [
        {},
        {"ch02_vectors/vector.py": b""},
        {"ch02_vectors/vector.py": b"a"},
        {"ch02_vectors/exercises.py": b"a"},
        {"ch03_laws_of_motion/exercises.py": b"a"},
        {"ch02_vectors/vector.py": b"a", "ch02_vectors/exercises.py": b""},
        {"ch02_vectors/vector.py": b"", "ch02_vectors/exercises.py": b"a"},
        {"ch02_vectors/vector.py": b"\0"},
        {"ch02_vectors/vector.py": b"\xff"},
    ]
    digests = [digest(tmp_path / str(i), files) for i, files in enumerate(bases)]
    assert len(set(digests)) == len(bases)
    assert all(len(text) == 64 and int(text, 16) >= 0 for text in digests)
    again = bases[5] | {"notes.txt": b"more", "ch02_vectors/plots.py": b"mine"}
    assert digest(tmp_path / "again", again) == digests[5]
    moved = {f"deeper/{name}": content for name, content in bases[5].items()}
    assert digest(tmp_path / "moved", moved) == digests[5]


def test_a_folder_and_a_zip_of_it_have_one_digest(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "sample_class/ada", tmp_path / "ann")
    shutil.make_archive(str(tmp_path / "bob"), "zip", tmp_path / "ann")
    folder, zipped = boxed(tmp_path / "ann"), boxed(tmp_path / "bob.zip")
    assert folder == zipped
    assert len(folder[1]) == len(MODULES)


# Folders


@pytest.fixture
def public() -> Iterator[Path]:
    """A folder, with our complete modules, in which a test runs without the rights of root."""
    if not hasattr(os, "geteuid"):
        pytest.skip("modes are POSIX's")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copytree(ROOT / "chapters", folder / "chapters")
        folder.chmod(0o777)
        user = os.geteuid()
        if user == 0:
            os.seteuid(65534)
        try:
            yield folder
        finally:
            os.seteuid(user)


def test_links_are_not_followed(ann: Path) -> None:
    (ann / "ch02_vectors/vector.py").symlink_to(ROOT / "solutions/ch02_vectors/vector.py")
    assert reason(ann) == "it is a symbolic link"


def test_a_link_to_nowhere_and_one_to_itself(ann: Path) -> None:
    (ann / "ch02_vectors/vector.py").symlink_to("nowhere")
    (ann / "ch02_vectors/exercises.py").symlink_to("exercises.py")
    assert {text.partition(": ")[2] for text in boxed(ann)[0].missing.values()} == {
        "it is a symbolic link"
    }


def test_the_folder_of_a_chapter_may_be_no_link(tmp_path: Path) -> None:
    (tmp_path / "ann").mkdir()
    (tmp_path / "ann/ch02_vectors").symlink_to(ROOT / "solutions/ch02_vectors")
    staged, files = boxed(tmp_path / "ann")
    assert files == {}
    assert staged.missing == {
        f"ch02_vectors.{name}": f"ch02_vectors/{name}.py was not taken: "
        "its folder is a symbolic link"
        for name in ("vector", "exercises")
    }


def test_a_real_folder_counts_before_a_linked_one(tmp_path: Path) -> None:
    (tmp_path / "ann/z/ch02_vectors").mkdir(parents=True)
    (tmp_path / "ann/z/ch02_vectors/vector.py").write_bytes(CODE)
    (tmp_path / "ann/ch02_vectors").symlink_to(ROOT / "solutions/ch02_vectors")
    staged, files = boxed(tmp_path / "ann")
    assert files == {"ch02_vectors/vector.py": CODE}
    assert staged.missing == {}


def test_linked_folders_above_a_chapter_are_not_searched(tmp_path: Path) -> None:
    (tmp_path / "ann").mkdir()
    (tmp_path / "ann/mine").symlink_to(ROOT / "solutions")
    (tmp_path / "ann/round").symlink_to(".")
    staged, files = boxed(tmp_path / "ann")
    assert (staged.missing, files) == ({}, {})


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes are POSIX's")
def test_pipes_sockets_and_folders_are_no_files(ann: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    os.mkfifo(ann / "ch02_vectors/vector.py")
    assert reason(ann) == "it is no regular file"
    (ann / "ch02_vectors/vector.py").unlink()
    monkeypatch.chdir(ann / "ch02_vectors")  # the path of a socket may not be long
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind("vector.py")
        assert reason(ann) == "it is no regular file"
    (ann / "ch02_vectors/vector.py").unlink()
    (ann / "ch02_vectors/vector.py").mkdir()
    assert reason(ann) == "it is a folder"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes are POSIX's")
def test_a_submission_that_is_a_pipe_holds_nothing_up(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "ann.zip")
    assert reason_for_all(tmp_path / "ann.zip") == "the zip is no regular file"


def test_a_huge_sparse_file_is_not_read(ann: Path) -> None:
    with (ann / "ch02_vectors/vector.py").open("wb") as file:
        file.truncate(1 << 40)
    assert reason(ann) == "it is larger than 1,000,000 bytes"


def test_a_file_without_rights(public: Path) -> None:
    (public / "ann/ch02_vectors").mkdir(parents=True)
    (public / "ann/ch02_vectors/vector.py").write_bytes(CODE)
    (public / "ann/ch02_vectors/vector.py").chmod(0)
    assert reason(public / "ann", public) == "it cannot be read: Permission denied"


def test_a_chapters_folder_without_rights(public: Path) -> None:
    folder = public / "ann/ch02_vectors"
    folder.mkdir(parents=True)
    (folder / "vector.py").write_bytes(CODE)
    folder.chmod(0)
    staged = boxed(public / "ann", public)[0]
    folder.chmod(0o755)
    assert staged.missing.keys() == MODULES  # who knows what else is in there
    for sentence in staged.missing.values():
        assert "a folder of the submission cannot be read: Permission denied" in sentence


def test_a_submission_and_a_folder_in_it_without_rights(public: Path) -> None:
    ann = public / "ann"
    (ann / "locked").mkdir(parents=True)
    (ann / "ch02_vectors").mkdir()
    (ann / "ch02_vectors/vector.py").write_bytes(CODE)
    (ann / "locked").chmod(0)
    staged, files = boxed(ann, public)
    assert files == {"ch02_vectors/vector.py": CODE}
    assert staged.notes == ["locked was not searched: Permission denied"]
    ann.chmod(0)
    why = reason_for_all(ann, public)
    ann.chmod(0o755)
    (ann / "locked").chmod(0o755)
    assert why == "the submission cannot be read: Permission denied"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes are POSIX's")
@pytest.mark.parametrize(
    ("change", "words"),
    [
        (None, "it cannot be read: No such file or directory"),
        (lambda path: path.symlink_to(ROOT / "LICENSE"), "it is a symbolic link"),
        (lambda path: os.mkfifo(path), "it is no regular file"),
        (lambda path: path.mkdir(), "it cannot be read: Is a directory"),
        (lambda path: path.write_bytes(b"#" * 1_000_001), "it is larger than 1,000,000 bytes"),
    ],
)
def test_a_file_that_is_another_by_the_time_it_is_opened(
    ann: Path,
    monkeypatch: pytest.MonkeyPatch,
    change: Callable[[Path], object] | None,
    words: str,
) -> None:
    path = ann / "ch02_vectors/vector.py"
    path.write_bytes(CODE)
    real = os.open

    def changed(opened: Any, *arguments: Any, **keywords: Any) -> int:
        if Path(opened) == path:
            path.unlink()
            if change is not None:
                change(path)
        return real(opened, *arguments, **keywords)

    monkeypatch.setattr(os, "open", changed)
    assert reason(ann) == words


def test_a_file_that_grows_while_it_is_read(ann: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One byte more than allowed is read, however many there are by now."""
    path = ann / "ch02_vectors/vector.py"
    path.write_bytes(CODE)
    real = os.fstat

    def grown(descriptor: int) -> os.stat_result:
        status = real(descriptor)
        if status.st_ino == path.stat().st_ino:
            path.write_bytes(b"#" * (LARGEST_FILE + 1))
        return status

    monkeypatch.setattr(os, "fstat", grown)
    assert reason(ann) == "it is larger than 1,000,000 bytes"


@pytest.mark.parametrize("gone", ["ann", "a"])
def test_a_folder_that_vanishes_while_it_is_searched(
    ann: Path, monkeypatch: pytest.MonkeyPatch, gone: str
) -> None:
    (ann / "ch02_vectors/vector.py").write_bytes(CODE)
    (ann / "a").mkdir()
    real = os.scandir

    def scandir(path: Any) -> Any:
        if path in (ann, ann / "a") and path.name == gone:
            monkeypatch.undo()
            shutil.rmtree(path)
        return real(path)

    monkeypatch.setattr(os, "scandir", scandir)
    if gone == "ann":
        why = reason_for_all(ann)
        assert why == "the submission cannot be read: No such file or directory"
    else:
        staged, files = boxed(ann)
        assert files == {"ch02_vectors/vector.py": CODE}
        assert staged.notes == ["a was not searched: No such file or directory"]


def test_the_search_in_a_crowd_stops_and_says_so(ann: Path) -> None:
    (ann / "ch02_vectors/vector.py").write_bytes(CODE)
    for number in range(5_001):
        (ann / f"{number}.txt").touch()
    staged, files = boxed(ann)
    assert files == {"ch02_vectors/vector.py": CODE}  # asked for by its name
    assert staged.notes == ["the search stopped after 5,000 files and folders"]
    assert staged.missing["ch03_laws_of_motion.particle"] == (
        "ch03_laws_of_motion/particle.py was not taken: "
        "it is not among the first 5,000 files and folders handed in"
    )
    assert "ch02_vectors.exercises" not in staged.missing


def test_a_folder_with_as_many_entries_as_allowed_is_searched(tmp_path: Path) -> None:
    (tmp_path / "ann/a/ch02_vectors").mkdir(parents=True)
    (tmp_path / "ann/a/ch02_vectors/vector.py").write_bytes(CODE)
    for number in range(4_997):  # with a, ch02_vectors and vector.py: 5,000
        (tmp_path / f"ann/{number}.txt").touch()
    staged, files = boxed(tmp_path / "ann")
    assert files == {"ch02_vectors/vector.py": CODE}
    assert (staged.missing, staged.notes) == ({}, [])


def test_names_that_are_no_text_are_escaped_in_notes(tmp_path: Path) -> None:
    for name in ("a\udcff\n\x1b", "b"):
        (tmp_path / "ann" / name / "ch02_vectors").mkdir(parents=True)
        (tmp_path / "ann" / name / "ch02_vectors/vector.py").touch()
    (note,) = boxed(tmp_path / "ann")[0].notes
    assert r"a\udcff\n\x1b/ch02_vectors was taken" in note


# Zips


@pytest.mark.parametrize("method", [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED])
def test_both_usual_compressions_are_read(tmp_path: Path, method: int) -> None:
    made = make_zip(tmp_path, {"ch02_vectors/vector.py": CODE * 100}, method)
    assert boxed(made)[1] == {"ch02_vectors/vector.py": CODE * 100}


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_other_compressions_are_refused(tmp_path: Path, method: int) -> None:
    made = make_zip(tmp_path, {"ch02_vectors/vector.py": CODE * 100}, method)
    assert reason(made) == "it is compressed in an unusual way: make an ordinary zip"


def test_a_zip_written_as_a_stream_and_with_a_comment_is_read(tmp_path: Path) -> None:
    """Its sizes stand behind each file and in the directory alone."""
    with (tmp_path / "ann.zip").open("wb") as file:
        file.seekable = lambda: False  # type: ignore[method-assign]
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as stream:
            stream.writestr("ch02_vectors/vector.py", CODE)
            stream.comment = b"with my PK best wishes"
    assert boxed(tmp_path / "ann.zip")[1] == {"ch02_vectors/vector.py": CODE}


@pytest.mark.parametrize(
    "name",
    ["./ch02_vectors/vector.py", "ch02_vectors\\vector.py", "my work\\a\\ch02_vectors\\vector.py"],
)
def test_paths_as_odd_tools_write_them(tmp_path: Path, name: str) -> None:
    assert boxed(special_zip(tmp_path, name))[1] == {"ch02_vectors/vector.py": CODE}


@pytest.mark.parametrize("flags", [0, 1 << 11])
def test_names_in_any_encoding_are_read(tmp_path: Path, flags: int) -> None:
    """Bit 11 promises UTF-8, and may lie."""
    made = special_zip(tmp_path, "ab/ch02_vectors/vector.py", fields={"flags": flags})
    made.write_bytes(made.read_bytes().replace(b"ab/", b"\x81\xff/"))
    assert boxed(made)[1] == {"ch02_vectors/vector.py": CODE}


@pytest.mark.parametrize(
    "name",
    [
        "/ch02_vectors/vector.py",
        "/home/ann/work/course/ch02_vectors/vector.py",
        "../ch02_vectors/vector.py",
        "a/../../ch02_vectors/vector.py",
        "./../ch02_vectors/vector.py",
        "..\\ch02_vectors\\vector.py",
        "\\\\host\\share\\ch02_vectors\\vector.py",
        "C:\\ch02_vectors\\vector.py",
        "C:/Users/ann/work/ch02_vectors/vector.py",
    ],
)
def test_paths_that_lead_out_of_the_zip(tmp_path: Path, name: str) -> None:
    assert reason(special_zip(tmp_path, name)) == (
        "its path in the zip is absolute or has dots in it"
    )
    outside = [path for path in tmp_path.rglob("vector.py") if ".box-" not in str(path)]
    assert outside == []


def test_a_sound_path_counts_before_one_that_leads_out(tmp_path: Path) -> None:
    made = make_zip(tmp_path, {"../ch02_vectors/vector.py": b"1", "a/ch02_vectors/vector.py": b"2"})
    staged, files = boxed(made)
    assert files == {"ch02_vectors/vector.py": b"2"}
    assert staged.missing == {}


@pytest.mark.parametrize(
    ("mode", "words"),
    [
        (stat.S_IFLNK | 0o777, "it is a symbolic link"),
        (stat.S_IFIFO | 0o644, "it is no regular file"),
        (stat.S_IFCHR | 0o644, "it is no regular file"),
        (stat.S_IFDIR | 0o755, "it is a folder"),
    ],
)
def test_entries_of_other_kinds_are_refused(tmp_path: Path, mode: int, words: str) -> None:
    assert reason(special_zip(tmp_path, mode=mode)) == words


def test_an_entry_without_a_mode_is_a_file(tmp_path: Path) -> None:
    assert boxed(special_zip(tmp_path, mode=0))[1] == {"ch02_vectors/vector.py": CODE}


@pytest.mark.parametrize("name", ["ch02_vectors/vector.py/", "ch02_vectors\\vector.py\\"])
def test_a_folder_with_the_name_of_a_module(tmp_path: Path, name: str) -> None:
    assert reason(special_zip(tmp_path, name, mode=0)) == "it is a folder"


def test_a_chapters_folder_that_is_a_link_in_the_zip(tmp_path: Path) -> None:
    staged = boxed(special_zip(tmp_path, "a/ch02_vectors", mode=stat.S_IFLNK | 0o777))[0]
    assert staged.missing.keys() == {"ch02_vectors.vector", "ch02_vectors.exercises"}
    assert "its folder is a symbolic link" in staged.missing["ch02_vectors.vector"]


def test_an_encrypted_entry_is_refused(tmp_path: Path) -> None:
    made = special_zip(tmp_path, fields={"flags": 1})
    assert reason(made) == "it is encrypted in the zip: zip it without a password"


@pytest.mark.parametrize("second", ["ch02_vectors/vector.py", "ch02_vectors\\vector.py"])
def test_one_name_twice_is_refused(tmp_path: Path, second: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # zipfile doubts it too
        with zipfile.ZipFile(tmp_path / "ann.zip", "w") as file:
            for content in (b"good", b"bad", b"good"):
                file.writestr("ch02_vectors/vector.py", content)
            file.writestr(second, b"other")
            file.writestr("ch02_vectors/exercises.py", CODE)
    staged, files = boxed(tmp_path / "ann.zip")
    assert files == {"ch02_vectors/exercises.py": CODE}
    assert staged.missing["ch02_vectors.vector"].endswith(": it is in the zip twice")


@pytest.mark.parametrize("method", [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED])
def test_a_changed_byte_is_found(tmp_path: Path, method: int) -> None:
    made = make_zip(tmp_path, {"ch02_vectors/vector.py": b"some code"}, method)
    data = bytearray(made.read_bytes())
    data[30 + len("ch02_vectors/vector.py") + 4] ^= 1
    made.write_bytes(data)
    assert reason(made) == "it is damaged in the zip: zip the folder again"


@pytest.mark.parametrize(
    "fields",
    [{"packed": 3}, {"size": 3}, {"packed": 999_999}, {"method": 8}],
)
def test_sizes_and_methods_that_lie(tmp_path: Path, fields: dict[str, int]) -> None:
    made = special_zip(tmp_path, fields=fields)
    assert reason(made) == "it is damaged in the zip: zip the folder again"


@pytest.mark.parametrize("place", ["PK\3\4", "offset"])
def test_a_file_that_is_not_where_the_directory_says(tmp_path: Path, place: str) -> None:
    made = special_zip(tmp_path)
    data = bytearray(made.read_bytes())
    if place == "offset":
        struct.pack_into("<L", data, data.index(b"PK\1\2") + 42, 4_000_000_000)
    else:
        data[:4] = b"junk"
    made.write_bytes(data)
    assert reason(made) == "it is damaged in the zip: zip the folder again"


DAMAGED = "the zip is damaged, or no ordinary zip: zip the folder again"


def test_what_is_no_zip(tmp_path: Path) -> None:
    for content in (
        b"",
        b"PK",
        b"PK\5\6",
        b"PK\5\6" + b"\0" * 17,
        b"Rar!\x1a\7",
        b"\xff" * 100_000,
    ):
        (tmp_path / "ann.zip").write_bytes(content)
        assert reason_for_all(tmp_path / "ann.zip") == DAMAGED


def test_a_zip_cut_or_changed_anywhere_is_told_and_never_raises(tmp_path: Path) -> None:
    made = make_zip(tmp_path, {"a/ch02_vectors/vector.py": b"one", "ch02_vectors/x.txt": b"two"})
    data = made.read_bytes()
    for length in range(len(data) - 1):
        made.write_bytes(data[:length])
        assert reason_for_all(made) == DAMAGED
    directory = data.index(b"PK\1\2")
    for position in range(len(data)):
        for value in (0, 255, data[position] ^ 1):
            made.write_bytes(data[:position] + bytes([value]) + data[position + 1 :])
            staged, files = boxed(made)
            assert files in ({}, {"ch02_vectors/vector.py": b"one"})
            if position < directory:
                assert len(staged.missing) + len(files) == 1
            elif position < directory + 4:  # "PK" and the kind of record
                assert staged.missing.keys() == MODULES
            shutil.rmtree(next(tmp_path.glob(".box-*")))


def test_a_zip_of_another_count_than_it_says_is_damaged(tmp_path: Path) -> None:
    made = make_zip(tmp_path, {"ch02_vectors/vector.py": CODE, "ch02_vectors/exercises.py": CODE})
    data = bytearray(made.read_bytes())
    for count in (0, 1, 3):
        struct.pack_into("<H", data, len(data) - 12, count)
        made.write_bytes(data)
        assert reason_for_all(made) == DAMAGED


def test_a_zip_with_nothing_in_it(tmp_path: Path) -> None:
    staged, files = boxed(make_zip(tmp_path, {}))
    assert (staged.missing, staged.notes, files) == ({}, [], {})


def test_a_zip_that_is_too_large_is_not_opened(tmp_path: Path) -> None:
    made = make_zip(tmp_path, {"ch02_vectors/vector.py": CODE, "film": bytes(19_999_000)}, 0)
    assert boxed(made)[1] == {"ch02_vectors/vector.py": CODE}
    made = make_zip(tmp_path, {"ch02_vectors/vector.py": CODE, "film": bytes(20_000_000)}, 0)
    assert reason_for_all(made) == "the zip is larger than 20,000,000 bytes"


def test_as_many_entries_as_allowed_are_read(tmp_path: Path) -> None:
    files = {"ch02_vectors/vector.py": CODE} | {f"{number}.txt": b"" for number in range(4_999)}
    assert boxed(make_zip(tmp_path, files))[1] == {"ch02_vectors/vector.py": CODE}
    made = make_zip(tmp_path, files | {"one more.txt": b""})
    assert reason_for_all(made) == "the zip has more than 5,000 files and folders in it"


def directory_of(entries: int, count: int, extra: bytes = b"") -> bytes:
    """A zip that is all directory, as zipfile would not write it."""
    fields = [b"PK\1\2", *[0] * 9, 1, len(extra), *[0] * 5]
    directory = (struct.pack("<4s6H3L5H2L", *fields) + b"a" + extra) * entries
    return directory + struct.pack("<4s4H2LH", b"PK\5\6", 0, 0, 0, count, len(directory), 0, 0)


@pytest.mark.parametrize(
    ("entries", "count", "extra"),
    [(400_000, 65_535, b""), (400_000, 0, b""), (400_000, 5_000, b""), (300, 300, bytes(65_532))],
)
def test_a_huge_directory_costs_no_time(
    tmp_path: Path, entries: int, count: int, extra: bytes
) -> None:
    (tmp_path / "ann.zip").write_bytes(directory_of(entries, count, extra))
    begin = time.process_time()
    staged, files = boxed(tmp_path / "ann.zip")
    assert time.process_time() - begin < 1.0
    assert files == {}
    assert len(staged.missing) == (len(MODULES) if entries > 5_000 else 0)


def test_long_names_cost_no_time(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "ann.zip", "w") as file:
        for number in range(140):
            file.writestr("a/" * 32_000 + f"{number}/ch02_vectors/vector.py", b"")
    begin = time.process_time()
    staged, files = boxed(tmp_path / "ann.zip")
    assert time.process_time() - begin < 1.0
    assert (staged.missing, files) == ({}, {})


@pytest.mark.parametrize("said", [200_000_000, 10])
def test_a_bomb_costs_neither_memory_nor_time(tmp_path: Path, said: int) -> None:
    made = make_zip(tmp_path, {"ch02_vectors/vector.py": bytes(200_000_000)})
    data = bytearray(made.read_bytes())
    struct.pack_into("<L", data, data.index(b"PK\1\2") + 24, said)
    made.write_bytes(data)
    tracemalloc.start()
    try:
        begin = time.process_time()
        assert reason(made) == "it is larger than 1,000,000 bytes"
        assert time.process_time() - begin < 1.0
        assert tracemalloc.get_traced_memory()[1] < 25_000_000  # of which 20 are for any zip
    finally:
        tracemalloc.stop()


def test_a_stream_that_is_long_and_inflates_to_little_is_not_inflated(tmp_path: Path) -> None:
    """Empty blocks give nothing, and could be millions."""
    packed = b"\0\0\0\xff\xff" * 3_000_000 + zlib.compress(CODE, wbits=-15)
    name = b"ch02_vectors/vector.py"
    sizes = (zlib.crc32(CODE), len(packed), len(CODE), len(name))
    header = struct.pack("<4s5H3L2H", b"PK\3\4", 20, 0, 8, 0, 0, *sizes, 0) + name + packed
    entry = struct.pack("<4s6H3L5H2L", b"PK\1\2", 20, 20, 0, 8, 0, 0, *sizes, *[0] * 6) + name
    end = struct.pack("<4s4H2LH", b"PK\5\6", 0, 0, 1, 1, len(entry), len(header), 0)
    (tmp_path / "ann.zip").write_bytes(header + entry + end)
    assert reason(tmp_path / "ann.zip") == "it is larger than 1,000,000 bytes"


# The submissions of a class


def students(folder: Path) -> list[str]:
    return [submission.student for submission in find_submissions(folder)[0]]


def test_folders_and_zips_are_submissions_sorted_by_student(tmp_path: Path) -> None:
    for name in ("zoe", "[red]Åsa B", "ann.zip.d", "bob-b"):
        (tmp_path / name).mkdir()
    for name in ("bob.zip", "Carl.ZIP", "d.e.Zip"):
        (tmp_path / name).touch()
    found, notes = find_submissions(tmp_path)
    assert [(item.student, item.path.name) for item in found] == [
        ("Carl", "Carl.ZIP"),
        ("[red]Åsa B", "[red]Åsa B"),
        ("ann.zip.d", "ann.zip.d"),
        ("bob", "bob.zip"),
        ("bob-b", "bob-b"),
        ("d.e", "d.e.Zip"),
        ("zoe", "zoe"),
    ]
    assert all(item.path.parent == tmp_path for item in found)
    assert notes == []


def test_a_folder_may_be_called_like_a_zip(tmp_path: Path) -> None:
    (tmp_path / "ann.zip").mkdir()
    (tmp_path / "ann").mkdir()
    assert students(tmp_path) == ["ann", "ann.zip"]


def test_what_is_left_out_is_noted_unless_it_is_to_be_expected(tmp_path: Path) -> None:
    for name in ("ann", "__MACOSX", "__pycache__", ".git"):
        (tmp_path / name).mkdir()
    for name in ("marks.csv", ".DS_Store", "notes.txt", "bob.tar", "odd\n.txt"):
        (tmp_path / name).touch()
    (tmp_path / "carl").symlink_to("ann")
    (tmp_path / "dan.zip").symlink_to("notes.txt")
    found, notes = find_submissions(tmp_path)
    assert [item.student for item in found] == ["ann"]
    assert sorted(notes) == [
        "bob.tar was left out: it is neither a folder nor a .zip file",
        "carl was left out: it is a symbolic link",
        "dan.zip was left out: it is a symbolic link",
        "notes.txt was left out: it is neither a folder nor a .zip file",
        "odd\\n.txt was left out: it is neither a folder nor a .zip file",
    ]


def test_a_class_that_is_none_is_refused(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").touch()
    with pytest.raises(ValueError, match="has no submissions"):
        find_submissions(tmp_path)
    for path in (tmp_path / "notes.txt", tmp_path / "nowhere"):
        with pytest.raises(ValueError, match=f"must be in a folder, got '.*{path.name}'"):
            find_submissions(path)


@pytest.mark.parametrize("other", ["ann.zip", "ann.ZIP"])
def test_a_student_who_is_there_twice_is_refused(tmp_path: Path, other: str) -> None:
    (tmp_path / "ann").mkdir()
    (tmp_path / other).touch()
    with pytest.raises(ValueError, match=f"once, got 'ann' and '{other}'"):
        find_submissions(tmp_path)


@pytest.mark.skipif(os.name != "posix", reason="other systems have no such names")
def test_strange_names_are_told_apart_and_can_be_printed(tmp_path: Path) -> None:
    names = ["a\n", "a\\n", "a\\\\n", "a\r", "a\udcff", "a\\udcff", "a\x1b[31m", "a\x7f", "a\u202e"]
    names += ["a\u200b", "a", "a ", "é", "e\u0301", "\udce9", "=1+1", "-x", "x" * 255, "x" * 254]
    for name in names:
        (tmp_path / name).mkdir()
    found = students(tmp_path)
    assert len(set(found)) == len(names)
    assert len({file_name(student) for student in found}) == len(names)
    for student in found:
        assert student.isprintable()
        assert student.encode().decode() == student
    assert {"a", "a ", "é", "=1+1", "-x", "a\\n", "a\\udcff", "x" * 255} <= set(found)


# The names of reports


@pytest.mark.parametrize(
    "student",
    ["ann", "[red]Åsa B", "Жанна", "李小龙", "O'Neil, Shaq (2)", "a.b", "=1+1", "x" * 100, "a-b"],
)
def test_harmless_names_stay_as_they_are(student: str) -> None:
    assert file_name(student) == student


@pytest.mark.parametrize(
    "student",
    [
        *("", ".", "..", ".ann", "a/b", "a\\b", "a\nb", "a\0b", "\udcff", "x" * 101, "é" * 51),
        *("a:b", "CON", "nul.txt", "ann-0123abcd"),
    ],
)
def test_other_names_are_changed_and_marked(student: str) -> None:
    name = file_name(student)
    assert name != student
    _, dash, mark = name.rpartition("-")
    assert (dash, len(mark)) == ("-", 8)
    assert int(mark, 16) >= 0
    assert file_name(student) == name


STRANGE = st.text(
    st.characters(codec=None) | st.sampled_from("/\\.\n\0-0a\udcff\u202e:é"), max_size=300
)


@given(st.lists(STRANGE, unique=True, min_size=1, max_size=20))
def test_file_names_are_safe_short_and_each_students_own(names: list[str]) -> None:
    # What one name turns into could be another's own.
    names = sorted({*names, *map(file_name, names), *(file_name(n) + "x" for n in names)})
    made = [file_name(name) for name in names]
    assert len(set(made)) == len(names)
    for name in made:
        assert 0 < len(name.encode()) <= 100
        assert not name.startswith(".")
        assert not set(name) & set("/\\\0")
        assert name.isprintable()


@given(name=STRANGE)
def test_a_file_of_that_name_can_be_written(name: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / (file_name(name) + ".json.tmp")
        path.write_text("x")
        assert list(Path(folder).iterdir()) == [path]
