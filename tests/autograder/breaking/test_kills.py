"""Commands that are killed at random moments lose nothing, and the same command completes them.

KILLS=40 in the environment kills each command so often. Otherwise each is killed once, and those
with a ``least`` a few times. With KILL_SEED=2 the moments are others.
"""

from __future__ import annotations

import json
import os
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from random import Random

import pytest

from killed import Victim, half_written
from small import RIGHT, hand_in, make_root
from small_class import HALF, results
from staging import make_zip

KILLS = int(os.environ.get("KILLS", "1"))
SEED = int(os.environ.get("KILL_SEED", "1"))
RESUMED = 0.3  # of the kills are followed by a whole run
GRADE = """
import sys
from pathlib import Path
from autograder.course.model import Work
from autograder.grader import cohort
from autograder.manifest import load_chapters
folder, out, root = map(Path, sys.argv[1:])
options = cohort.ClassOptions(root=root, jobs=2, unsafe=True)
sys.exit(cohort.grade(folder, out, Work("", load_chapters(root), seed="1"), options))
"""
UNPACK = """
import sys
from pathlib import Path
from autograder.submissions.unpack import class_folder
class_folder(Path(sys.argv[1]))
"""
CHART = """
import sys
from studies import charts
charts.QUICK = (1, 1e-3, 1e-3)
sys.exit(charts.main(sys.argv[1:]))
"""
PLACE = """
import shutil, sys
from pathlib import Path
from web.__main__ import put_in_place
built, out = map(Path, sys.argv[1:])
shutil.rmtree(built, ignore_errors=True)
shutil.copytree("lab/page", built)
put_in_place(built, out)
"""


def killed_again_and_again(
    victim: Victim,
    same: Callable[[Path], dict[str, str]],
    check: Callable[[bool], None],
    least: int = 1,
) -> None:
    """Kill a command, and start it again, until it was killed often enough.

    ``same`` returns the content of the folder that every whole run must give. ``check`` checks the
    folder after each run. Its argument says whether the folder was new when the command started.
    Without KILLS in the environment, the command is killed ``least`` times.
    """
    victim.run_whole()
    expected, starts = same(victim.folder), 0
    assert expected
    shutil.rmtree(victim.folder)
    while victim.kills < max(KILLS, least):
        starts += 1
        is_new = not victim.folder.exists()
        is_killed = victim.kill_once()
        check(is_new)
        if is_killed and victim.rng.random() >= RESUMED:
            continue
        if is_killed:
            victim.run_whole()
            check(False)
        assert same(victim.folder) == expected
        shutil.rmtree(victim.folder)
    is_new = not victim.folder.exists()
    victim.run_whole()
    check(is_new)
    assert same(victim.folder) == expected
    many = f"{victim.kills} times in {starts} starts of {victim.steps} steps"
    print(f"{' '.join(victim.command[:3])}: killed {many}")


def texts(folder: Path, pattern: str = "*") -> dict[str, str]:
    """Return the files in a folder without the time that grading took."""
    return {
        str(path.relative_to(folder)): re.sub(
            r'"(seconds|execution_time)": [0-9.]+', "", path.read_bytes().decode(errors="replace")
        )
        for path in sorted(folder.rglob(pattern))
        if path.is_file()
    }


def test_a_killed_grading_keeps_every_report(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root, out, temporary = make_root(tmp_path / "root"), tmp_path / "out", tmp_path / "temporary"
    temporary.mkdir()
    monkeypatch.setenv("TMPDIR", str(temporary))
    for number in range(4):
        hand_in(tmp_path / "class", f"student {number}", RIGHT if number % 2 else HALF)
    script = tmp_path / "grade.py"
    script.write_text(GRADE, encoding="utf-8")
    command = [str(script), str(tmp_path / "class"), str(out), str(root)]
    landed: dict[str, object] = {}

    def check(is_new: bool) -> None:
        assert half_written(out) == []
        now = results(out)
        if not is_new:
            kept = {student: now[student] for student in landed}
            assert kept == landed, "nothing is graded twice"
        landed.clear()
        landed.update(now)

    victim = Victim(command, out, Random(SEED))
    killed_again_and_again(victim, texts, check, least=3)
    assert [*out.glob(".temporary"), *out.rglob("*.tmp"), *temporary.iterdir()] == []


def test_a_killed_comparison_has_no_index_of_other_pairs(tmp_path: Path) -> None:
    out = tmp_path / "out"
    command = ["-m", "autograder", "similarity", "sample_class", "--chapters", "2", "--out"]

    def check(_: bool) -> None:
        assert half_written(out) == []
        index = out / "index.html"
        if index.exists():
            linked = re.findall(r'href="(pairs/[^"]*)"', index.read_text(encoding="utf-8"))
            assert all((out / name).exists() for name in linked)

    victim = Victim([*command, str(out)], out, Random(SEED))
    killed_again_and_again(victim, lambda folder: texts(folder, "*.html"), check)


def test_a_killed_release_is_not_called_complete(tmp_path: Path) -> None:
    out = tmp_path / "out"
    command = ["-m", "autograder", "release", "2", "--out", str(out)]

    def check(_: bool) -> None:
        record = out / "released.txt"
        if record.exists() and "interrupted" not in record.read_text(encoding="utf-8"):
            assert (out / "reference/ch02_vectors/vector.py").exists()
            assert half_written(out) == []

    victim = Victim(command, out, Random(SEED))
    killed_again_and_again(victim, lambda folder: texts(folder / "reference"), check)


def test_a_class_whose_unpacking_is_killed_is_unpacked_again(tmp_path: Path) -> None:
    work = {f"student {n}/ch02_vectors/vector.py": f"x = {n}\n".encode() for n in range(8)}
    zipped = make_zip(tmp_path, work).rename(tmp_path / "lab1.zip")
    script = tmp_path / "unpack.py"
    script.write_text(UNPACK, encoding="utf-8")
    victim = Victim([str(script), str(zipped)], tmp_path / "lab1", Random(SEED))
    killed_again_and_again(victim, lambda folder: texts(folder, "*.py"), lambda _: None)


def test_killed_charts_keep_their_rounds(tmp_path: Path) -> None:
    out, script = tmp_path / "out", tmp_path / "chart.py"
    script.write_text(CHART, encoding="utf-8")
    command = [str(script), "--quick", "--scene", "linear drag", "--out", str(out)]

    def check(_: bool) -> None:
        for name in ("measured.json", "index.html", "points.csv"):
            assert str(out / name) not in half_written(out)

    victim = Victim(command, out, Random(SEED))
    names = lambda folder: dict.fromkeys(texts(folder), "")  # noqa: E731
    killed_again_and_again(victim, names, check)
    assert half_written(out) == []
    assert json.loads((out / "measured.json").read_text(encoding="utf-8"))["rounds"] == 1


def test_a_site_is_whole_although_its_build_is_killed(tmp_path: Path) -> None:
    """Only the last part of the build is killed, which puts the new site in the old one's place."""
    out, built, script = tmp_path / "host/site", tmp_path / "built", tmp_path / "place.py"
    script.write_text(PLACE, encoding="utf-8")
    victim = Victim([str(script), str(built), str(out)], out.parent, Random(SEED))
    victim.run_whole()
    expected = texts(out)
    assert expected
    victim.steps = 0  # count those of a build that replaces a site
    victim.run_whole()
    while victim.kills < max(KILLS, 5):
        victim.kill_once()
        assert not out.exists() or texts(out) == expected
    victim.run_whole()
    assert texts(out) == expected
    assert [*out.parent.iterdir()] == [out]
    print(f"site: killed {victim.kills} times, {victim.steps} steps")
