"""Which submissions a class's folder has, what reports are called, and how names are shown."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from autograder.submissions.class_list import read_class
from autograder.submissions.find import file_name
from autograder.text.clean import clean


def test_folders_and_zips_are_submissions_sorted_by_student(tmp_path: Path) -> None:
    for name in ("zoe", "[red]Åsa B", "ann", "ann.zip", "bob-b"):  # a folder like a zip, too
        (tmp_path / name).mkdir()
    for name in ("bob.zip", "Carl.ZIP", "d.e.Zip"):
        (tmp_path / name).touch()
    people = read_class(tmp_path)
    paths = ["Carl.ZIP", "[red]Åsa B", "ann", "ann.zip", "bob.zip", "bob-b", "d.e.Zip", "zoe"]
    assert [item.path for item in people.submissions] == [tmp_path / name for name in paths]
    names = ["Carl", "[red]Åsa B", "ann", "ann.zip", "bob", "bob-b", "d.e", "zoe"]
    assert ([item.student for item in people.submissions], people.notes) == (names, [])


def test_what_cannot_be_graded_is_handed_in_and_what_is_not_a_students_is_noted(
    tmp_path: Path,
) -> None:
    for name in ("ann", "__MACOSX", "__pycache__", ".git"):
        (tmp_path / name).mkdir()
    for name in ("marks.csv", ".DS_Store", "notes.txt", "bob.tar.gz", "cy.PDF", "odd\n.txt"):
        (tmp_path / name).touch()
    (tmp_path / "ann.pdf").touch()
    (tmp_path / "carl").symlink_to("ann")
    (tmp_path / "dan.zip").symlink_to("notes.txt")
    people = read_class(tmp_path)
    why = "cannot be graded: it is neither a folder nor a .zip file"
    assert {one.student: one.nothing for one in people.submissions} == {
        "ann": "",
        "bob": f"'bob.tar.gz' {why}",
        "cy": f"'cy.PDF' {why}",
    }
    (note,) = people.submissions[0].notes
    assert note.startswith("'ann' was graded, and 'ann.pdf' was not: it is neither")
    assert sorted(people.notes) == [
        "carl was left out: it is a symbolic link",
        "dan.zip was left out: it is a symbolic link",
        "notes.txt was left out: it is neither a folder nor a .zip file",
        "odd\\n.txt was left out: it is neither a folder nor a .zip file",
    ]


def test_a_class_that_is_none_is_refused(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").touch()
    for name in ("notes.txt", "lab1.zip"):  # the second is not there
        with pytest.raises(
            ValueError, match=rf"must be in an existing folder or zip, got '.*/{name}'"
        ):
            read_class(tmp_path / name)


def test_the_folder_of_one_student_is_no_class(tmp_path: Path) -> None:
    (tmp_path / "ann/ch02_vectors").mkdir(parents=True)
    assert [one.student for one in read_class(tmp_path).submissions] == ["ann"]
    with pytest.raises(ValueError, match="has a folder ch02_vectors and so is the work of one stu"):
        read_class(tmp_path / "ann")


@pytest.mark.skipif(os.name != "posix", reason="other systems have no such names")
def test_strange_names_are_told_apart_and_can_be_printed(tmp_path: Path) -> None:
    names = ["a\n", "a\\n", "a\\\\n", "a\r", "a\udcff", "a\\udcff", "a\x1b[31m", "a\x7f", "a\u202e"]
    names += ["a\u200b", "a", "a ", "é", "e\u0301", "\udce9", "=1+1", "-x", "x" * 255, "x" * 254]
    for name in names:
        (tmp_path / name).mkdir()
    found = [submission.student for submission in read_class(tmp_path).submissions]
    assert len(set(found)) == len(names)
    assert len({file_name(student) for student in found}) == len(names)
    for student in found:
        assert student.isprintable()
        assert student.encode().decode() == student
    assert {"a", "a ", "é", "=1+1", "-x", "a\\n", "a\\udcff", "x" * 255} <= set(found)


# The names of reports


@pytest.mark.parametrize(
    "student",
    ["ann", "[red]Åsa B", "Жанна", "李小龙", "O'Neil, Shaq (2)", "a.b", "=1+1", "x" * 100, "a-b"],
)
def test_harmless_names_stay_as_they_are(student: str) -> None:
    assert file_name(student) == student


STRANGE = st.text(
    st.characters(codec=None) | st.sampled_from("/\\.\n\0-0a\udcff\u202e:é"), max_size=300
)


@given(st.lists(STRANGE, unique=True, min_size=1, max_size=20))
def test_file_names_are_safe_short_and_each_students_own(names: list[str]) -> None:
    # What one name turns into could be another's own.
    names = sorted({*names, *map(file_name, names), *(file_name(n) + "x" for n in names)})
    made = [file_name(name) for name in names]
    assert len(set(made)) == len(names)
    assert file_name("CON") != "CON", "a device of Windows"
    for name in made:
        assert 0 < len(name.encode()) <= 100
        assert not name.startswith(".")
        assert not set(name) & set('/\\\0<>:"|?*')
        assert name.isprintable()


@given(st.text(st.characters(codec=None)))
def test_a_clean_text_can_be_printed_and_encoded_and_is_not_changed_again(text: str) -> None:
    shown = clean(text)
    assert all(line.isprintable() for line in shown.replace("\t", "\n").split("\n"))
    assert shown.encode("utf-8").decode("utf-8") == shown
    assert clean(shown) == shown
