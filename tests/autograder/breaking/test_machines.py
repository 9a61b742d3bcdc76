"""Machines on which files cannot be written, or on which their names are not in UTF-8."""

from __future__ import annotations

import errno
import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.commands import sentence
from autograder.files import is_new, replace_bytes, temporary_of
from autograder.handouts import handout
from autograder.manifest import ROOT, load_chapters
from typed import typed
from web.__main__ import put_in_place

FULL = "Free some space on that disk, and run the same command again"


def full(*_: object, **__: object) -> None:
    """Do what a full disk does."""
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


@pytest.mark.parametrize(
    ("command", "begins"),
    [("autograder release 2", "release: "), ("plots draw --chapter 2 --engine solutions", "")],
)
def test_a_command_that_may_not_write_says_what_to_do(
    command: str, begins: str, tmp_path: Path
) -> None:
    done = subprocess.run(
        [sys.executable, "-m", *command.split(), "--out", str(tmp_path / "out")],
        cwd=ROOT,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10, 10)),
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == (2 if begins else 1), "a picture that is not drawn is a diagnosis"
    said = done.stdout + done.stderr
    assert f"{begins}[Errno 27] File too large" in said
    assert said.endswith("A limit on the size of files is too low here (see ulimit -f)\n")


def test_a_study_that_cannot_write_is_a_sentence() -> None:
    done = typed("plots", "figures", "--out", "LICENSE/a")
    assert done.returncode == 2
    assert done.stderr.startswith("figures: [Errno 20] Not a directory: 'LICENSE/a")
    assert len(done.stderr.splitlines()) == 1


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


def test_a_site_replaces_an_earlier_one_also_after_a_kill(tmp_path: Path) -> None:
    out = tmp_path / "site"
    for number, earlier in enumerate((None, "site", ".site.new", ".site.old")):
        if earlier:
            (tmp_path / earlier).mkdir(exist_ok=True)
            (tmp_path / earlier / "old").touch()
        (tmp_path / "built").mkdir()
        (tmp_path / "built" / str(number)).touch()
        put_in_place(tmp_path / "built", out)
        assert [*tmp_path.rglob("*")] == [out, out / str(number)]


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
