"""Find out who is in a class, and who has handed in what.

Each student is in exactly one state: something was handed in that can be graded, something that
cannot, or nothing. What cannot be decided is an error, and what is not used is in a note.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

from autograder.submissions.exports import without_suffix
from autograder.submissions.find import Submission, contents, find_entries, printable
from autograder.submissions.names import Names, letters
from autograder.submissions.owners import Owners, Who
from autograder.submissions.platform_files import Uploads
from autograder.submissions.roster import Student, read_roster


@dataclass(frozen=True)
class Member:
    """A member of the class: a student on the roster, the author of a submission, or both."""

    shown: str  # the name in all lists of students
    report: str  # the name of the report, which students of a group share
    student: Student | None
    submission: Submission | None

    @property
    def names(self) -> list[str]:
        """All names of the student on the roster, in the reports and on a platform."""
        names = [self.shown, self.report]
        if student := self.student:
            names += [*student.names, student.group]
        if submission := self.submission:
            names += [submission.path.name, without_suffix(submission.path)]
            if export := submission.export:
                names += [export.student, export.name]
                names += [export.number] if export.platform == "canvas" else []
            if submission.upload and len(submission.upload.people) == 1:
                names += submission.upload.people[0]
        return names


@dataclass(frozen=True)
class ClassList:
    """All students of a class. Without a roster, they are those who have handed something in."""

    members: list[Member]
    has_roster: bool = False
    notes: list[str] = field(default_factory=list)  # on what was not used
    gone: frozenset[str] = frozenset()  # the names of earlier reports

    @property
    def submissions(self) -> list[Submission]:
        """The submissions of the class, sorted by their names in the reports."""
        found = {m.report: m.submission for m in self.members if m.submission}
        return [replace(found[report], student=report) for report in sorted(found)]

    @property
    def absent(self) -> list[str]:
        """The names of the students on the class's roster who have not handed anything in."""
        return [member.shown for member in self.members if not member.submission]

    @property
    def unmatched(self) -> list[str]:
        """The names of the submissions that do not match any student on the class's roster."""
        return [m.shown for m in self.members if self.has_roster and not m.student]

    @cached_property
    def _names(self) -> Names[Member]:
        return Names((member, member.shown, member.names) for member in self.members)

    def members_of(self, name: str) -> list[Member]:
        """Return the student with this name, or all students of the group with this name.

        Raises:
            UnknownNameError: Nobody has this name.
            ValueError: Students with different reports have it.
        """
        found = self._names.all_of(name)
        if len({member.report for member in found}) != 1:
            raise self._names.problem(name, found)
        return found

    def report_of(self, name: str) -> str:
        """Return the name of a student's report, or "" if the student has handed in nothing."""
        if name in self.gone and not self._names.all_of(name):
            return ""
        member = self.members_of(name)[0]
        return member.report if member.submission else ""

    def students_of(self, report: str) -> list[str]:
        """Return the names of the students whom a report is about."""
        return [member.shown for member in self.members if member.report == report]


def read_class(folder: Path, roster: Path | None = None) -> ClassList:
    """Find the submissions in the folder of a class, and the student whom each one belongs to.

    A submission is a folder or a .zip file, named by its student or by a platform. If it is not
    clear whom submissions belong to, the ValueError lists all of them.
    """
    uploads = Uploads(folder)
    owners = Owners(read_roster(roster) if roster else None, roster, uploads)
    entries = find_entries(folder, owners.knows)
    problems: list[str] = []
    notes: list[str] = []
    found: dict[Who, list[Submission]] = {}
    for entry in entries:
        try:
            who = owners.of(entry)
        except ValueError as error:
            problems.append(str(error))
            continue
        if entry.is_by_student or isinstance(who[0], Student):
            found.setdefault(who, []).append(entry)
        else:
            notes.append(f"{printable(entry.path.name)} was left out: {entry.nothing}")
    submissions: dict[Who, Submission] = {}
    seen: dict[Student | str, Who] = {}
    for who, uploaded in found.items():
        if any(seen.setdefault(one, who) != who for one in who):
            problems.append(f"{owners.label(who)} handed in twice, with different students")
        try:
            chosen = _chosen(uploaded)
        except ValueError as error:
            problems.append(f"{owners.label(who)} {error}")
            continue
        names = [f"id {one.id}" if isinstance(one, Student) else f"submission {one}" for one in who]
        owner, upload = ", ".join(names), uploads.of(chosen.path)
        submissions[who] = replace(chosen, owner=owner, upload=upload)
    if problems:
        raise ValueError("\n".join(problems))
    if not submissions:
        raise ValueError(
            f"{str(folder)!r} has no submissions: a folder or a .zip file named after each student"
        )
    notes += [*owners.notes, *uploads.notes([entry.path for entry in entries])]
    return ClassList(_members(owners, submissions), owners.has_roster, notes)


def _order(entry: Submission) -> tuple[int, int]:
    return entry.export.order if entry.export else (0, 0)


def _chosen(entries: Sequence[Submission]) -> Submission:
    """Choose what is graded: of the uploads of one student to a platform, the last one."""
    usable = [entry for entry in entries if not entry.nothing]
    last = max(usable or entries, key=_order)
    uploaders = {entry.export and entry.export.student for entry in usable}
    is_ordered = len(uploaders) == 1 and None not in uploaders
    rivals = [one for one in usable if not is_ordered or _order(one) == _order(last)]
    # Moodle has the same files for each student of a team.
    if rivals[1:] and (None in uploaders or len({contents(one.path) for one in rivals}) > 1):
        names = " and ".join(repr(entry.path.name) for entry in rivals)
        raise ValueError(f"must hand in only once, got {names}. Keep one of them")
    notes, nothing = [], []
    for entry in entries:
        name, why = printable(entry.path.name), entry.nothing
        nothing.append(f"'{name}' cannot be graded: {why}")
        if entry is not last:
            again = "it was uploaded earlier. Put all files into one zip"
            why = why or ("it has the same files" if entry in rivals else again)
            notes.append(f"'{printable(last.path.name)}' was graded, and '{name}' was not: {why}")
    if usable:
        return replace(last, notes=tuple(notes))
    return replace(last, nothing="; ".join(nothing))


def _members(owners: Owners, submissions: Mapping[Who, Submission]) -> list[Member]:
    """Make the list of all students, with the names under which they and their reports appear."""
    alike = Counter(letters(student.name) for student in owners.roster)
    members: list[Member] = []
    reports: dict[str, Who] = {}
    for who in {**dict.fromkeys(owners.absent(submissions)), **submissions}:
        students = [one if isinstance(one, Student) else None for one in who]
        names = [
            str(one)
            if not isinstance(one, Student)
            else printable(f"{one.name} ({one.id})" if alike[letters(one.name)] > 1 else one.name)
            for one in who
        ]
        report = ", ".join(names)
        groups = {one.group for one in students if one} - {""}
        if len(who) > 1 and len(groups) == 1:
            report = printable(f"{groups.pop()} ({report})")
        if (other := reports.setdefault(report, who)) != who:
            raise ValueError(
                f"the reports on {owners.label(other)} and on {owners.label(who)} would both be "
                f"called {report!r}. Rename the submission to its student's id"
            )
        for name, student in zip(names, students, strict=True):
            members.append(Member(name, report, student, submissions.get(who)))
    return sorted(members, key=lambda member: member.shown)
