"""The script in the README of the finished engine runs, and draws what the page says."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

from autograder.manifest import ROOT

(SCRIPT,) = re.findall(
    r"(?ms)^```python\n(.+?)^```", (ROOT / "solutions/README.md").read_text(encoding="utf-8")
)
# Without .venv's own path to the students' files, which would hide a folder that is missing.
RUN = f"""
import runpy, sys
sys.path.extend({[entry for entry in sys.path if "site-packages" in entry]!r})
import matplotlib
matplotlib.use("Agg")
runpy.run_path(sys.argv[1], run_name="__main__")
"""


def test_the_ball_stays_between_the_ground_and_the_wall(tmp_path: Path) -> None:
    checks = """
assert max(xs) > 2.9, "the wind blows it to the wall"
assert max(xs) < 3.05 and min(ys) > -0.1, "contacts keep it inside to within a step"
assert any(low > b < high for low, b, high in zip(ys, ys[1:], ys[2:])), "it bounces"
"""
    script = SCRIPT.replace('COURSE = "."', f"COURSE = {str(ROOT)!r}")
    (tmp_path / "own.py").write_text(script + checks, encoding="utf-8")
    command = [sys.executable, "-S", "-c", RUN, "own.py"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stderr
    assert "Its path is in path.png." in done.stdout
    assert (tmp_path / "path.png").stat().st_size > 5000
