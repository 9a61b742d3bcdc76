"""A class of 40 with ten copies, and the pages on it, with hostile names and files too."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

import browser as browsers
from autograder.manifest import ROOT, select_chapters
from autograder.similarity import run
from autograder.similarity.collect import ground_of, work_of
from autograder.similarity.compare import Comparison
from copied_class import Files, copied_class
from graded import NASTY, SHOUT
from typed import typed

browser = pytest.fixture(browsers.browser, scope="module")


ADA = {
    f"ch02_vectors/{path.name}": path.read_text(encoding="utf-8")
    for path in (ROOT / "sample_class/ada/ch02_vectors").glob("*.py")
}


def page_of(out: Path, number: int) -> str:
    return (out / f"pairs/pair-{number:03}.html").read_text(encoding="utf-8")


def write_class(folder: Path, students: dict[str, Files]) -> Path:
    for student, files in students.items():
        for file, text in files.items():
            (folder / student / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / student / file).write_text(text, encoding="utf-8")
    return folder


@pytest.mark.slow
@pytest.mark.parametrize(("numbers", "seed"), [("2-3", 1), ("5", 4)])
def test_nine_of_ten_copies_are_found_at_one_false_pair_or_fewer(numbers: str, seed: int) -> None:
    chapters = select_chapters(numbers)
    ground = ground_of(chapters)
    students, copies = copied_class(chapters, seed)
    works = [work_of(f"{i:02}", files, ground)[0] for i, files in enumerate(students)]
    comparison = Comparison(works)
    pairs = [(int(p.one.student), int(p.other.student)) for p in comparison.pairs]
    found = pairs[: comparison.outstanding]
    assert len({*found} & {*copies}) >= 9
    assert len({*found} - {*copies}) <= 1


@pytest.fixture(scope="module")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The pages on a class of 16, of whom two have hostile names and much in common."""
    folder = tmp_path_factory.mktemp("similarity")
    students, _ = copied_class(select_chapters("2"), seed=7, size=16, copiers=0)
    students.sort(key=lambda files: sum(map(len, files.values())))
    students[0] = {**students[-1]}
    names = ["<b>bold & co", *(f"student {i}" for i in range(1, 15)), "\N{RIGHT-TO-LEFT OVERRIDE}x"]
    for i in (0, -1):
        students[i]["ch02_vectors/exercises.py"] += HOSTILE
    submissions = write_class(folder / "class", dict(zip(names, students, strict=True)))
    (submissions / "empty").mkdir()
    (submissions / "essay.pdf").write_bytes(b"%PDF")
    assert run.similarity(submissions, folder / "out", select_chapters("2")) == 0
    return folder / "out"


HOSTILE = f"""

def helper(a, b):
    text = '''</pre></mark><script>alert(1)</script><img src=x onerror=alert(1)>{SHOUT} '''
    more = a['{{{{ 7 * 7 }}}}'] + b["\\x1b[31m\x1b[31m\N{RIGHT-TO-LEFT OVERRIDE}"]
    return text + more + {"a * b + " * 100} a
"""


def test_hostile_names_and_files_are_shown_as_text(out: Path) -> None:
    pages = [path.read_text(encoding="utf-8") for path in sorted(out.rglob("*.html"))]
    assert len(pages) == 31
    hostile = pages[1]
    assert "<bdi>&lt;b&gt;bold &amp; co</bdi>" in hostile
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in hostile
    assert "{{ 7 * 7 }}" in hostile
    for page in pages:
        assert not re.search("<(script|img|b|link|iframe|form)[ >]", page)
        assert not re.search("[\x00-\x08\x0b-\x1f\x7f-\x9f\ud800-\udfff\u202a-\u202e]", page)
        assert NASTY not in page
    assert max(map(len, pages)) < 200_000


def test_the_index_sorts_by_surprise_and_says_that_it_proves_nothing(out: Path) -> None:
    index = (out / "index.html").read_text(encoding="utf-8")
    assert "Similarity proves nothing." in index
    assert "It cannot show why." in index
    surprises = re.findall(r'</th>\n<td class="points">(-?[\d.]+)</td>', index)
    assert len(surprises) == 30
    assert all(float(a) >= float(b) for a, b in pairwise(surprises))
    assert index.count('class="stands"') == 1
    assert "empty was left out" in index
    assert "essay: &#39;essay.pdf&#39; cannot be graded: it is neither a folder nor" in index
    assert "2.1, 2.7, which are so short" in index
    links = re.findall(r'href="(pairs/[^"]+)"', index)
    assert all((out / link).is_file() for link in links)


