"""Parse the names that Canvas and Moodle give to downloaded submissions."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

# A file is called lastfirst_LATE_userid_uploadid_work-1.zip. LATE_ is there only if it is late.
CANVAS = re.compile(
    r"(?:(?P<late>LATE_)?anon_(?P<anonymous>[^_]+)|(?P<name>.+?)_(?P<too_late>LATE_)?(?P<id>[0-9]+))"
    r"_(?P<upload>[0-9]+)_(?P<file>.+)"
)
# A folder is called Full Name_12345_assignsubmission_file, with another _ in older versions. If
# there are no folders, the name of the file follows.
MOODLE = re.compile(
    r"(?P<name>.+)_(?P<id>[0-9]+)_assignsubmission_(?P<kind>[a-z]+)(?:_(?P<file>.*))?"
)
OF_MOODLE = "worksheet.csv"  # instructors save the grading worksheet under this name
RESUBMITTED = re.compile(r"-([0-9]+)$")  # such as work-2, for a repeated upload of work


@dataclass(frozen=True)
class Exported:
    """The parts of the name that Canvas or Moodle gives to a downloaded submission."""

    platform: Literal["canvas", "moodle"]
    name: str  # the full name; on Canvas, the last and first name without a space
    number: str  # of the user on Canvas; on Moodle, it is valid for this assignment only
    late: bool  # Canvas marked the submission as late
    order: tuple[int, int]  # a later upload by the same student has a larger one
    is_file: bool = True  # False for text that was typed into the platform

    @property
    def student(self) -> str:
        """The student's name in the reports if there is no roster, such as doejane_1234."""
        return f"{self.name}_{self.number}"


def read_export(name: str) -> Exported | None:
    """Parse a name, or return None. Other names may have the format of Canvas by chance."""
    found = MOODLE.fullmatch(name) or CANVAS.fullmatch(name)
    if found is None:
        return None
    again = RESUBMITTED.search(found["file"] or "")
    times = int(again[1]) if again else 0
    if found.re is MOODLE:
        is_file = found["kind"] == "file"
        return Exported("moodle", found["name"], found["id"], False, (0, times), is_file)
    late, order = bool(found["late"] or found["too_late"]), (int(found["upload"]), times)
    who = ("anon", found["anonymous"]) if found["anonymous"] else (found["name"], found["id"])
    return Exported("canvas", *who, late, order)


def without_suffix(path: Path) -> str:
    """Return the name of a submission without a suffix, which a folder such as j.doe has not."""
    return path.name if path.is_dir() else path.stem


def look_like_canvas(exports: Sequence[Exported | None]) -> bool:
    """Return True if these names are those of a whole download from Canvas.

    Names such as hw_1_1_cat and hw_1_2_dan are not, which seem to be two uploads of one student.
    """
    found = [one for one in exports if one and one.platform == "canvas"]
    names, numbers = {one.name for one in found}, {one.number for one in found}
    are_people = len(names) > 1 or names == {"anon"} or len(found) == 1
    each_has_one_name = len({one.student for one in found}) == len(numbers)
    return len(found) == len(exports) and are_people and each_has_one_name
