"""Setting up reports in one sentence what is missing, and installs the pinned packages."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from autograder import make_venv


def test_a_python_that_is_too_old_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "version_info", (3, 10, 4))
    with pytest.raises(SystemExit, match=r"is Python 3\.10, .* needs 3\.11 or newer\. Install one"):
        make_venv.check_python()


@pytest.mark.parametrize("module", ["venv", "ensurepip"])
def test_a_missing_venv_module_is_named_with_the_package_to_install(
    module: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(SystemExit, match=r"has no venv module\. Install it .*apt install python3"):
        make_venv.check_python()


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            "WARNING: Retrying (Retry(total=0)) after connection broken by 'NewConnectionError'",
            r"\(PyPI\) cannot be reached\. Check the network",
        ),
        ("[Errno -3] Temporary failure in name resolution", "cannot be reached"),
        ("ERROR: No matching distribution found for numpy==9", "Its output ends with:\n.*numpy==9"),
        ("ResolutionImpossible", "Its output ends with"),
        (
            "Looking in indexes: http://proxy.here\nERROR: hashes do not match",
            "Its output ends with",
        ),
    ],
)
def test_what_pip_could_not_do_is_said_and_nothing_counts_as_ready(
    words: str, sentence: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(make_venv, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(make_venv, "run_pip", lambda _: words)
    made = subprocess.CompletedProcess([], 0, "")  # pretend, since a real one takes seconds
    monkeypatch.setattr(make_venv.subprocess, "run", lambda *_, **__: made)
    with pytest.raises(SystemExit, match=sentence):
        make_venv.main()
    assert not (tmp_path / ".venv/ready").exists()


def test_a_whole_environment_is_marked_as_ready(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(make_venv, "VENV", tmp_path / ".venv")
    installed = []
    monkeypatch.setattr(make_venv, "run_pip", lambda lock: installed.append(lock.name) or "")
    make_venv.main()
    assert (tmp_path / ".venv/ready").exists()
    assert "Set up: .venv is ready." in capsys.readouterr().out
    assert installed == ["requirements.lock"]


def test_a_group_is_added_to_an_environment_which_is_made_first_if_it_is_missing(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(make_venv, "VENV", tmp_path / ".venv")
    installed = []
    monkeypatch.setattr(make_venv, "run_pip", lambda lock: installed.append(lock.name) or "")
    make_venv.main("pictures")
    make_venv.main("everything")
    assert installed == ["requirements.lock", "pictures.lock", "everything.lock"]
    for done in ("ready", "pictures", "teaching", "everything"):
        assert (tmp_path / ".venv" / done).exists(), "everything has the packages of all groups"


def test_a_group_that_pip_could_not_install_does_not_count_as_added(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(make_venv, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(make_venv, "run_pip", lambda _: "")
    make_venv.main()
    monkeypatch.setattr(make_venv, "run_pip", lambda _: "name resolution")
    with pytest.raises(SystemExit, match="cannot be reached"):
        make_venv.main("pictures")
    assert not (tmp_path / ".venv/pictures").exists()


@pytest.mark.parametrize("name", ["scipy", "stubs", "requirements"])
def test_what_is_no_group_is_an_error_that_lists_the_groups(name: str) -> None:
    with pytest.raises(SystemExit, match=r"choose from everything, pictures, teaching"):
        make_venv.main(name)
