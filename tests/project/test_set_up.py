"""Setting up says in one sentence what is missing, and installs what is pinned."""

from __future__ import annotations

import re
import sys
import tomllib
from pathlib import Path

import pytest

from autograder import make_venv
from autograder.manifest import ROOT


def test_a_python_that_is_too_old_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "version_info", (3, 10, 4))
    with pytest.raises(SystemExit, match=r"is Python 3\.10, .* needs 3\.11 or newer; install one"):
        make_venv.check_python()


@pytest.mark.parametrize("module", ["venv", "ensurepip"])
def test_a_missing_venv_module_is_named_with_the_package_to_install(
    module: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(SystemExit, match=r"has no venv module; install it .*apt install python3"):
        make_venv.check_python()


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            "WARNING: Retrying (Retry(total=0)) after connection broken by 'NewConnectionError'",
            r"\(PyPI\) cannot be reached; check the network",
        ),
        ("[Errno -3] Temporary failure in name resolution", "cannot be reached"),
        ("ERROR: No matching distribution found for numpy==9", "its last words:\n.*numpy==9"),
        ("ResolutionImpossible", "its last words"),
        ("Looking in indexes: http://proxy.here\nERROR: hashes do not match", "its last words"),
    ],
)
def test_what_pip_could_not_do_is_said_and_nothing_counts_as_ready(
    words: str, sentence: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(make_venv, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(make_venv, "install", lambda _: words)
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


@pytest.mark.parametrize(
    ("name", "extras"), [("requirements", []), ("cluster", ["cluster"]), ("mutants", ["mutants"])]
)
def test_a_lock_pins_what_the_project_asks_for_with_hashes(name: str, extras: list[str]) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    lock = (ROOT / f"{name}.lock").read_text(encoding="utf-8")
    optional = [each for extra in extras for each in project["optional-dependencies"][extra]]
    for requirement in [*project["dependencies"], *optional]:
        assert re.fullmatch(r"[a-z0-9-]+==[0-9.]+", requirement), "pinned exactly"
        assert re.search(rf"(?m)^{re.escape(requirement)} .*\\$", lock), requirement
    for package in re.split(r"(?m)^(?=[a-z])", lock)[1:]:
        assert "==" in package
        assert "--hash=sha256:" in package
    assert "://" not in lock, "the lock names packages, not where they come from"


@pytest.mark.parametrize("extra", ["cluster", "mutants"])
def test_an_extra_is_locked_to_the_packages_of_everything_else(extra: str) -> None:
    pins, more = (
        set(re.findall(r"(?m)^[a-z].*?==\S+", (ROOT / name).read_text(encoding="utf-8")))
        for name in ("requirements.lock", f"{extra}.lock")
    )
    assert pins < more
