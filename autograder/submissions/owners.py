"""Decide whom a submission belongs to: by its name, by the roster, and by the platform's files."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from pathlib import Path

from autograder.submissions.exports import OF_MOODLE, Exported
from autograder.submissions.find import Entry, printable
from autograder.submissions.names import Names, key, letters
from autograder.submissions.platform_files import Uploads
from autograder.submissions.roster import Student

Who = tuple[Student | str, ...]  # the students of a submission, or a name if there is no student


class Owners:
    """Finds the students on the roster whom a submission belongs to.

    Without a roster, or if a submission matches nobody, its owner is the name of the submission.
    """

    def __init__(self, roster: list[Student] | None, path: Path | None, uploads: Uploads) -> None:
        self.has_roster = roster is not None
        self.roster = roster or []
        self.path = path
        self._uploads = uploads
        self.notes: list[str] = []
        self._names = Names(
            (
                student,
                f"{student.name} in line {student.line}",
                (*student.names, *_on_submissions(student)),
            )
            for student in self.roster
        )
        groups: dict[str, list[Student]] = {}
        for student in self.roster:
            if student.group:
                groups.setdefault(key(student.group), []).append(student)
        self._groups = groups

    def knows(self, export: Exported) -> bool:
        """Return True if the roster has a student with the number or the name of an upload."""
        return bool(self._by_id(export) or self._by_canvas_name(export))

    def are_listed(self, who: Who) -> bool:
        """Return True if these are students on the roster."""
        return any(isinstance(one, Student) for one in who)

    def of(self, entry: Entry) -> Who:
        """Return the students to whom a submission belongs, or its name if they are not known.

        Raises:
            ValueError: It could be that of several students, or its id and its name disagree.
        """
        upload = self._uploads.of(entry.path)
        if upload and upload.people:
            also = (entry.export.name,) if entry.export else ()  # which must not disagree
            people = [self._person(entry, (*names, *also)) for names in upload.people]
            known = [student for student in people if student]
            if known and None in people:
                stranger = upload.people[people.index(None)][-1]
                self.notes.append(
                    f"{printable(entry.path.name)}: {upload.source} also names "
                    f"{printable(stranger)}, who is not on the roster"
                )
            if known:
                self._refuse_groups(entry, upload.source, known)
                return self._whole_group(known)
        if group := self._groups.get(key(entry.name)):
            return self._named_group(entry, group)
        student = self._of_export(entry, entry.export) if entry.export else self._named(entry)
        if student:
            return self._whole_group([student])
        name = printable(self._uploads.name_of(entry.path))
        return (name or (entry.export.student if entry.export else entry.name),)

    def lasting_name(self, who: Who) -> str:
        """Return how records call these students, whatever the names of reports are."""
        return ", ".join(
            f"id {one.id}" if isinstance(one, Student) else f"submission {one}" for one in who
        )

    def label(self, who: Who) -> str:
        """Return how an error message calls these students."""
        students = [one for one in who if isinstance(one, Student)]
        if not students:
            return ", ".join(map(str, who))
        lines = " and ".join(str(one.line) for one in students)
        names = " and ".join(one.name for one in students)
        return f"{self.path}, line{'s' if len(students) > 1 else ''} {lines}: {names}"

    def in_two(self, found: Iterable[Who]) -> list[str]:
        """Describe each student who is in two groups that have handed in."""
        seen: dict[Student | str, Who] = {}
        return [
            f"{self.label((one,))} is among the students of two submissions"
            for who in found
            for one in who
            if seen.setdefault(one, who) != who
        ]

    def absent(self, submissions: Collection[Who]) -> list[Who]:
        """Return the students on the roster who have handed in nothing, in their groups."""
        there = {one for who in submissions for one in who}
        left = [student for student in self.roster if student not in there]
        return [*dict.fromkeys(self._whole_group([student]) for student in left)]

    def group_of(self, who: Who, names: list[str]) -> str:
        """Return the name of the report on these students, who are shown with these names."""
        if len(who) == 1:
            return names[0]
        groups = {one.group for one in who if isinstance(one, Student)} - {""}
        together = ", ".join(names)
        return printable(f"{groups.pop()} ({together})") if len(groups) == 1 else together

    def _whole_group(self, students: list[Student]) -> Who:
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

    def _refuse_groups(self, entry: Entry, source: str, students: list[Student]) -> None:
        """Raise ValueError if students who handed in together are in different groups."""
        if len({key(student.group) for student in students if student.group}) > 1:
            groups = " and ".join(f"{one.name} (group {one.group!r})" for one in students)
            raise ValueError(
                f"{printable(entry.path.name)}: {source} says that {groups} handed in together. "
                f"Correct the groups in {self.path}"
            )

    def _named(self, entry: Entry) -> Student | None:
        return self._only(entry, self._names.all_of(entry.name))

    def _of_export(self, entry: Entry, export: Exported) -> Student | None:
        """Find the student whom a platform's name for an upload means."""
        if export.platform == "moodle":  # its number means a participant in one assignment
            return self._only(entry, self._names.all_of(export.name))
        by_id, by_name = self._by_id(export), self._by_canvas_name(export)
        if by_id and not by_name and not _resemble(by_id[0], export):
            raise ValueError(
                f"{printable(entry.path.name)}: its number {export.number} is that of "
                f"{by_id[0].name} in line {by_id[0].line} of {self.path}, but its name is not. "
                "Rename it to its student's id"
            )
        if by_id and not by_name:
            self.notes.append(
                f"{printable(entry.path.name)} is by {by_id[0].name}, because of its number. Its "
                "name is another one"
            )
        if by_id and by_name:
            both = [student for student in by_id if student in by_name]
            return self._only(entry, both or [*by_id, *by_name])
        return self._only(entry, by_id or by_name)

    def _by_id(self, export: Exported) -> list[Student]:
        if export.platform == "moodle":
            return []
        return [student for student in self.roster if key(student.id) == key(export.number)]

    def _by_canvas_name(self, export: Exported) -> list[Student]:
        name = letters(export.name)
        return [student for student in self.roster if name in student.canvas_names]

    def _person(self, entry: Entry, names: tuple[str, ...]) -> Student | None:
        """Find the student whom all these names mean, as far as anybody has them."""
        found: list[Student] | None = None
        for name in names:
            if fits := self._names.all_of(name):
                both = [student for student in fits if found is None or student in found]
                found = both or [*(found or []), *fits]
        return self._only(entry, found or [])

    def _only(self, entry: Entry, students: list[Student]) -> Student | None:
        if len(students) > 1:
            lines = " and ".join(str(line) for line in sorted(one.line for one in students))
            raise ValueError(
                f"{self.path}, lines {lines}: both match the submission {entry.path.name!r}. "
                f"{self._how_to_decide(entry)}"
            )
        return students[0] if students else None

    def _how_to_decide(self, entry: Entry) -> str:
        if not entry.export or entry.export.platform != "moodle":
            return "Rename it to its student's id"
        if self._uploads.of(entry.path):
            return f"Check that {OF_MOODLE} is the worksheet of this assignment"
        new = entry.path.name.replace(entry.export.name, "ID", 1)
        return (
            f"Save Moodle's grading worksheet as {OF_MOODLE} in {str(entry.path.parent)!r}, or "
            f"rename the submission to {new!r}, where ID is its student's id"
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
