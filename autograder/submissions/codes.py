"""Replace students' names with codes, so that the reports on a class are anonymous.

A key file tells the instructor which student each code stands for.
"""

from __future__ import annotations

import base64
import csv
import hashlib
import hmac
import io
import os
import re
import secrets
from dataclasses import replace
from pathlib import Path

from autograder.file_lock import locked
from autograder.submissions.class_list import ClassList, Member
from autograder.submissions.csv_rows import Mistakes, as_cell, read_csv

COLUMNS = ["code", "id", "name", "email", "login", "submission"]
CODE = re.compile(r"[a-z2-7]{5}-[a-z2-7]{5}")
SECRET = "(secret)"  # the row that contains the secret begins with this cell
QUOTED = re.compile(r"'.*'", re.DOTALL)


def with_codes(people: ClassList, path: Path) -> ClassList:
    """Give each student of a class a code instead of a name, and write the codes to a key file.

    The codes are computed from the students' ids and a secret in the key file. As long as that file
    exists, every student keeps the same code. For a submission that matches nobody on the roster,
    the name of the submission replaces the id.

    Returns:
        The class with a code as the name of each student.

    Raises:
        ValueError: The key file is damaged.
        OSError: The key file cannot be read or written.
    """
    # Two runs that begin together use the same secret.
    with locked(path.with_name(f".{path.name}.lock")):
        secret = _secret_in(path) if path.exists() else "s" + secrets.token_hex(20)
        rows = {}
        coded = []
        for one in people.members:
            member = _coded(one, secret)
            coded.append(member)
            who = one.student
            known = [who.id, who.name, who.email, who.login] if who else [""] * 4
            folder = one.submission.path.name if one.submission and who else one.shown
            rows[member.shown] = [*known, folder if one.submission else ""]
            if member.report != member.shown:
                rows[member.report] = ["", one.report, "", "", folder if one.submission else ""]
        # Reports on other assignments may have the codes of students who are not in this class.
        table = _rows_in(path) | {code: [code, *map(as_cell, row)] for code, row in rows.items()}
        text = io.StringIO(newline="")
        csv.writer(text).writerows(
            [COLUMNS, [SECRET, secret], *(table[code] for code in sorted(table))]
        )
        _write_private(path, text.getvalue())
    # Sorted by code, so that the order does not tell the names.
    return replace(people, members=sorted(coded, key=lambda member: member.shown))


def key_path(roster: Path | None, out: Path) -> Path:
    """Return the path of the key file, which tells which student each code stands for.

    The key file is stored next to the roster. If there is no roster, it is stored next to the
    folder with the reports.
    """
    beside = (roster or out).resolve()
    return beside.with_name(f"{beside.stem if roster else beside.name}-key.csv")


def without_names(note: str) -> str:
    """Remove students' names from a note, so that the note can go into an anonymous report.

    Quoted parts of the note, such as the name of a folder, are replaced because they may identify a
    student.
    """
    return QUOTED.sub("one of them", note)


def refuse_names(out: Path) -> None:
    """Raise ValueError if a folder already contains reports with students' names.

    Anonymous reports must not be added to such a folder.
    """
    for kind in ("results", "feedback", "gradescope"):
        for path in [*(out / kind).glob("*"), *(out / "earlier" / kind).glob("*")]:
            name = path.name if path.is_dir() else path.stem
            if not CODE.fullmatch(name):
                raise ValueError(
                    f"--anonymous needs another --out: {str(out)!r} contains reports with names, "
                    f"such as {path.relative_to(out)}"
                )


def _coded(member: Member, secret: str) -> Member:
    """Replace a student's name by a code. Tables may still contain the name."""
    who = f"id {member.student.id}" if member.student else f"submission {member.shown}"
    shown = _code(secret, who)
    is_alone = member.report == member.shown
    report = shown if is_alone else _code(secret, f"group {member.report}")
    known_as = (*member.known_as, member.shown, member.report)
    return replace(member, shown=shown, report=report, known_as=known_as)


def _code(secret: str, who: str) -> str:
    digest = hmac.new(secret.encode(), who.encode("utf-8", "surrogatepass"), hashlib.sha256)
    letters = base64.b32encode(digest.digest()).decode().lower()
    return f"{letters[:5]}-{letters[5:10]}"


def _secret_in(path: Path) -> str:
    _, _, cells = next(read_csv(path).rows("cell", Mistakes(path)), (2, 2, ["", ""]))
    if cells[0] != SECRET or not re.fullmatch(r"s[0-9a-f]{40}", cells[1]):
        raise ValueError(
            f"{path}, line 2: the secret is missing. Restore the file, or delete it to get new "
            "codes"
        )
    return cells[1]


def _rows_in(path: Path) -> dict[str, list[str]]:
    """Return the rows of a key file by their codes, or none if there is no such file."""
    if not path.exists():
        return {}
    mistakes = Mistakes(path)
    rows = {cells[0]: cells for _, _, cells in read_csv(path).rows("cell", mistakes)}
    mistakes.raise_any()
    return {code: cells for code, cells in rows.items() if code != SECRET}


def _write_private(path: Path, text: str) -> None:
    """Write the key file atomically, and make it readable only by its owner.

    The file must stay private, because it links each code to a student's name.
    """
    temporary = path.with_name(path.name + ".tmp")
    temporary.unlink(missing_ok=True)
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL
    with os.fdopen(os.open(temporary, flags, 0o600), "w", encoding="utf-8", newline="") as file:
        file.write(text)
    temporary.replace(path)
