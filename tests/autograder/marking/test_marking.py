"""Written answers are collected without names, and the server answers its own page alone."""

from __future__ import annotations

import json
import re
from collections.abc import Coroutine, Iterator
from pathlib import Path
from typing import Any
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest

from autograder.__main__ import main
from autograder.manifest import ROOT, select_chapters
from autograder.marking.answers import LONGEST, collect_tasks
from autograder.submissions.class_list import read_class
from graded import SHOUT
from served import marking

STUB = (ROOT / "chapters/ch02_vectors/answers.md").read_text(encoding="utf-8")
PLACE = "_Write your answer here._"
GOOD = "The lengths are never negative,\nso the cosine decides."
HANDED_IN = {
    "ann": STUB.replace(PLACE, GOOD, 1),
    "bob": STUB,
    "cem": STUB.replace(PLACE, "|a|^2", 1),
    "dan": STUB.replace("## 2.2b", "Question 2.2b").replace(PLACE, "Dan's answer", 1),
    "eve": None,
    "fay": STUB.replace(PLACE, f"{SHOUT}\x1b[31m {'long ' * LONGEST}", 1),
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for student, text in HANDED_IN.items():
        chapter = tmp_path / student / "ch02_vectors"
        chapter.mkdir(parents=True)
        (chapter / "vector.py").write_text("raise SystemExit('run')\n", encoding="utf-8")
        if text is not None:
            (chapter / "answers.md").write_text(text, encoding="utf-8")
    (tmp_path / "gus/ch02_vectors").mkdir(parents=True)
    (tmp_path / "gus/ch02_vectors/answers.md").write_bytes("## 2.2b\n\nschön\n".encode("cp1252"))
    return tmp_path


def test_answers_are_collected_as_they_were_handed_in(folder: Path) -> None:
    first, second = collect_tasks(read_class(folder).submissions, select_chapters("2-3"))
    assert (first.exercise.id, second.exercise.id) == ("2.2b", "2.3")
    assert first.question.startswith("a . b = |a| |b| cos t. Why does the sign")
    assert first.rubric.startswith("- 0.5 points: The two lengths are never negative")
    assert "**Rubric**" not in first.model
    by = {answer.submission.student: answer for answer in first.answers}
    assert sorted(by) == ["ann", "bob", "cem", "dan", "eve", "fay", "gus"]
    assert by["ann"].text == "The lengths are never negative, so the cosine decides."
    assert (by["bob"].text, by["bob"].note) == ("", "")
    assert by["cem"].text == "|a|^2", "a formula is an answer"
    assert "Dan's answer" in by["dan"].text
    assert by["dan"].note.startswith("This is the whole file. No heading in answers.md begins")
    assert (by["eve"].text, by["eve"].note) == ("", "")
    assert by["fay"].text.startswith(SHOUT + "\\x1b[31m")
    assert len(by["fay"].text) < LONGEST + 200
    assert "answers.md was rejected" in by["gus"].note
    assert [answer.text == "" for answer in first.answers] == [False] * 4 + [True] * 3


def test_the_order_is_no_order_of_names_and_stays_as_it_is(folder: Path) -> None:
    first, second, *again = (
        [answer.submission.student for answer in task.answers]
        for _ in range(2)
        for task in collect_tasks(read_class(folder).submissions, select_chapters("2"))
    )
    assert again == [first, second]
    assert sorted(first) != first != second


@pytest.fixture
def address(folder: Path) -> Iterator[str]:
    with marking(folder, "2") as address:
        yield address


def ask(address: str, path: str = "", body: Any = None, **headers: str) -> tuple[int, Any, str]:
    """Ask the server as its own page would, unless headers say otherwise."""
    if body is not None:
        own = {"Origin": address.rsplit("/", 2)[0], "Content-Type": "application/json"}
        headers = own | headers
        body = body if isinstance(body, bytes) else json.dumps(body).encode()
    try:
        answer = urlopen(Request(address + path, body, headers))
    except HTTPError as error:
        answer = error
    text = answer.read().decode()
    is_json = answer.headers["Content-Type"].startswith("application/json")
    policy = answer.headers["Content-Security-Policy"]
    return answer.status, json.loads(text) if is_json else text, policy


def test_the_server_shows_its_own_page_alone_and_no_names(address: str) -> None:
    for path in ("", "main.js", "marks.js", "style.css", "look/style.css"):
        status, _, policy = ask(address, path)
        assert (status, "frame-ancestors 'none'" in policy) == (200, True), path
    top = address.rsplit("/", 2)[0]
    for path in ("../answers.py", "%2e%2e/answers.py", "look/index.html", "look/../answers.py"):
        assert ask(address, path)[0] in (403, 404), path
    assert ask(f"{top}/")[0] == ask(f"{top}/guess/questions.json")[0] == 404
    assert ask(address, "questions.json", Host="evil.example")[0] == 403
    status, questions, _ = ask(address, "questions.json")
    assert status == 200
    assert not re.search(r"\b(ann|bob|cem|eve|fay|gus)\b", json.dumps(questions))


def test_the_server_takes_valid_marks_of_its_own_page_alone(address: str, folder: Path) -> None:
    code = ask(address, "questions.json")[1]["questions"][0]["answers"][0]["code"]
    one = {"exercise": "2.2b", "code": code, "seen": None}
    good = {**one, "mark": {"points": 0.5, "comment": "Why?"}}
    for headers, wanted in (
        ({"Origin": "http://evil.example"}, 403),
        ({"Origin": "null"}, 403),
        ({"Origin": ""}, 403),
        ({"Host": "evil.example", "Origin": "http://evil.example"}, 403),
        ({"Content-Type": "text/plain"}, 415),
    ):
        assert ask(address, "marks.json", good, **headers)[0] == wanted, headers
    marks: list[Any] = [{"points": p, "comment": ""} for p in (1.5, -1, True, "1", float("nan"))]
    marks += [{"points": 1, "comment": "x" * 5000}, {"points": 1}, 7]
    bad = [{**good, "mark": mark} for mark in marks]
    bad += [[], {**good, "code": "ann"}, {**good, "exercise": "2.9"}]
    for body in (*bad, b"[" * 100_000, b"9" * 5000, b"\xff"):
        status, answer, _ = ask(address, "marks.json", body)
        assert status == 400, body
        assert "this is not a valid mark" in answer["why"]
    assert not (folder / "marks.csv").exists()

    kept = {code: {**good["mark"], "changed": False}}
    status, saved, _ = ask(address, "marks.json", good)
    assert (status, saved["marks"]["2.2b"]) == (200, kept)
    text = (folder / "marks.csv").read_text(encoding="utf-8")
    assert re.search(r"\n(ann|cem|dan|fay),2\.2b,0\.5,Why\?\n$", text)
    other = {**one, "mark": {"points": 1, "comment": ""}}
    status, stale, _ = ask(address, "marks.json", other)
    assert (status, stale["marks"]["2.2b"]) == (409, kept)
    with (folder / "marks.csv").open("a", encoding="utf-8") as file:
        file.write("ann,2.3,nine,\n")
    status, broken, _ = ask(address, "marks.json", {**good, "seen": good["mark"], "mark": None})
    assert status == 503
    assert re.search("line 3: .* 'nine'", broken["why"])


def test_a_changed_answer_is_to_be_marked_again_under_the_name_of_the_roster(
    folder: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    roster = tmp_path_factory.mktemp("roster") / "roster.csv"
    roster.write_text("id,name,email,login\nann,Ann Lee,,\n", encoding="utf-8")
    file = folder / "ann/ch02_vectors/answers.md"
    mark = {"points": 0.5, "comment": ""}

    def known(address: str) -> dict[str, Any]:
        found = ask(address, "marks.json")[1]["marks"]["2.2b"]
        return next(iter(found.values()), {})

    with marking(folder, "2", "--roster", str(roster)) as address:
        answers = ask(address, "questions.json")[1]["questions"][0]["answers"]
        (code,) = [one["code"] for one in answers if one["text"].startswith("The lengths")]
        sent = {"exercise": "2.2b", "code": code, "mark": mark, "seen": None}
        assert ask(address, "marks.json", sent)[0] == 200
        assert known(address) == {**mark, "changed": False}
    assert "\nAnn Lee,2.2b,0.5,\n" in (folder / "marks.csv").read_text(encoding="utf-8")
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("The lengths", "Both lengths"), encoding="utf-8")
    with marking(folder, "2", "--roster", str(roster)) as address:
        assert known(address) == {**mark, "changed": True}
        assert ask(address, "marks.json", {**sent, "seen": known(address)})[0] == 200
        assert known(address) == {**mark, "changed": False}


def test_at_the_end_it_names_the_command_that_grades_this_class(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def stop(served: Coroutine[Any, Any, None]) -> None:
        served.close()
        raise KeyboardInterrupt

    monkeypatch.setattr("autograder.marking.marking_server.asyncio.run", stop)
    spaced = folder.rename(folder.with_name("lab 1"))
    monkeypatch.setattr("sys.argv", ["", "mark", str(spaced), "--chapters", "2", "--no-browser"])
    assert main() == 0
    assert f"make grade SUBMISSIONS='{spaced}' CHAPTERS=2\n" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("chapters", "words"),
    [("3", "there are no written exercises to mark"), ("2", "line 2: there is no student 'zoe'")],
)
def test_it_says_why_there_is_nothing_to_mark(folder: Path, chapters: str, words: str) -> None:
    from autograder.marking.marking_server import mark

    (folder / "marks.csv").write_text(
        "student,exercise,points,comment\nzoe,2.3,1,\n", encoding="utf-8"
    )
    with pytest.raises(ValueError, match=re.escape(words)):
        mark(folder, select_chapters(chapters), browser=False)