def test_the_same_passages_are_marked_on_both_sides(out: Path) -> None:
    page = (out / "pairs/pair-001.html").read_text(encoding="utf-8")
    assert "Similarity proves nothing." in page
    assert "which stands out" in page
    section = page[page.index('<section class="exercise"') :].partition("</section>")[0]
    sides = section.split("<h3>")[1:]
    words = [re.sub(r"\b\w\b|\s", "", "".join(re.findall(r"<mark[^>]*>([^<]*)", s))) for s in sides]
    assert len(sides) == 2
    assert words[0][:40] == words[1][:40] != ""


def test_a_second_run_leaves_no_page_of_the_first(tmp_path: Path) -> None:
    students, _ = copied_class(select_chapters("2"), seed=1, size=4, copiers=1)
    everyone = {f"s{i}": files for i, files in enumerate(students)}
    folder = write_class(tmp_path / "class", everyone)
    run.similarity(folder, tmp_path / "out", select_chapters("2"))
    assert len([*tmp_path.glob("out/pairs/*")]) == 6
    index = (tmp_path / "out/index.html").read_text(encoding="utf-8")
    assert "This one has 4 students with code, and at least 12 are needed." in index
    assert "Surprise</th>" not in index
    few = write_class(tmp_path / "few", {"ann": everyone["s0"]})
    run.similarity(few, tmp_path / "out", select_chapters("2"))
    assert [*tmp_path.glob("out/pairs/*")] == []
    assert "There are no two students" in (tmp_path / "out/index.html").read_text(encoding="utf-8")


def test_an_assignment_is_compared_alone_with_the_names_of_the_gradebook(tmp_path: Path) -> None:
    """The code differs only in B2.6, which is not assigned, and in a comment."""
    vector = "ch02_vectors/vector.py"
    code = ADA[vector].replace("(v) * scale", "(v)*scale")
    assert code != ADA[vector]
    code = code.replace("    def copy", "    # my own work\n    def copy")
    write_class(tmp_path / "class", {"101": {vector: ADA[vector]}, "102": {vector: code}})
    (tmp_path / "roster.csv").write_text(
        "id,name,email,login\n101,Ann Lee,,\n102,Bob Roe,,\n103,Cem Kaya,,\n", encoding="utf-8"
    )
    (tmp_path / "course.toml").write_text(
        'roster = "roster.csv"\n[[assignment]]\nname = "lab1"\nexercises = ["B2.1", "B2.2"]\n',
        encoding="utf-8",
    )
    command = ["autograder", "similarity", tmp_path / "class", "--out", tmp_path / "out"]
    lab1 = ["--assignment", "lab1", "--course", tmp_path / "course.toml"]
    assigned = typed(*command, *lab1)
    assert "identical: Ann Lee and Bob Roe" in assigned.stdout, assigned.stderr
    assert "Nothing handed in: 1 (Cem Kaya)." in assigned.stdout
    assert "<bdi>Ann Lee</bdi>" in page_of(tmp_path / "out", 1)
    whole = typed(*command, "--chapters", "2", "--roster", tmp_path / "roster.csv")
    assert "identical" not in whole.stdout
    assert "<bdi>Ann Lee</bdi>" in page_of(tmp_path / "out", 1)


@pytest.mark.slow
def test_the_pages_are_accessible_and_fit(browser: Any, out: Path) -> None:
    from axe_playwright_python.sync_playwright import Axe

    opened = browser.new_page(bypass_csp=True)  # axe is a script
    for scheme, width in (("light", 360), ("dark", 1280)):
        opened.emulate_media(color_scheme=scheme)
        opened.set_viewport_size({"width": width, "height": 900})
        for name in ("index.html", "pairs/pair-001.html")[width > 360 :]:
            opened.goto((out / name).as_uri())
            found = Axe().run(opened).response["violations"]
            assert found == [], [(v["id"], v["nodes"][0]["html"]) for v in found]
            assert opened.evaluate("document.documentElement.scrollWidth") <= width
    opened.close()
