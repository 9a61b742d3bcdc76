"""Each lock has what its commands import and no more, and each command installs its lock."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from collections.abc import Iterable
from importlib import metadata
from pathlib import Path

import pytest
from packaging.utils import canonicalize_name

from autograder.commands import PACKAGES
from autograder.handouts.handout import CHARTS, make_handout
from autograder.manifest import ROOT, load_chapters
from web.imports import imported_by, imports_of

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
STUDENTS: list[str] = PROJECT["dependencies"]
GROUPS: dict[str, list[str]] = PROJECT["optional-dependencies"]
ALL = [*STUDENTS, *(each for group in GROUPS.values() for each in group)]
WANTED = {
    "requirements": STUDENTS,
    "pictures": [*STUDENTS, *GROUPS["pictures"]],
    "teaching": [*STUDENTS, *GROUPS["teaching"]],
    "everything": ALL,
}
OURS = ("autograder", "lab", "plots", "scenes", "studies", "web")


def pins(lock: str) -> dict[str, str]:
    """Return the entries of a lock, keyed by name==version."""
    text = (ROOT / f"autograder/locks/{lock}.lock").read_text(encoding="utf-8")
    return {entry.split()[0]: entry for entry in re.split(r"(?m)^(?=[a-z])", text)[1:]}


def names(lock: str) -> set[str]:
    return bare(pins(lock))


def bare(requirements: Iterable[str]) -> set[str]:
    return {each.partition("==")[0] for each in requirements}


def hashes(entry: str) -> set[str]:
    return {*re.findall(r"--hash=(sha256:[0-9a-f]{64})", entry)}


@pytest.mark.parametrize(("lock", "wanted"), WANTED.items(), ids=WANTED)
def test_a_lock_pins_what_the_project_asks_for_with_hashes(lock: str, wanted: list[str]) -> None:
    """A smaller lock has the same files as everything.lock, so no command replaces a package."""
    for requirement in wanted:
        pin, _, marker = requirement.partition("; ")
        assert re.fullmatch(r"[a-z0-9-]+==[0-9.]+", pin), "pinned exactly"
        assert pin in pins(lock)
        assert not marker or re.fullmatch(r"python_version (<|>=) '3\.\d+'", marker)
    everything = pins("everything")
    for pin, entry in pins(lock).items():
        assert hashes(entry)
        assert hashes(entry) == hashes(everything[pin]), pin
        assert "://" not in entry, "the lock names packages, not their addresses"
    assert names("requirements") <= names(lock)


def test_the_packages_that_a_command_asks_for_are_those_of_its_group() -> None:
    assert PACKAGES.keys() == WANTED.keys()
    known = metadata.packages_distributions()
    for lock in ("requirements", "pictures", "teaching"):
        own = STUDENTS if lock == "requirements" else GROUPS[lock]
        asked = {canonicalize_name(known[name][0]) for name in PACKAGES[lock].split()}
        assert asked == bare(own)


@pytest.fixture(scope="module")
def handout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("handout") / "out"
    make_handout(load_chapters(), [], out)
    return out


def imported_packages(files: Iterable[Path]) -> set[str]:
    """Return the distributions whose modules these files import, also inside functions."""
    known = metadata.packages_distributions()
    roots = {name.partition(".")[0] for file in files for name in imports_of(file, [])}
    found = {canonicalize_name(dist) for name in roots for dist in known.get(name, ())}
    assert found.isdisjoint({"game-physics-companion"})
    return found


def reached(roots: Iterable[Path], root: Path = ROOT) -> list[Path]:
    return imported_by([*roots], [root], OURS)


def test_students_install_what_their_commands_import_and_no_more(handout: Path) -> None:
    """The files for pictures are those that only plots and recordings import."""
    drawing = ("lab/record", "lab/__main__", "plots/draw", "plots/drawing", "plots/__main__")
    globs = ("autograder/**/*.py", "tests/**/*.py", "chapters/**/*.py", "lab/scenes/**/*.py")
    roots = [handout / "lab/server.py", handout / "lab/child.py"]
    roots += [file for glob in globs for file in handout.glob(glob)]
    files = {*reached(roots, handout), *roots}
    assert files.isdisjoint({handout / f"{name}.py" for name in drawing})
    assert len(files) > 150
    imported = imported_packages(files)
    assert imported <= names("requirements")
    assert bare(STUDENTS) <= imported, "what nobody imports"
    everything = imported_packages(handout.rglob("*.py"))
    assert everything <= names("pictures")
    assert everything - imported >= bare(GROUPS["pictures"])


def test_the_commands_of_instructors_import_what_their_lock_has() -> None:
    commands = [ROOT / "autograder/__main__.py", ROOT / "autograder/platforms/grade_one.py"]
    imported = imported_packages(reached(commands))
    assert imported - {"distributed"} <= names("teaching"), "--cluster says what it needs"
    assert bare(GROUPS["teaching"]) <= imported
    site = imported_packages(reached((ROOT / "web").glob("*.py")))
    of_class = {"pyyaml", "dateparser"}  # imported where a class has a file of a platform
    assert site - of_class <= names("pictures")


def test_the_lab_imports_more_than_students_have_only_for_the_charts() -> None:
    scenes = {*(ROOT / "lab/scenes").rglob("*.py")}
    charts = {scene for scene in scenes if scene.name == CHARTS}
    assert imported_packages(reached(scenes - charts)) <= names("requirements")
    assert imported_packages(reached(charts)) - names("requirements") >= {"scipy"}


def test_nothing_imports_a_package_that_no_lock_has() -> None:
    folders = (*OURS, "tests", "solutions", "chapters", ".ci")
    files = [file for folder in folders for file in (ROOT / folder).rglob("*.py")]
    files = [file for file in files if not {"hostile", "node_modules"} & {*file.parts}]
    assert imported_packages(files) <= names("everything")


STAND_IN = "import sys\nfor name in {!r}:\n    sys.modules[name] = None\n"


def without(packages: str, folder: Path, *command: str) -> subprocess.CompletedProcess[str]:
    (folder / "sitecustomize.py").write_text(STAND_IN.format(packages.split()), encoding="utf-8")
    return subprocess.run(
        [sys.executable, *command],
        cwd=ROOT,
        env={"PYTHONPATH": str(folder), "SYSTEMROOT": "C:\\Windows"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )


@pytest.mark.parametrize(
    ("command", "group"),
    [
        ("autograder grade sample_class --out {out}", "teaching"),
        ("autograder handout 2 --out {out}", "teaching"),
        ("autograder classroom 2 --out {out}", "teaching"),
        ("autograder release 2 --out {out}", "teaching"),
        ("autograder similarity sample_class --out {out}", "teaching"),
        ("autograder stubs --check", "teaching"),
        ("plots draw --chapter 2", "pictures"),
        ("lab record throw", "pictures"),
        ("web --out {out}", "pictures"),
        ("studies choose pendulum", "everything"),
    ],
)
def test_a_command_without_its_packages_names_the_command_that_installs_them(
    command: str, group: str, tmp_path: Path
) -> None:
    module, *words = command.format(out=tmp_path / "out").split()
    *_, package = PACKAGES[group].split()
    done = without(package, tmp_path, "-m", module, *words)
    assert done.returncode in (1, 2)
    assert f"this Python lacks {package}, " in done.stderr
    assert f"autograder/make_venv.py {group}, " in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


def test_the_scene_of_the_charts_says_which_packages_it_lacks(tmp_path: Path) -> None:
    code = """
from scenes.reason import reason
from lab.host import Host
message = {'kind': 'load', 'scene': 'charts', 'values': {}, 'peer': ''}
print(Host(reason).receive(message)[0]['why'])
"""
    done = without("scipy", tmp_path, "-c", code)
    assert done.stdout.startswith("this Python lacks scipy, "), done.stderr
    assert "autograder/make_venv.py everything" in done.stdout
