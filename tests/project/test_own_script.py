"""The script in the README of the finished engine runs, and draws what the page says."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.manifest import ROOT

(SCRIPT,) = re.findall(
    r"(?ms)^```python\n(.+?)^```", (ROOT / "solutions/README.md").read_text(encoding="utf-8")
)
FOLDERS = 'f"{COURSE}/solutions", f"{COURSE}/chapters"'
ONLY, SWAPPED = 'f"{COURSE}/solutions"', 'f"{COURSE}/chapters", f"{COURSE}/solutions"'


# Without .venv's own path to the students' files, which would hide a folder that is missing.
RUN = f"""
import runpy, sys
sys.path.extend({[entry for entry in sys.path if "site-packages" in entry]!r})
import matplotlib
matplotlib.use("Agg")
runpy.run_path(sys.argv[1], run_name="__main__")
"""


def run(script: str, folder: Path) -> subprocess.CompletedProcess[str]:
    file = folder / "own.py"
    file.write_text(script.replace('COURSE = "."', f"COURSE = {str(ROOT)!r}"), encoding="utf-8")
    command = [sys.executable, "-S", "-c", RUN, str(file)]
    return subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", check=False)


def test_the_ball_stays_between_the_ground_and_the_wall(tmp_path: Path) -> None:
    checks = """
assert max(xs) > 2.9, "the wind blows it to the wall"
assert max(xs) < 3.05 and min(ys) > -0.1, "contacts keep it inside to within a step"
assert any(low > b < high for low, b, high in zip(ys, ys[1:], ys[2:])), "it bounces"
"""
    done = run(SCRIPT + checks, tmp_path)
    assert done.returncode == 0, done.stderr
    assert "Its path is in path.png." in done.stdout
    assert (tmp_path / "path.png").stat().st_size > 5000


@pytest.mark.parametrize(
    ("folders", "says"), [(ONLY, "ModuleNotFoundError"), (SWAPPED, "Exercise")]
)
def test_other_paths_fail_as_the_page_says(folders: str, says: str, tmp_path: Path) -> None:
    assert SCRIPT.count(FOLDERS) == 1
    done = run(SCRIPT.replace(FOLDERS, folders), tmp_path)
    assert done.returncode != 0
    assert says in done.stderr
