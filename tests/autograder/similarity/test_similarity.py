"""How code is compared: what makes no difference, what does not count, and what is never done."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from autograder.manifest import ROOT, load_chapters
from autograder.similarity.code import LONGEST, fingerprints, read_functions
from autograder.similarity.collect import Ground, collect, ground_of, work_of
from autograder.similarity.compare import FEWEST, Comparison, Part, Passage, Work
from autograder.submissions.class_list import read_class
from staging import LINK, VECTOR

CHAPTERS = load_chapters()[:2]
KNOWN = frozenset({"x", "y", "z", "sqrt", "Vector3", "magnitude"})
LENGTH = """
def length(v, scale):
    total = v.x * v.x + v.y * v.y
    total = total + v.z * v.z
    root = math.sqrt(total)
    return root * scale / 2.0
"""


@pytest.fixture(scope="module")
def ground() -> Ground:
    return ground_of(CHAPTERS)


def prints_of(source: str) -> set[int]:
    functions, stopped = read_functions(source, KNOWN)
    assert stopped == 0
    return set().union(*(fingerprints(function.words) for function in functions))


@pytest.mark.parametrize(
    "other",
    [
        LENGTH.replace("total", "summe").replace("root", "wurzel"),
        LENGTH.replace("v.", "other.").replace("(v,", "(other,"),
        LENGTH.replace("    root", "    # now the root\n    root"),
        LENGTH.replace("    total = v", '    """Say what it does."""\n\n    total = v'),
        LENGTH.replace("(v, scale)", "(v: Vector3, scale: float = 1.0) -> float"),
        LENGTH.replace(" / 2.0", " / 2"),
        LENGTH.replace("    ", "\t"),
    ],
    ids=["variables", "parameter", "comment", "docstring", "signature", "number", "indentation"],
)
def test_what_a_copy_is_hidden_by_makes_no_difference(other: str) -> None:
    assert other != LENGTH
    assert prints_of(other) == prints_of(LENGTH) != set()


def test_functions_have_the_names_of_the_manifest() -> None:
    source = (
        "import math\n\nclass A(object):\n    n = 1\n\n    @property\n    def mass(self):\n"
        "        return self.m\n\n    @mass.setter\n    def mass(self, m):\n        self.m = m\n\n"
        "    def one(self): return 1\n\n\nasync def two():\n    def inner():\n        pass\n\n\n"
        "def three(a, b={1: 2}): return a[b:]\n\n\n"
        "def text(a):\n    raise ValueError(f'a {a!r:>{9}} b' 'c', a)\n"
    )
    functions, _ = read_functions(source)
    names = {function.name: " ".join(function.words) for function in functions}
    assert list(names) == ["", "A.mass", "A.mass.setter", "A.one", "two", "three", "text"]
    assert names["A.mass.setter"] == "self . ~m = ~m ;"
    assert names["A.one"] == "def ~one ( self ) : return 1.0 ;"
    assert names["two"] == "def ~inner ( ) : ; pass ;"
    assert names["three"].endswith(") : return ~a [ ~b : ] ;")
    assert names["text"] == "raise ~ValueError ( ' ' , ~a ) ;", "on every Python"


@pytest.mark.parametrize(
    ("source", "line"),
    [
        ("def f():\n    return 1\n\ndef g(:\n    return (2\n", 4),
        ("def f():\n    return 1\n  return 2\n", 3),
        ("def f():\n    return 1\n\nx = '''\n", 4),
    ],
    ids=["bracket", "indentation", "text"],
)
def test_a_file_that_is_broken_is_read_up_to_there(source: str, line: int) -> None:
    functions, stopped = read_functions(source)
    assert functions[0].name == "f"
    assert line <= stopped <= len(source.splitlines()) + 1


HOSTILE = {
    "brackets": "(" * LONGEST,
    "quotes": "'" * LONGEST,
    "texts": "'''\n" * (LONGEST // 4),
    "one line": "a b " * (LONGEST // 4),
    "one bracket": "(\n" + "a\n" * (LONGEST // 2 - 9),
    "backslashes": "\\\n" * (LONGEST // 2),
    "wide lines": ("a b " * 499 + "\n") * 50,
    "deep": "".join(" " * i + "if x:\n" for i in range(400)),
    "a huge number": "1" * LONGEST,
    "no characters": "x = '\ud800'; y = \x01\n",
    "too long": "x = 1\n" * LONGEST,
}


@pytest.mark.parametrize("source", HOSTILE.values(), ids=HOSTILE.keys())
def test_no_file_keeps_it_busy(source: str) -> None:
    started = time.process_time()
    for function in read_functions(source)[0]:
        fingerprints(function.words)
    assert time.process_time() - started < 5.0


@pytest.mark.parametrize("folder", ["chapters", "solutions"])
def test_stubs_given_code_and_the_reference_do_not_count(folder: str, ground: Ground) -> None:
    files = {
        f"{chapter.name}/{name}": (ROOT / folder / chapter.name / name).read_text(encoding="utf-8")
        for chapter in CHAPTERS
        for name in chapter.edited_files
    }
    assert work_of("ann", files, ground) == (Work("ann", {}), [])


def test_exercises_that_are_too_small_are_left_out_and_helpers_are_not(ground: Ground) -> None:
    body = "    return sum(p * q for p, q in zip(v, v, strict=True)) + sum(v) - sum(v)\n"
    for small in (True, False):
        exercise = next(
            exercise
            for exercise in CHAPTERS[0].exercises
            if (exercise.id in ground.small) is small
            and any(edit.startswith("exercises.") for edit in exercise.edit)
        )
        source = f"def {exercise.edit[0].removeprefix('exercises.')}(v):\n{body}"
        work, _ = work_of("ann", {"ch02_vectors/exercises.py": source}, ground)
        assert [*work.parts] == ([] if small else [f"{exercise.id} {exercise.title}"])
    work, _ = work_of("ann", {VECTOR: f"def _added(v):\n{body}"}, ground)
    assert [*work.parts] == [f"Other code in {VECTOR}"]


def test_submissions_are_staged_and_never_run(tmp_path: Path, ground: Ground) -> None:
    code = f"\ufeffopen({str(tmp_path / 'ran')!r}, 'w').write(__file__ + 2 * __name__)\n"
    for student in ("ann", "bob"):
        (tmp_path / "class" / student / "ch02_vectors").mkdir(parents=True)
    (tmp_path / "class/ann/ch02_vectors/vector.py").write_text(code, encoding="utf-8")
    (tmp_path / "class/bob/ch02_vectors/vector.py").symlink_to("/etc/passwd")
    submissions = read_class(tmp_path / "class").submissions
    (ann, notes_of_ann), (bob, notes_of_bob) = collect(submissions, ground)
    assert not (tmp_path / "ran").exists()
    assert (len(ann.parts), notes_of_ann) == (1, [])
    assert bob.parts == {}
    assert notes_of_bob == [f"{VECTOR} was rejected: {LINK}"]


def made(student: str, **parts: set[int]) -> Work:
    return Work(student, {name: Part([], prints) for name, prints in parts.items()})


def lonely_class(size: int) -> list[Work]:
    """Students who share a little by chance, in twenty exercises."""
    return [
        made(f"s{i}", **{f"e{e}": {100 * e + (i * (e + 3) + k) % 31 for k in range(4)}
                         for e in range(20)})
        for i in range(size)
    ]  # fmt: skip


def test_what_many_have_written_counts_less() -> None:
    same = [made(f"s{i}", a={1, 2, 3}, b={100 + i, 200 + i}) for i in range(20)]
    pair = [made("x", a={1, 2, 3}, b={7, 8, 9}), made("y", a={1, 2, 3}, b={7, 8, 9})]
    comparison = Comparison([*same, *pair])
    first, *others = comparison.pairs
    assert (first.one.student, first.other.student) == ("x", "y")
    assert max(other.similarity for other in others) < 0.1 < first.similarity
    assert [(part.name, part.rarest) for part in comparison.shared(first)] == [("b", 2)]


def test_identical_code_stands_out_before_code_that_is_more_surprising() -> None:
    """Two students have the same code in one exercise only, which by itself is no surprise."""
    students = lonely_class(33)
    students[3] = Work("s3", students[5].parts)
    (function,) = read_functions(LENGTH)[0]
    for i, text in enumerate((LENGTH, LENGTH, LENGTH.replace("2.0", "2.00"))):
        passage = Passage(VECTOR, "length", function.tokens, text)
        part = Part([passage], students[8].parts["e4"].fingerprints)
        students[30 + i] = Work(f"t{i}", {**students[30 + i].parts, "e4": part})
    for comparison in (Comparison(students), Comparison(students[-FEWEST + 1 :])):
        first, *others = comparison.pairs
        assert (first.one.student, first.other.student) == ("t0", "t1")
        assert comparison.identical == [first]
        assert comparison.stands_out(first)
        surprises = [pair.surprise for pair in others]
        measured = surprises if comparison.line else [pair.similarity for pair in others]
        assert measured == sorted(measured, key=lambda value: value or 0.0, reverse=True)
    first, second, *_ = Comparison(students).pairs
    assert {second.one.student, second.other.student} == {"s3", "s5"}
    assert first.surprise < second.surprise  # type: ignore[operator]


def test_a_small_class_or_one_that_shares_nothing_has_no_surprise() -> None:
    sharing_nothing = [made(f"s{i}", a={i}) for i in range(FEWEST)]
    for works in (*map(lonely_class, (0, 1, 2, FEWEST - 1)), sharing_nothing):
        comparison = Comparison(works)
        assert comparison.line is None
        assert comparison.outstanding == 0
        assert all(pair.surprise is None for pair in comparison.pairs)
        similarities = [pair.similarity for pair in comparison.pairs]
        assert similarities == sorted(similarities, reverse=True)
    assert {*similarities} == {0.0}
    assert Comparison(lonely_class(FEWEST)).line is not None
