"""Decide whom a submission belongs to: by its name, by the roster, and by the platform's files."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path

from autograder.submissions.exports import OF_MOODLE, Exported
from autograder.submissions.find import Submission, printable
from autograder.submissions.names import Names, key, letters
from autograder.submissions.platform_files import Upload, Uploads
from autograder.submissions.roster import Student

Who = tuple[Student | str, ...]  # the students of a submission, or a name if there is no student


class Owners:
    """Finds the students on the roster whom a submission belongs to."""

    def __init__(self, roster: list[Student] | None, path: Path | None, uploads: Uploads) -> None:
        self.has_roster = roster is not None
        self.roster = roster or []
        self.path = path
        self.notes: list[str] = []
        self._uploads = uploads
        self._names = Names(
            (one, f"{one.name} in line {one.line}", _names_on_submissions(one))
            for one in self.roster
        )

    def knows(self, export: Exported) -> bool:
        """Return True if the roster has a student with the number or the name from Canvas."""
        return any(self._on_canvas(export))

    def of(self, entry: Submission) -> Who:
        """Return the students to whom a submission belongs, or its name if they are not known."""
        upload, export = self._uploads.of(entry.path), entry.export
        found = self._uploaders(entry, upload) if upload else []
        if not found:
            found = self._of_export(entry, export) if export else self._names.all_of(entry.student)
            self._refuse_rivals(entry, found)
        if found:
            return self._with_groups(found)
        name = printable(self._uploads.name_of(entry.path))
        return (name or (export.student if export else entry.student),)

    def label(self, who: Who) -> str:
        """Return how an error message calls these students."""
        students = [one for one in who if isinstance(one, Student)]
        lines = " and ".join(str(one.line) for one in students)
        names = " and ".join(one.name for one in students)
        where = f"{self.path}, line{'s' if len(students) > 1 else ''} {lines}: {names}"
        return where if students else str(who[0])

    def absent(self, submissions: Collection[Who]) -> list[Who]:
        """Return the students on the roster who have handed in nothing, in their groups."""
        left = {*self.roster} - {one for who in submissions for one in who}
        return [*dict.fromkeys(self._with_groups([one]) for one in self.roster if one in left)]

    def _uploaders(self, entry: Submission, upload: Upload) -> list[Student]:
        """Return the students whom a platform's file names, as far as the roster has them."""
        also = (entry.export.name,) if entry.export else ()  # which must not disagree
        known: list[Student] = []
        strangers = []
        for names in upload.people:
            found: list[Student] = []
            for name in (*names, *also):
                fits = self._names.all_of(name)
                found = [student for student in fits if student in found] or [*found, *fits]
            self._refuse_rivals(entry, found)
            known += found
            if not found:
                strangers.append(printable(names[-1]))
        about = f"{printable(entry.path.name)}: {upload.source}"
        if known and strangers:
            self.notes.append(f"{about} also names {strangers[0]}, who is not on the roster")
        if len({key(student.group) for student in known if student.group}) > 1:
            groups = " and ".join(f"{one.name} (group {one.group!r})" for one in known)
            raise ValueError(
                f"{about} says that {groups} handed in together. Correct the groups in {self.path}"
            )
        return known

    def _with_groups(self, students: Sequence[Student]) -> Who:
        """Add everyone who is in a group with one of these students, in the order of the roster."""
        groups = {key(student.group) for student in students if student.group}
        return tuple(
            student
            for student in self.roster
            if student in students or (student.group and key(student.group) in groups)
        )

    def _of_export(self, entry: Submission, export: Exported) -> list[Student]:
        """Find the students whom a platform's name for an upload could mean."""
        if export.platform == "moodle":  # its number means a participant in one assignment
            return self._names.all_of(export.name)
        by_id, by_name = self._on_canvas(export)
        if by_id and not by_name:
            name, student = printable(entry.path.name), by_id[0]
            parts = map(letters, student.name.replace(",", " ").split())
            if not any(len(part) > 1 and part in letters(export.name) for part in parts):
                raise ValueError(
                    f"{name}: its number {export.number} is that of {student.name} in line "
                    f"{student.line} of {self.path}, but its name is not. Rename it to its "
                    "student's id"
                )
            self.notes.append(
                f"{name} is by {student.name}, because of its number. Its name is another one"
            )
        return [student for student in by_id if student in by_name] or [*by_id, *by_name]

    def _on_canvas(self, export: Exported) -> tuple[list[Student], list[Student]]:
        """Return the students with the number in a name from Canvas, and those with the name."""
        number, name = key(export.number), letters(export.name)
        by_name = [student for student in self.roster if name in student.canvas_names]
        return [student for student in self.roster if key(student.id) == number], by_name

    def _refuse_rivals(self, entry: Submission, students: Sequence[Student]) -> None:
        """Raise ValueError if a submission could be that of students who hand in separately."""
        if len({self._with_groups([student]) for student in students}) < 2:
            return
        how = "Rename it to its student's id or email"
        if entry.export and entry.export.platform == "moodle":
            how += f", or save the grading worksheet from Moodle as {OF_MOODLE} beside it"
        lines = " and ".join(str(line) for line in sorted({one.line for one in students}))
        raise ValueError(
            f"{self.path}, lines {lines} match the submission {entry.path.name!r}. {how}"
        )


def _names_on_submissions(student: Student) -> list[str]:
    """Return what a submission may be called: also as in reports, and as in Moodle for a team."""
    in_team = [student.group, f"{student.group}-{student.name}"] if student.group else []
    return [*student.names, f"{student.name} ({student.id})", *in_team]
