"""Machines that cannot write files or have odd names, and tables that no spreadsheet writes."""

from __future__ import annotations

import errno
import os
import resource
import subprocess
import sys
from datetime import UTC, datetime
from pathlib import Path

import pytest

from autograder.commands import sentence
from autograder.course.late import late_of
from autograder.course.lateness import times_of
from autograder.course.model import Deadline
from autograder.files import is_new, replace_bytes, temporary_of
from autograder.handouts import handout
from autograder.manifest import ROOT, load_chapters
from autograder.submissions.class_list import read_class
from small import RIGHT, hand_in, make_root
from small_class import grade, scores

FULL = "Free some space on that disk, and run the same command again"


def full(*_: object, **__: object) -> None:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def test_a_file_is_replaced_as_a_whole_or_not_at_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, link = tmp_path / "a.txt", tmp_path / "link"
    link.symlink_to(path)
    replace_bytes(path, b"old")
    path.chmod(0o600)
    replace_bytes(link, b"new")
    assert link.is_symlink()
    assert path.read_bytes() == b"new"
    assert path.stat().st_mode & 0o777 == 0o600
    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(OSError, match="No space") as caught:
        replace_bytes(path, b"newer")
    assert path.read_bytes() == b"new"
    assert sorted(tmp_path.iterdir()) == [path, link]
    assert sentence(caught.value) == f"[Errno 28] No space left on device: '{path}'. {FULL}"


def test_a_file_that_is_not_there_is_named_in_plain_english(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="No such file") as caught:
        (tmp_path / "roster.csv").read_bytes()
    assert sentence(caught.value) == f"there is no '{tmp_path}/roster.csv'"


def test_a_folder_is_new_until_its_first_file_is_written(tmp_path: Path) -> None:
    first = tmp_path / "new/first"
    assert is_new(tmp_path / "new", first)
    first.parent.mkdir()
    temporary_of(first).touch()
    assert is_new(tmp_path / "new", first)
    first.touch()
    assert not is_new(tmp_path / "new", first)


def test_a_command_that_may_not_write_says_what_to_do(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "autograder", "release", "2", "--out", str(tmp_path / "out")],
        cwd=ROOT,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10, 10)),
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 2
    assert "release: [Errno 27] File too large" in done.stderr
    assert done.stderr.endswith("A limit on the size of files is too low here (see ulimit -f)\n")


@pytest.mark.parametrize("exists", [False, True])
def test_a_hand_out_is_whole_or_not_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, exists: bool
) -> None:
    out, part = tmp_path / "out", tmp_path / ".out.part"
    part.mkdir()  # of a run that was killed
    if exists:
        out.mkdir()
    with monkeypatch.context() as context:
        context.setattr(handout, "make_stubs", full)
        with pytest.raises(OSError, match="No space"):
            handout.make_handout(load_chapters()[:1], [], out)
    assert [*tmp_path.rglob("*")] == ([out] if exists else [])


def test_names_are_in_utf_8_whatever_the_locale_and_without_a_home(tmp_path: Path) -> None:
    temporary = tmp_path / "Größe [/] 日本"
    temporary.mkdir(parents=True)
    settings = {"LC_ALL": "C", "PYTHONUTF8": "0", "HOME": "/nowhere", "TMPDIR": str(temporary)}
    code = (
        "import sys, os, tempfile; from autograder.commands import prepare; prepare();"
        "print(sys.argv[1], os.listdir(sys.argv[1]), sys.flags.utf8_mode);"
        "sys.argv[1:] = ['check', '--exercise', 'B2.1', '--engine', 'solutions'];"
        "from autograder.__main__ import main; sys.exit(main())"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "Größe [")],
        cwd=ROOT,
        env=os.environ | settings,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"{tmp_path / 'Größe ['} ['] 日本'] 1\n")
    assert "All checks of B2.1 pass." in done.stdout


# Names that mean something on a terminal, and odd tables


def test_no_name_in_a_roster_stops_the_class(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A student chooses the name that Canvas exports, and rich reads [/] as the end of a style."""
    root = make_root(tmp_path / "root")
    hand_in(tmp_path / "class", "7", RIGHT)
    name = "Ann [/] [blink]B[/blink] :bomb:"
    roster = tmp_path / "roster.csv"
    roster.write_text(f"id,name,email,login\n7,{name},,\n", encoding="utf-8")
    out = tmp_path / "out [b]"
    assert grade(tmp_path / "class", out, root, roster=roster) == 0
    assert scores(out) == {name: 6.0}
    screen = capsys.readouterr().out
    assert f"1/1 {name}" in screen
    assert "out [b]" in screen


def test_every_console_prints_texts_as_they_are() -> None:
    made = [
        path.name
        for folder in ("autograder", "lab", "plots", "scenes", "studies", "web")
        for path in (ROOT / folder).rglob("*.py")
        if "node_modules" not in path.parts and "Console(" in path.read_text(encoding="utf-8")
    ]
    assert made == ["wrapping.py"], "use plain_console() instead"


SUBMITTED = "student,submitted\nann,"
GITHUB = "student_repository_name,submission_timestamp\nann,"


@pytest.mark.parametrize(
    ("name", "text", "is_refused"),
    [
        ("times.csv", f"{SUBMITTED}0001-01-01 00:00+14:00", True),
        ("times.csv", f"{SUBMITTED}{200_000 * '1'}", True),
        ("grades.csv", f"{GITHUB}9999-12-31T23:59:59-14:00", False),
        ("submission_metadata.yml", 1200 * "[", True),
        ("submission_metadata.yml", "a: !!python/object/apply:os.system ['true']", True),
        ("submission_metadata.yml", "ann:\n  :created_at: 0001-01-01 00:00:00 +14:00", False),
    ],
)
def test_odd_times_are_refused_in_a_sentence_or_unknown(
    tmp_path: Path, name: str, text: str, is_refused: bool
) -> None:
    (tmp_path / name).write_text(text, encoding="utf-8")
    (tmp_path / "ann").mkdir()
    if is_refused:
        with pytest.raises(ValueError, match=name):
            times_of(tmp_path, read_class(tmp_path), UTC)
        return
    known, _ = times_of(tmp_path, read_class(tmp_path), UTC)
    late = late_of(Deadline(datetime(2026, 1, 1, tzinfo=UTC)), [], known.get("ann"), 1.0)
    assert late.days is None
