"""The roster: how it is read, and what is refused with its line."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from autograder.submissions.roster import read_roster

HEADER = "id,name,email,login\n"


@pytest.mark.parametrize(
    ("content", "line"),
    [
        (HEADER + "1042,Ann Lee,ann@x.org,al7\n", 2),
        ("\ufeffID;Name;Email;Login\r\n1042;Ann Lee;ann@x.org;al7\r\n;;;\r\n", 2),
        ("login,section,name,id,email\n\n,,,,\nal7,B,Ann  Lee , 1042,ann@x.org,,\n", 4),
    ],
    ids=["plain", "excel with a BOM and semicolons", "other order and blank rows"],
)
def test_a_roster_is_read_as_spreadsheets_write_it(tmp_path: Path, content: str, line: int) -> None:
    file = tmp_path / "roster.csv"
    file.write_text(content, encoding="utf-8")
    (student,) = read_roster(file)
    assert (student.id, student.email, student.login, student.line) == (
        *("1042", "ann@x.org", "al7"),
        line,
    )
    assert student.name.split() == ["Ann", "Lee"]


@pytest.mark.parametrize(
    ("content", "line", "words"),
    [
        ("id,name,email\n1,Ann,a@x\n", 1, "no column 'login'. The header must have id,name,email,"),
        ("id,name,id,email,login\n", 1, "there are 2 columns 'id'"),
        ("", 1, "no column 'id'"),
        (HEADER + "1,Ann,,\n\n2,Bo,,\n01,Cy,,\n1,Di,,\n", 6, "the id '1' is already in line 2"),
        (HEADER + "1,Ann,a@x,\n2,Bo,A@X,\n", 3, "the email 'A@X' is already in line 2"),
        (HEADER + "1,Ann,,al\n2,Bo,,al\n", 3, "the login 'al' is already in line 2"),
        (HEADER + ",Ann,a@x,\n", 2, "the id is empty"),
        (HEADER + "1,,a@x,\n", 2, "the name is empty"),
        (HEADER + "1,Lee, Ann,a@x,al\n", 2, "must be 4 cells, got 5. Put a cell that contains ','"),
        (HEADER + "1;Ann;a@x;al\n", 2, "the name is empty"),
        (HEADER + '1,"Ann,a@x,al\n2,Bo,b@x,bo\n', 2, "Close the quote"),
        (HEADER + ",Ann,,\n1,,,\n", 3, "the name is empty"),  # all lines at once
        (HEADER + "=1+1,Ann,,\n", 2, "the id '=1+1' must not begin like a spreadsheet formula"),
        (HEADER + "1,Ann,@SUM(A1),\n", 2, "the email '@SUM(A1)' must not begin like a"),
        *(
            (f'{HEADER}"{number}",Ann,,\n', 2, f"the id '{number}' was rounded by a spreadsheet")
            for number in ("1.23457E+11", "1,23457E+11", "1E+05")
        ),
    ],
)
def test_a_mistake_in_a_roster_is_reported_with_its_line(
    tmp_path: Path, content: str, line: int, words: str
) -> None:
    file = tmp_path / "roster.csv"
    file.write_text(content, encoding="utf-8")
    with pytest.raises(ValueError, match=rf"roster\.csv, line {line}: .*{re.escape(words)}"):
        read_roster(file)


def test_other_rosters_are_refused(tmp_path: Path) -> None:
    file = tmp_path / "roster.csv"
    file.write_text(HEADER + ",,,\n", encoding="utf-8")
    with pytest.raises(ValueError, match="has no students below its header"):
        read_roster(file)
    file.write_bytes(HEADER.encode() + b"1,J\xfcrgen,,\n")
    with pytest.raises(ValueError, match="line 2: this is not UTF-8"):
        read_roster(file)
