"""What is packed for the browser: no solution in it, unless somebody asks for it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from autograder.manifest import ROOT, load_chapters
from copies import reference
from course_site import BELOW, built, built_with_solutions, data_in, pack_in
from in_node import NodeEngines, engines_of
from made import made_stubs

MOST = 1_500_000  # bytes
OF_PYODIDE = 15_500_000


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory) / BELOW


@pytest.fixture(scope="module")
def with_solutions(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with what Python needs, the reference's modules included."""
    return built_with_solutions(tmp_path_factory) / BELOW


@pytest.fixture(scope="module")
def engines(with_solutions: Path) -> Iterator[NodeEngines]:
    yield from engines_of(with_solutions)


def test_students_files_are_the_stubs_and_nothing_tells_the_solution(site: Path) -> None:
    files: dict[str, str] = {}
    for chapter in load_chapters():
        files |= data_in(site, chapter.name)["files"]
    assert files == {p.removeprefix("chapters/"): text for p, text in made_stubs().items()}
    with pack_in(site) as archive:
        names = archive.namelist()
    assert not [name for name in names if "solutions" in name or "wrong" in name]
    of_chapters = {Path(name).name for name in names if name.startswith("course/chapters/")}
    assert of_chapters == {"chapter.toml"}


def test_the_pack_is_small(site: Path) -> None:
    assert (site / "course.xz").stat().st_size < MOST
    sizes = [file.stat().st_size for file in (site / "pyodide").iterdir()]
    assert sum(sizes) < OF_PYODIDE


def test_the_same_sources_are_the_same_pack(site: Path, with_solutions: Path) -> None:
    with pack_in(site) as one, pack_in(with_solutions) as other:
        more = set(other.namelist()) - set(one.namelist())
        modules = {f"{path.parent.name}/{path.stem}" for path in ROOT.glob("solutions/*/*.py")}
        assert more == {f"course/solutions/{module}.pyc" for module in modules}
        for name in one.namelist():
            assert one.read(name) == other.read(name), name
            assert one.getinfo(name).date_time == other.getinfo(name).date_time


def test_what_an_earlier_chapter_spoils_is_inherited(engines: NodeEngines) -> None:
    third, files = load_chapters()[1], reference()
    vector = files["ch02_vectors/vector.py"]
    wrong = vector.replace("return math.hypot(", "return 2 * math.hypot(")
    assert wrong != vector
    report = engines.check(files | {"ch02_vectors/vector.py": wrong}, third)
    states = {check["status"] for result in report["results"] for check in result["checks"]}
    assert states == {"passed", "inherited"}
    assert report["failure"]["heading"].startswith("Inherited, for example: ")
    assert "chapter 2" in report["notes"][0]
