"""Compile Python's standard library and the course, and pack them into archives for the browser.

This script runs in Pyodide under Node.js, reads the folder /in and writes to /out.

Compiled modules are imported five times as fast as source files. The student's modules, the checks
and the scenes are left as source files, for two reasons. Tracebacks show their code, and the list
of scenes is read from it. Compiling the checks would save a tenth of a second once per chapter, but
would add 0.8 MB.
"""

import importlib.util
import io
import lzma
import marshal
import sys
import zipfile
from pathlib import Path

SITE = f"/lib/python3.{sys.version_info.minor}/site-packages"
LIBRARY = f"/lib/python3{sys.version_info.minor}.zip"
COURSE = "/course"
SOURCE = ("chapters", "tests", "scenes")  # folders
MAGIC = importlib.util.MAGIC_NUMBER + (1).to_bytes(4, "little")  # 1: the source is not checked


def packed(folder: Path, place: str, prefix: str = "", optimize: int = 0) -> dict[str, bytes]:
    """Read the files of a folder, and compile most of the Python modules among them.

    `place` is the path of the folder at run time. `optimize` is Python's optimization level. Level
    2 removes docstrings from the modules.

    Returns:
        A dict from the path of each file in the archive to the contents of the file.
    """
    files = {}
    for path in folder.rglob("*"):
        if path.is_file():
            name, data = path.relative_to(folder).as_posix(), path.read_bytes()
            if name.endswith(".py") and not set(name.split("/")) & set(SOURCE):
                data, name = compiled(data, f"{place}/{name}", optimize), f"{name}c"
            files[prefix + name] = data
    return files


def compiled(source: bytes, place: str, optimize: int) -> bytes:
    """Compile the source code of a module, and return the contents of its .pyc file.

    `place` is the path of the module at run time.
    """
    code = compile(source, place, "exec", dont_inherit=True, optimize=optimize)
    return MAGIC + importlib.util.source_hash(source) + marshal.dumps(code)


def zipped(files: dict[str, bytes], method: int) -> bytes:
    """Pack files into a zip archive.

    Every file gets the same time stamp, so building an unchanged site twice gives identical bytes.
    """
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        for path in sorted(files):
            info = zipfile.ZipInfo(path, (2020, 1, 1, 0, 0, 0))
            info.external_attr = 0o644 << 16
            archive.writestr(info, files[path], method, 9)
    return content.getvalue()


if Path("/in/library").exists():  # otherwise an earlier build has kept it
    library = zipped(packed(Path("/in/library"), LIBRARY), zipfile.ZIP_DEFLATED)
    Path("/out/pyodide/python_stdlib.zip").write_bytes(library)
packages = packed(Path("/in/packages"), SITE, "packages/")
course = packages | packed(Path("/in/course"), COURSE, "course/", optimize=2)
# Files that are compressed together take a third less than in a zip that compresses each by itself.
together = lzma.compress(zipped(course, zipfile.ZIP_STORED))
Path("/out/course.xz").write_bytes(together)
