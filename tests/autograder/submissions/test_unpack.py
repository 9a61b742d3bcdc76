"""Submissions as Canvas and Moodle export them: zips of a class, and the names in them."""

from __future__ import annotations

import stat
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from autograder.manifest import load_chapters
from autograder.submissions import unpack
from autograder.submissions.class_list import read_class
from autograder.submissions.unpack import class_folder
from staging import CODE, EXERCISES, OF_CH03, TAKEN, VECTOR, boxed, make_folder, zip_of

WORK = zip_of({f"work/{VECTOR}": CODE})


def class_zip(folder: Path, files: Mapping[Any, bytes]) -> Path:
    path = folder / "lab1.zip"
    path.write_bytes(zip_of(files))
    return path


def test_a_download_from_canvas_is_read_and_the_last_upload_counts(tmp_path: Path) -> None:
    names = ("doejane_77_101_work.zip", "doejane_77_205_work-1.zip", "doejane_77_205_work-2.zip")
    late = "leebo_LATE_78_150_my_work-1.zip"
    zipped = class_zip(tmp_path, dict.fromkeys((*names, late, "anon_x7Yk2_9_w.zip"), WORK))
    submissions = read_class(class_folder(zipped)).submissions
    by_name = {one.student: one for one in submissions}
    assert {name: one.path.name for name, one in by_name.items()} == {
        "anon_x7Yk2": "anon_x7Yk2_9_w.zip",
        "doejane_77": "doejane_77_205_work-2.zip",
        "leebo_78": late,
    }
    assert {name for name, one in by_name.items() if one.late} == {"leebo_78"}
    last = f"'{names[2]}' was graded, and "
    why = "it was uploaded earlier. Put all files into one zip"
    assert by_name["doejane_77"].notes == (
        f"{last}'{names[0]}' was not: {why}",
        f"{last}'{names[1]}' was not: {why}",
    )
    for one in submissions:
        assert boxed(one.path) == TAKEN


def test_whoever_uploaded_anything_to_moodle_has_handed_in(tmp_path: Path) -> None:
    files = {
        "Ann Lee_12_{}_file/work.zip": WORK,
        f"Bo Ek_13_{{}}_file_/{VECTOR}": CODE,
        "Bo Ek_13_{}_file_/film.mp4": b"x",
        "Cy_14_{}_file_work.zip": WORK,
        "Di_15_{}_onlinetext/onlinetext.html": b"hello",
        **dict.fromkeys(("Ed_16_{}_file/README.md", "Flo_17_{}_file/.gitignore"), b"x"),
        **dict.fromkeys(("Gus_18_{}_file/a\x01.zip", ". Suharto_19_{}_file/work.zip"), b"x"),
        "می\u200cسر_20_{}_file/work\u202f1.zip": b"x",
        **dict.fromkeys((".DS_Store", "__MACOSX/Ann Lee_12_{}_file/._README.md"), b"x"),
    }
    zipped = class_zip(tmp_path, {n.format("assignsubmission"): files[n] for n in files})
    people = read_class(class_folder(zipped))
    found = {one.student: one for one in people.submissions}
    names = ["Ann Lee_12", "Bo Ek_13", "Cy_14", "Di_15", "Ed_16", "Flo_17", "Gus_18"]
    assert [*found] == [". Suharto_19", *names, "می\\u200cسر_20"]
    for student in names[:3]:
        assert boxed(found[student].path) == TAKEN
    typed = "cannot be graded: it is text that was typed into the platform"
    assert [one.student for one in found.values() if one.nothing.endswith(typed)] == ["Di_15"]
    assert people.notes == []
    (film,) = tmp_path.rglob("film.mp4")
    assert film.stat().st_size == 0, "what cannot count is not unpacked, but known"


def test_every_file_that_students_hand_in_is_unpacked(tmp_path: Path) -> None:
    files = [f"{chapter.name}/{name}" for chapter in load_chapters() for name in chapter.handed_in]
    zipped = class_zip(tmp_path, {f"ann/{file}": b"" for file in files})
    folder = class_folder(zipped) / "ann"
    there = [file.relative_to(folder).as_posix() for file in folder.rglob("*") if file.is_file()]
    assert sorted(there) == sorted(files)


def test_the_zips_in_a_folder_count_like_folders(tmp_path: Path) -> None:
    zips = {"a.zip": zip_of({VECTOR: CODE}), "b.zip": zip_of({EXERCISES: CODE}), "c.zip": b"no zip"}
    folder = make_folder(tmp_path, zips)
    (folder / "d.zip").symlink_to(folder / "a.zip")
    files, missing, notes = boxed(folder)
    assert files == {VECTOR: CODE}
    assert set(missing) == set(OF_CH03), "these could have been in the damaged zip"
    assert notes[1:] == ["there are 2 folders called ch02_vectors: 'a.zip/ch02_vectors' was used"]
    assert notes[0].startswith("'c.zip' was not opened: the zip is damaged")


