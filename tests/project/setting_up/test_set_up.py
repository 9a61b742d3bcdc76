"""Setting up reports in one sentence what is missing, and installs the pinned packages."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import dataclass, field
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


@dataclass
class Pip:
    """Stands in for pip: what it fails with, by lock, and which locks it was asked to install."""

    failures: dict[str, str] = field(default_factory=dict)
    installed: list[str] = field(default_factory=list)

    def install(self, lock: Path) -> str:
        self.installed.append(lock.stem)
        return self.failures.get(lock.stem, "")


@pytest.fixture
def pip(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Pip:
    pip = Pip()
    monkeypatch.setattr(make_venv, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(make_venv, "run_pip", pip.install)
    return pip


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (
            "WARNING: Retrying (Retry(total=0)) after connection broken by 'NewConnectionError'",
            r"\(PyPI\) cannot be reached\. Check the network",
        ),
        ("[Errno -3] Temporary failure in name resolution", "cannot be reached"),
        ("ERROR: No matching distribution found for numpy==9", "Its output ends with:\n.*numpy==9"),
        ("Looking in indexes: http://proxy.here\nERROR: hashes do not match", "output ends with"),
    ],
)
def test_what_pip_could_not_do_is_said_and_nothing_counts_as_ready(
    words: str,
    sentence: str,
    pip: Pip,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    made = subprocess.CompletedProcess([], 0, "")  # pretend, since a real one takes seconds
    monkeypatch.setattr(make_venv.subprocess, "run", lambda *_, **__: made)
    pip.failures["requirements"] = words
    with pytest.raises(SystemExit, match=sentence):
        make_venv.main()
    assert not (tmp_path / ".venv/ready").exists()


def test_a_whole_environment_is_made_once_and_groups_are_added_to_it(
    pip: Pip, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def there() -> set[str]:
        names = {"ready", "pictures", "teaching", "everything"}
        return {name for name in names if (tmp_path / ".venv" / name).exists()}

    pip.failures["pictures"] = "name resolution"
    with pytest.raises(SystemExit, match="cannot be reached"):
        make_venv.main("pictures")
    assert there() == {"ready"}
    assert "Set up: .venv is ready." in capsys.readouterr().out
    pip.failures.clear()
    make_venv.main("pictures")
    assert there() == {"ready", "pictures"}
    make_venv.main("everything")
    assert pip.installed == ["requirements", "pictures", "pictures", "everything"]
    assert there() == {"ready", "pictures", "teaching", "everything"}, "it has all groups"


@pytest.mark.parametrize("name", ["scipy", "requirements"])
def test_what_is_no_group_is_an_error_that_lists_the_groups(name: str) -> None:
    with pytest.raises(SystemExit, match=r"choose from everything, pictures, teaching"):
        make_venv.main(name)
