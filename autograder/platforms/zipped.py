"""Pack files for a platform into a zip."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Collection, Mapping

FIRST_DATE = (1980, 1, 1, 0, 0, 0)  # of every file


def zipped(contents: Mapping[str, bytes], executable: Collection[str] = ()) -> bytes:
    """Pack files into a zip, and return its bytes, which are the same for the same files."""
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w") as file:
        for name in sorted(contents):
            entry = zipfile.ZipInfo(name, FIRST_DATE)
            entry.create_system = 3  # Unix, because modes are read only for this system
            entry.external_attr = (0o100755 if name in executable else 0o100644) << 16
            file.writestr(entry, contents[name], zipfile.ZIP_DEFLATED)
    return memory.getvalue()
