"""Decide whom a submission belongs to: by its name, by the roster, and by the platform's files."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path

from autograder.submissions.exports import OF_MOODLE, Exported
from autograder.submissions.find import Entry, printable
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
        self._uploads = uploads
        self.notes: list[str] = []
        self._names = Names(
            (one, f"{one.name} in line {one.line}", (*one.names, *_on_submissions(one)))
            for one in self.roster
        )
        self._groups: dict[str, list[Student]] = {}
        for student in self.roster:
            if student.group:
                self._groups.setdefault(key(student.group), []).append(student)

    def knows(self, export: Exported) -> bool:
        """Return True if the roster has a student with the number or the name of an upload."""
        return bool(self._by_id(export) or self._by_canvas_name(export))

    def of(self, entry: Entry) -> Who:
        """Return the students to whom a submission belongs, or its name if they are not known.

        Raises:
            ValueError: It could be that of several students, or its id and its name disagree.
        """
        upload, export = self._uploads.of(entry.path), entry.export
        if upload and (known := self._uploaders(entry, upload)):
            return self._with_groups(known)
        if group := self._groups.get(key(entry.name)):
            return self._named_group(entry, group)
        found = self._of_export(entry, export) if export else self._names.all_of(entry.name)
        if student := self._only(entry, found):
            return self._with_groups([student])
        name = printable(self._uploads.name_of(entry.path))
        return (name or (export.student if export else entry.name),)

    def label(self, who: Who) -> str:
        """Return how an error message calls these students."""
        students = [one for one in who if isinstance(one, Student)]
        if not students:
            return ", ".join(map(str, who))
        lines = " and ".join(str(one.line) for one in students)
        names = " and ".join(one.name for one in students)
        return f"{self.path}, line{'s' if len(students) > 1 else ''} {lines}: {names}"

    def absent(self, submissions: Collection[Who]) -> list[Who]:
        """Return the students on the roster who have handed in nothing, in their groups."""
        there = {one for who in submissions for one in who}
        left = [student for student in self.roster if student not in there]
        return [*dict.fromkeys(self._with_groups([student]) for student in left)]

    def _uploaders(self, entry: Entry, upload: Upload) -> list[Student]:
        """Return the students whom a platform's file names, as far as the roster has them."""
        also = (entry.export.name,) if entry.export else ()  # which must not disagree
        people = [self._person(entry, (*names, *also)) for names in upload.people]
        known = [student for student in people if student]
        if known and None in people:
            stranger = printable(upload.people[people.index(None)][-1])
            self.notes.append(
                f"{printable(entry.path.name)}: {upload.source} also names {stranger}, who is not "
                "on the roster"
            )
        if len({key(student.group) for student in known if student.group}) > 1:
            groups = " and ".join(f"{one.name} (group {one.group!r})" for one in known)
            raise ValueError(
                f"{printable(entry.path.name)}: {upload.source} says that {groups} handed in "
                f"together. Correct the groups in {self.path}"
            )
        return known

    def _person(self, entry: Entry, names: tuple[str, ...]) -> Student | None:
        """Find the student whom all these names mean, as far as anybody has them."""
        found: list[Student] = []
        for name in names:
            if fits := self._names.all_of(name):
                both = [student for student in fits if not found or student in found]
                found = both or [*found, *fits]
        return self._only(entry, found)

    def _with_groups(self, students: list[Student]) -> Who:
        """Add everyone who is in a group with one of these students, in the order of the roster."""
        groups = {key(student.group) for student in students if student.group}
        return tuple(
            student
            for student in self.roster
            if student in students or (student.group and key(student.group) in groups)
        )

    def _named_group(self, entry: Entry, group: list[Student]) -> Who:
        """Return the group, unless the submission could also be that of another student."""
        for other in self.roster:
            if other not in group and key(entry.name) in map(key, other.names):
                raise ValueError(
                    f"{printable(entry.path.name)} could be by the group {group[0].group!r} or by "
                    f"{other.name} in line {other.line} of {self.path}. Rename the group there, "
                    f"such as to 'team {group[0].group}'"
                )
        return tuple(group)

    def _of_export(self, entry: Entry, export: Exported) -> list[Student]:
        """Find the students whom a platform's name for an upload could mean."""
        if export.platform == "moodle":  # its number means a participant in one assignment
            return self._names.all_of(export.name)
        by_id, by_name = self._by_id(export), self._by_canvas_name(export)
        if by_id and not by_name:
            name, student = printable(entry.path.name), by_id[0]
            if not _resemble(student, export):
                raise ValueError(
                    f"{name}: its number {export.number} is that of {student.name} in line "
                    f"{student.line} of {self.path}, but its name is not. Rename it to its "
                    "student's id"
                )
            self.notes.append(
                f"{name} is by {student.name}, because of its number. Its name is another one"
            )
        both = [student for student in by_id if student in by_name]
        return both or [*by_id, *by_name]

    def _by_id(self, export: Exported) -> list[Student]:
        if export.platform == "moodle":
            return []
        return [student for student in self.roster if key(student.id) == key(export.number)]

    def _by_canvas_name(self, export: Exported) -> list[Student]:
        name = letters(export.name)
        return [student for student in self.roster if name in student.canvas_names]

    def _only(self, entry: Entry, students: Sequence[Student]) -> Student | None:
        """Return the only one of these students, if any. Several are an error."""
        if len(students) < 2:
            return students[0] if students else None
        how = "Rename it to its student's id"
        if entry.export and entry.export.platform == "moodle":
            new = entry.path.name.replace(entry.export.name, "ID", 1)
            how = (
                f"Check that {OF_MOODLE} is the worksheet of this assignment"
                if self._uploads.of(entry.path)
                else f"Save Moodle's grading worksheet as {OF_MOODLE} in "
                f"{str(entry.path.parent)!r}, or rename the submission to {new!r}, where ID is "
                "its student's id"
            )
        lines = " and ".join(str(line) for line in sorted(one.line for one in students))
        raise ValueError(
            f"{self.path}, lines {lines}: both match the submission {entry.path.name!r}. {how}"
        )


def _on_submissions(student: Student) -> list[str]:
    """Return what else a submission may be called: the name in reports, and Moodle's for a team."""
    in_team = [f"{student.group}-{student.name}"] if student.group else []
    return [f"{student.name} ({student.id})", *in_team]


def _resemble(student: Student, export: Exported) -> bool:
    """Return True if a part of the student's name is in the name that Canvas has."""
    parts = [letters(part) for part in student.name.replace(",", " ").split()]
    name = letters(export.name)
    return any(len(part) > 1 and part in name for part in parts)
