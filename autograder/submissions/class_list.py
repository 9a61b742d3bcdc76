"""Find out who is in a class by matching the submissions with the students on the roster."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from autograder.submissions.find import Submission, printable
from autograder.submissions.roster import Student, key, letters

_Index = defaultdict[str, list[Student]]


@dataclass(frozen=True)
class Member:
    """A member of the class: a student on the roster, the author of a submission, or both.

    Attributes:
        shown: The student's name in all reports.
        student: The entry on the roster, or None if there is none.
        submission: The submission, or None if the student has not handed anything in.
    """

    shown: str
    student: Student | None
    submission: Submission | None

    @property
    def folder(self) -> str:
        return self.submission.student if self.submission else ""

    @property
    def aliases(self) -> tuple[str, ...]:
        """All names of this student, both on the submission and on the roster.

        The student's id, e-mail address and login count as names too.
        """
        who = self.student
        known = (who.name, who.id, who.email, who.login) if who else ()
        return tuple(name for name in (self.folder, *known) if name)


@dataclass(frozen=True)
class ClassList:
    """All students of a class, from the roster and from the submissions.

    Without a roster, the class consists of the students who have handed something in.
    """

    members: list[Member]
    has_roster: bool = False

    @property
    def submissions(self) -> list[Submission]:
        """The submissions of the class, sorted by student.

        Each submission is listed under the student's name in the reports.
        """
        renamed = [
            replace(member.submission, student=member.shown, aliases=member.aliases)
            for member in self.members
            if member.submission
        ]
        return sorted(renamed, key=lambda submission: submission.student)

    @property
    def missing(self) -> list[str]:
        """The names of the students on the class's roster who have not handed anything in."""
        return [member.shown for member in self.members if not member.submission]

    @property
    def unmatched(self) -> list[str]:
        """The names of the submissions that do not match any student on the class's roster."""
        return [m.shown for m in self.members if self.has_roster and not m.student]

    @property
    def names(self) -> dict[str, str]:
        """A map from each name of a student, such as an id or a login, to the name used in reports.

        Names that two students share are left out. Students who have not handed anything in are
        left out too.
        """
        claims = defaultdict(set)
        for member in self.members:
            for name in (member.shown, *member.aliases):
                claims[name].add(member.shown)
        submitted = {member.shown for member in self.members if member.submission}
        return {
            name: min(shown)
            for name, shown in claims.items()
            if len(shown) == 1 and shown <= submitted
        }

    def renamed(self, name: Callable[[Member], str]) -> ClassList:
        """Return a copy of the class list in which the students have new names for the reports.

        ``name`` is a function that returns the new name of a member. Anonymous grading uses this
        method to replace names with codes.
        """
        members = [replace(member, shown=name(member)) for member in self.members]
        return replace(self, members=sorted(members, key=lambda member: member.shown))


def match(
    submissions: list[Submission], roster: list[Student] | None, path: Path | None
) -> ClassList:
    """Match each submission with a student on the roster, and return the members of the class.

    Submissions that match nobody are members too, and so are students who have not handed anything
    in.

    Raises:
        ValueError: A submission matches two students, or a student matches two submissions. The
            message gives the lines of the roster, which was read from ``path``.
    """
    if roster is None:
        return ClassList([Member(one.student, None, one) for one in submissions])
    by_key, by_name = _Index(list), _Index(list)
    for student in roster:
        for text in student.keys:
            by_key[text].append(student)
        for text in student.names - {""}:
            by_name[text].append(student)
    found: dict[int, Submission] = {}
    members = []
    for submission in submissions:
        students = _students_of(submission, by_key, by_name)
        if len(students) > 1:
            lines = " and ".join(str(student.line) for student in students)
            raise ValueError(
                f"{path}, lines {lines}: both match the submission {submission.path.name!r}. "
                "Rename it to its student's id"
            )
        if not students:
            members.append(Member(submission.student, None, submission))
            continue
        line = students[0].line
        if line in found:
            raise ValueError(
                f"{path}, line {line}: {students[0].name} matches two submissions, "
                f"{found[line].path.name!r} and {submission.path.name!r}. Keep one of them"
            )
        found[line] = submission
    alike = Counter(letters(student.name) for student in roster)
    for student in roster:
        name = student.name
        if alike[letters(name)] > 1:
            name = f"{name} ({student.id})"
        members.append(Member(printable(name), student, found.get(student.line)))
    return ClassList(sorted(members, key=lambda member: member.shown), has_roster=True)


def _students_of(submission: Submission, by_key: _Index, by_name: _Index) -> list[Student]:
    """Find the students on the roster whose id or name matches a submission.

    The result should contain at most one student. The caller reports several matches as an error.
    """
    export = submission.export
    identity = submission.student
    if export:  # Moodle's number identifies a participant in one assignment, not a student
        identity = export.number if export.platform == "canvas" else ""
    alike = by_name[letters(export.name if export else submission.student)]
    same = by_key[key(identity)]
    if not same:
        return alike
    if export and alike and not any(student in alike for student in same):
        return [*same, *alike]  # the id comes from another system
    return same
