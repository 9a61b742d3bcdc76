"""Setting up reports in one sentence what is missing, and installs the pinned packages."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from autograder import make_venv
from autograder.manifest import ROOT


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
    monkeypatch.setattr(make_venv, "install", lambda _: words)
    made = subprocess.CompletedProcess([], 0, "")  # pretend, since a real one takes seconds
    monkeypatch.setattr(make_venv.subprocess, "run", lambda *_, **__: made)
    with pytest.raises(SystemExit, match=sentence):
        make_venv.main()
    assert not (tmp_path / ".venv/ready").exists()


def test_a_whole_environment_is_marked_as_ready(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(make_venv, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(make_venv, "install", lambda _: "")
    make_venv.main()
    assert (tmp_path / ".venv/ready").exists()
    assert "Set up: .venv is ready." in capsys.readouterr().out


PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS = [each for extra in PROJECT["optional-dependencies"].values() for each in extra]


def pins(lock: str) -> dict[str, str]:
    """Return the entries of a lock, keyed by name==version."""
    text = (ROOT / lock).read_text(encoding="utf-8")
    return {entry.split()[0]: entry for entry in re.split(r"(?m)^(?=[a-z])", text)[1:]}


@pytest.mark.parametrize(
    ("lock", "wanted"), [("requirements.lock", PROJECT["dependencies"]), ("extras.lock", EXTRAS)]
)
def test_a_lock_pins_what_the_project_asks_for_with_hashes(lock: str, wanted: list[str]) -> None:
    for requirement in wanted:
        assert re.fullmatch(r"[a-z0-9-]+==[0-9.]+", requirement), "pinned exactly"
        assert requirement in pins(lock)
    for entry in pins(lock).values():
        assert re.match(r"[a-z0-9-]+==\S+ ", entry)
        assert "--hash=sha256:" in entry
        assert "://" not in entry, "the lock names packages, not their addresses"


def test_no_package_is_pinned_twice() -> None:
    """Within one lock, two Pythons may still need two versions of a package."""
    students, extras = (
        {pin.partition("==")[0] for pin in pins(lock)}
        for lock in ("requirements.lock", "extras.lock")
    )
    assert students & extras == set()
    assert {"distributed", "cosmic-ray"} <= extras, "students do not install these"


@pytest.mark.skipif(shutil.which("make") is None, reason="there is no make here")
def test_the_extras_are_installed_on_top_of_what_students_install() -> None:
    command = ["make", "--dry-run", "--old-file=.venv/ready", "--what-if=extras.lock"]
    done = subprocess.run(
        [*command, ".venv/extras"], cwd=ROOT, capture_output=True, encoding="utf-8", check=True
    )
    assert "--require-hashes -r requirements.lock -r extras.lock\n" in done.stdout
