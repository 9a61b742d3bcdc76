"""Compile /in/library and the course, and write the zips to /out. Runs in Pyodide under Node.

Importing a compiled module takes a fifth of the time. The student's modules, the checks and the
scenes are not compiled. Tracebacks show their source code, and the list of scenes is read from it.
Compiling the checks would save a tenth of a second once per chapter, but would add 0.8 MB.
"""

import importlib.util
import marshal
import sys
import zipfile
from pathlib import Path

SITE = f"/lib/python3.{sys.version_info.minor}/site-packages"
LIBRARY = f"/lib/python3{sys.version_info.minor}.zip"
COURSE = "/course"
SOURCE = ("chapters", "tests", "scenes")  # folders
MAGIC = importlib.util.MAGIC_NUMBER + (1).to_bytes(4, "little")  # 1: the source is not checked


def packed(folder: Path, place: str, prefix: str = "") -> dict[str, bytes]:
    """Return the files of a folder with most of the modules compiled.

    `place` is the folder in which they will be at run time.
    """
    files = {}
    for path in folder.rglob("*"):
        if path.is_file():
            name, data = path.relative_to(folder).as_posix(), path.read_bytes()
            if name.endswith(".py") and not set(name.split("/")) & set(SOURCE):
                data, name = compiled(data, f"{place}/{name}"), f"{name}c"
            files[prefix + name] = data
    return files


def compiled(source: bytes, place: str) -> bytes:
    """Return the contents of a .pyc file, for a module that will be at this path."""
    code = compile(source, place, "exec", dont_inherit=True)
    return MAGIC + importlib.util.source_hash(source) + marshal.dumps(code)


def write_zip(name: str, files: dict[str, bytes]) -> None:
    """Write a zip that is identical, byte for byte, in every build."""
    with zipfile.ZipFile(f"/out/{name}", "w") as archive:
        for path in sorted(files):
            info = zipfile.ZipInfo(path, (2020, 1, 1, 0, 0, 0))
            info.external_attr = 0o644 << 16
            archive.writestr(info, files[path], zipfile.ZIP_DEFLATED, 9)


if Path("/in/library").exists():  # otherwise an earlier build has kept it
    write_zip("pyodide/python_stdlib.zip", packed(Path("/in/library"), LIBRARY))
packages = packed(Path("/in/packages"), SITE, "packages/")
write_zip("course.zip", packages | packed(Path("/in/course"), COURSE, "course/"))
