"""Write the student's files to the folder from which the checks and scenes import them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from autograder.manifest import ROOT

CHAPTERS = ROOT / "chapters"
TAKEN = re.compile(r"ch\d\d_[a-z0-9_]+/[^/]+")


class Folder:
    """The folder of the student's chapters. A file that the page has not sent is its stub."""

    def __init__(self, folder: Path = CHAPTERS) -> None:
        self.folder = folder
        self.stubs = {
            file.relative_to(folder).as_posix(): file.read_bytes()
            for file in folder.glob("*/*.*")
            if file.is_file()
        }
        self.there = dict(self.stubs)

    def lay(self, files: Mapping[str, str]) -> None:
        """Write these files, and reset all others to stubs. Raise ValueError for a wrong path."""
        for path in files:
            if not TAKEN.fullmatch(path):
                raise ValueError(f"a file's path must be chNN_name/name, got {path!r}")
        wanted = self.stubs | {path: text.encode("utf-8") for path, text in files.items()}
        for path in self.there.keys() - wanted.keys():
            (self.folder / path).unlink()
        for path, data in wanted.items():
            if self.there.get(path) != data:
                file = self.folder / path
                file.parent.mkdir(exist_ok=True)
                file.write_bytes(data)
        self.there = wanted
