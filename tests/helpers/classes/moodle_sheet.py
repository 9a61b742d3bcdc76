"""Grading worksheets as Moodle writes them, and a reader that follows the rules of its importer."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Language:
    """Moodle's texts in one language, from its language packs (mod_assign, moodle, langconfig)."""

    recordid: str
    hiddenuser: str
    fullname: str
    email: str
    idnumber: str
    status: str
    gradenoun: str
    maxgrade: str
    gradecanbechanged: str
    lastmodifiedsubmission: str
    lastmodifiedgrade: str
    comments: str
    submitted: str
    yes: str
    decsep: str
    time: str


ENGLISH = Language(
    *("Identifier", "Participant ", "Full name", "Email address", "ID number", "Status"),
    *("Grade", "Maximum grade", "Grade can be changed", "Last modified (submission)"),
    *("Last modified (grade)", "Feedback comments", "Submitted for grading", "Yes", "."),
    "Friday, 23 October 2026, 8:15 PM",
)
GERMAN = Language(
    *("ID", "Teilnehmer/in", "Vollständiger Name", "E-Mail-Adresse", "ID-Nummer", "Status"),
    *("Bewertung", "Bestwertung", "Bewertung kann geändert werden", "Zuletzt geändert (Abgabe)"),
    *("Zuletzt geändert (Bewertung)", "Feedback als Kommentar", "Zur Bewertung abgegeben", "Ja"),
    *(",", "Freitag, 23. Oktober 2026, 20:15"),
)
JAPANESE = Language(
    *("ID", "参加者", "氏名", "メールアドレス", "IDナンバー", "ステータス"),
    *("評点", "最大評点", "評点変更可", "最終更新日時 (提出)", "最終更新日時 (評定)"),
    *("フィードバックコメント", "評定のために提出済み", "Yes"),
    *(".", "2026年 10月 23日(金曜日) 20:15"),
)
LANGUAGES = {"English": ENGLISH, "German": GERMAN, "Japanese": JAPANESE}


@dataclass(frozen=True)
class Sheet:
    """The settings of a Moodle assignment that decide which columns its worksheet has."""

    language: Language = ENGLISH
    most: float = 100
    identity: tuple[str, ...] = ("idnumber", "email")
    anonymous: bool = False
    overrides: bool = False  # three columns with dates
    teams: bool = False
    workflow: bool = False  # a column for the marker and one for the state
    online_text: bool = False
    submissions: bool = True  # False if there is nothing to hand in
    graded: dict[int, str] = field(default_factory=dict)


PEOPLE = {
    12: ("Ann Lee", "u77", "ann@x.org"),
    13: ("Bo O'Neill", "u78", "bo@x.org"),
    15: ("Cy", "", "cy@x.org"),
    14: ("Bo O'Neill", "u80", "bo2@x.org"),
}
NOT_THERE = 15  # has handed nothing in


def download(sheet: Sheet, people: dict[int, tuple[str, str, str]] = PEOPLE) -> str:
    """Return a worksheet with the columns of mod/assign/gradingtable.php, and with commas."""
    say = sheet.language
    most = f"{sheet.most:.2f}".replace(".", say.decsep)
    rows: list[dict[str, str]] = []
    for number, (name, idnumber, email) in people.items():
        there = number != NOT_THERE
        row = {say.recordid: f"{say.hiddenuser}{number}"}
        if not sheet.anonymous:
            row[say.fullname] = name
            known = {"idnumber": idnumber, "email": email, "phone1": "0301234"}
            known["username"] = f"user{number}"
            for each in sheet.identity:
                row[getattr(say, each, each)] = known[each]
        row[say.status] = say.submitted if there else "-"
        if sheet.overrides:
            row |= {"allowed from": "-", "due": say.time, "cut-off": "-"}
        if sheet.teams:
            row["group"] = "Group 1"
        if sheet.workflow:
            row["marker"] = ""
        row[say.gradenoun] = sheet.graded.get(number, "")
        row[say.maxgrade] = most
        if sheet.workflow:
            row["state"] = "Not marked"
        row[say.gradecanbechanged] = say.yes
        if sheet.submissions:
            row[say.lastmodifiedsubmission] = say.time if there else "-"
        if sheet.online_text:
            row["online text"] = '<p>It took me\n"4, 5" hours.</p>' if number == 12 else ""
        row[say.lastmodifiedgrade] = say.time if number in sheet.graded else "-"
        row[say.comments] = '<p>Well done,\nAnn; "really"</p>' if number == 12 else ""
        rows.append(row)
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, [*rows[0]], lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def upload(
    content: bytes, sheet: Sheet, people: dict[int, tuple[str, str, str]] = PEOPLE
) -> tuple[dict[int, float], list[int]]:
    """Return the new grade of each participant, and those whose comments have changed.

    As importgradeslib.php and locallib.php in mod/assign/feedback/offline import a worksheet.
    """
    say = sheet.language
    text = content.decode("utf-8").removeprefix("\ufeff")
    header, *rows = csv.reader(io.StringIO(text, newline=""))
    assert {say.gradenoun, say.recordid, say.lastmodifiedgrade} <= {*header}, "rejected"
    old = [*csv.DictReader(io.StringIO(download(sheet, people), newline=""))]
    grades, changed = {}, []
    for cells, before in zip(rows, old, strict=True):
        row = dict(zip(header, cells, strict=True))
        number = int(row[say.recordid][len(say.hiddenuser) :])
        if row[say.comments] != before[say.comments]:
            changed.append(number)
        grade = row[say.gradenoun].replace(" ", "").replace(say.decsep, ".")  # unformat_float()
        if (
            grade
            and 0 <= float(grade) <= sheet.most
            and row[say.gradenoun] != before[say.gradenoun]
        ):
            grades[number] = float(grade)
    return grades, changed