def test_what_is_unpacked_is_kept_until_the_zip_changes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    zipped = class_zip(tmp_path, {"ann.zip": WORK, "bob/": b"", "../notes.zip": b""})
    folder = class_folder(zipped)
    assert folder == tmp_path / "lab1"
    (folder / "marks.csv").write_text("mine", encoding="utf-8")
    (folder / "ann.zip").unlink()
    capsys.readouterr()
    class_folder(zipped)
    assert not (folder / "ann.zip").exists()
    assert "../notes.zip was left out" in capsys.readouterr().out
    class_zip(tmp_path, {"ann.zip": WORK, "cem.zip": WORK})
    class_folder(zipped)
    names = {path.name for path in folder.iterdir()}
    assert names == {"ann.zip", "cem.zip", "marks.csv", ".unpacked.json"}
    assert (folder / "marks.csv").read_text(encoding="utf-8") == "mine"


def test_marks_are_not_used_for_the_zip_of_another_assignment(tmp_path: Path) -> None:
    folder = class_folder(class_zip(tmp_path, {"doejane_77_101_w.zip": WORK}))
    (folder / "marks.csv").write_text("mine", encoding="utf-8")
    zipped = class_zip(tmp_path, {"doejane_77_901_w.zip": WORK})
    with pytest.raises(ValueError, match=r"may be of another assignment, and marks.csv there not"):
        class_folder(zipped)
    assert (folder / "doejane_77_101_w.zip").exists()
    (folder / "marks.csv").unlink()
    class_folder(zipped)
    assert [path.name for path in folder.glob("*.zip")] == ["doejane_77_901_w.zip"]


def test_nothing_of_ones_own_is_overwritten(tmp_path: Path) -> None:
    zipped = class_zip(tmp_path, {"ann.zip": WORK})
    (tmp_path / "lab1").mkdir()
    for name, text in (("mine.txt", ""), (".unpacked.json", "{"), (".unpacked.json", "{}")):
        (tmp_path / "lab1" / name).write_text(text, encoding="utf-8")
        with pytest.raises(ValueError, match="already exists, but was not unpacked"):
            class_folder(zipped)
        (tmp_path / "lab1" / name).unlink()
    class_folder(zipped)
    (tmp_path / "lab1/cem.zip").symlink_to("/etc/passwd")
    class_zip(tmp_path, {"cem.zip": WORK})
    with pytest.raises(ValueError, match="did not come from lab1"):
        class_folder(zipped)


def test_a_hostile_zip_of_a_class_writes_nowhere_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(unpack, "LARGEST_FILE", 10_000)
    link = zipfile.ZipInfo("carl/x.py")
    link.create_system, link.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    below = tmp_path / "deep" / "down"
    below.mkdir(parents=True)
    bad = [
        *("../evil.zip", "/evil.zip", "ann/../../evil.py", "..\\evil.zip", "C:\\evil.zip", ".."),
        *("a\nb.zip", "dee.zip/x.py", "x" * 300 + ".zip", "bomb_1_2_w.zip"),
    ]
    content = {name: b"\0" * 20_000 if "bomb" in name else WORK for name in bad}
    zipped = class_zip(
        below,
        {
            "dee.zip": WORK,
            link: b"/etc/passwd",
            **content,
            ".unpacked.json": b"{}",
            "marks.csv": b"x",
        },
    )
    class_folder(zipped)
    assert {path.name for path in tmp_path.rglob("*") if path.is_file()} == {
        *("lab1.zip", "dee.zip", ".unpacked.json", ".lab1.zip.lock"),
        "bomb_1_2_w.zip",  # empty, so that it is known who handed it in
    }
    assert (below / "lab1/bomb_1_2_w.zip").stat().st_size == 0
    notes = capsys.readouterr().out
    assert notes.count(" was left out: ") == len(bad) + 1, notes
    assert "bomb_1_2_w.zip was left out: it is larger than 10,000 bytes" in notes
    assert "carl/x.py was left out: it is not a regular file" in notes


@pytest.mark.parametrize(
    ("limit", "words"),
    [("MOST_FILES", "more than 1 files"), ("MOST_IN_ALL", "larger than 1 bytes")],
)
def test_a_zip_beyond_a_limit_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, limit: str, words: str
) -> None:
    zipped = class_zip(tmp_path, {"ann.zip": WORK, "bob.zip": WORK})
    monkeypatch.setattr(unpack, limit, 1)
    with pytest.raises(ValueError, match=words):
        class_folder(zipped)


def test_a_student_who_uploads_too_much_stops_nobody_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(unpack, "MOST_OF_ONE", 1_000)
    files = {f"ann/{n}.py": b"x" * 600 for n in range(3)}
    folder = class_folder(class_zip(tmp_path, {**files, "bob.zip": WORK}))
    assert [path.name for path in folder.glob("ann/*")] == ["0.py"]
    assert (folder / "bob.zip").exists()


@pytest.mark.parametrize("name", ["lab1.zip", "lab1.tar"])
def test_what_is_no_zip_is_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_bytes(b"no zip")
    with pytest.raises(ValueError, match=r"the zip is damaged|must be a folder or a \.zip file"):
        class_folder(tmp_path / name)
    assert not (tmp_path / "lab1").exists()
