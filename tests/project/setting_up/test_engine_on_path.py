"""What .venv runs can import the student's engine, and commands choose an engine themselves."""

from __future__ import annotations

import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

from autograder import make_venv
from autograder.manifest import ROOT

PATH_FILE = Path(sysconfig.get_path("purelib")) / "engine.pth"
in_venv = pytest.mark.skipif(
    not PATH_FILE.is_file(), reason="autograder/make_venv.py has not set up this Python"
)


def run(*words: str | Path, cwd: Path) -> str:
    command = [sys.executable, *map(str, words)]
    done = subprocess.run(command, cwd=cwd, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


@in_venv
def test_a_script_anywhere_and_a_file_by_itself_find_the_engine(tmp_path: Path) -> None:
    script = tmp_path / "mine.py"
    script.write_text(
        "from ch02_vectors.vector import Vector3\nprint(Vector3(1, 2, 3))\n", encoding="utf-8"
    )
    assert run(script, cwd=tmp_path) == "Vector3(1.0, 2.0, 3.0)"
    for file in sorted((ROOT / "chapters").glob("ch0*/*.py")):
        if "NotImplementedError" in file.read_text(encoding="utf-8"):
            assert run(file, cwd=tmp_path) == ""


@in_venv
def test_our_commands_do_not_see_it(tmp_path: Path) -> None:
    code = "import sys, autograder; print([p for p in sys.path if p.endswith('chapters')])"
    assert run("-c", f"import sys; sys.path.insert(0, {str(ROOT)!r})\n{code}", cwd=tmp_path) == "[]"


def test_setting_up_puts_it_there_also_in_a_folder_with_a_strange_name(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """The path is relative, because Python may read the file with another encoding."""
    root = tmp_path / "Übung 1"
    packages = Path(sysconfig.get_path("purelib", "venv", {"base": str(root / ".venv")}))
    packages.mkdir(parents=True)
    (root / "chapters").mkdir()
    monkeypatch.setattr(make_venv, "ROOT", root)
    monkeypatch.setattr(make_venv, "VENV", root / ".venv")
    make_venv.put_engine_on_path()
    line = (packages / "engine.pth").read_text(encoding="ascii").strip()
    assert (packages / line).resolve() == root / "chapters"
