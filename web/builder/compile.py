"""Runs in Pyodide under Node: compile /in/library and /in/course, and write the zips into /out.

Student's modules and checks stay source code, which tracebacks show. What pytest makes of the checks
is kept beside them: to make it takes ten times as long as to run them.
"""

import importlib.util
import marshal
import os
import shutil
import sys
import zipfile
from pathlib import Path

WRITTEN = 1577836800  # every file's time: compiled checks are taken for as old as their source
SITE = Path(f"/lib/python3.{sys.version_info.minor}/site-packages")
COURSE = Path("/course")
LIBRARY = f"/lib/python3{sys.version_info.minor}.zip"
KEPT_AS_SOURCE = ("chapters", "tests", "scenes")
MAGIC = importlib.util.MAGIC_NUMBER + (1).to_bytes(4, "little")  # not compared with any source


def compiled(source: bytes, place: str) -> bytes:
    """Return what a .pyc has in it, for a module that will be at this place."""
    code = compile(source, place, "exec", dont_inherit=True)
    return MAGIC + importlib.util.source_hash(source) + marshal.dumps(code)


def write_zip(name: str, files: dict[str, bytes]) -> None:
    """Write a zip that has the same bytes whenever it is written."""
    with zipfile.ZipFile(f"/out/{name}", "w") as archive:
        for path in sorted(files):
            info = zipfile.ZipInfo(path, (2020, 1, 1, 0, 0, 0))
            info.external_attr = 0o644 << 16
            archive.writestr(info, files[path], zipfile.ZIP_DEFLATED, 9)


def files_of(folder: Path) -> dict[str, Path]:
    """Return the files of a folder by their path in it."""
    found = {path.relative_to(folder).as_posix(): path for path in folder.rglob("*")}
    return {name: path for name, path in sorted(found.items()) if path.is_file()}


def seal(folder: Path, place: str) -> dict[str, bytes]:
    """Return the files of a folder, its modules compiled for this place and without source."""
    sealed = {}
    for name, path in files_of(folder).items():
        data = path.read_bytes()
        if name.endswith(".py"):
            sealed[f"{name}c"] = compiled(data, f"{place}/{name}")
        else:
            sealed[name] = data
    return sealed


def collect() -> None:
    """Have pytest collect the checks, which leaves them compiled in folders __pycache__."""
    os.environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"
    os.chdir(COURSE)
    sys.path.insert(0, str(COURSE))
    sys.dont_write_bytecode = False
    import pytest

    arguments = ["--collect-only", "-qq", "--engine=chapters", "-p", "no:cacheprovider"]
    for folder in sorted((COURSE / "tests").glob("ch??_*")):  # two chapters have a springs.py
        status = pytest.main([*arguments, str(folder)])
        if status:
            raise SystemExit(f"{folder.name}: the checks cannot be collected")


def main() -> None:
    """Write both zips."""
    write_zip("pyodide/python_stdlib.zip", seal(Path("/in/library"), LIBRARY))
    shutil.copytree("/in/packages", SITE, dirs_exist_ok=True)
    shutil.copytree("/in/course", COURSE)
    for path in COURSE.rglob("*"):
        os.utime(path, (WRITTEN, WRITTEN))
    collect()
    course = {
        f"packages/{name}": data for name, data in seal(Path("/in/packages"), str(SITE)).items()
    }
    for name, path in files_of(COURSE).items():
        parts = name.split("/")
        if "__pycache__" in parts:
            if parts[0] == "tests":
                course[f"course/{name}"] = path.read_bytes()
            continue
        data = path.read_bytes()
        if name.endswith(".py") and not set(parts) & set(KEPT_AS_SOURCE):
            course[f"course/{name}c"] = compiled(data, f"{COURSE}/{name}")
        else:
            course[f"course/{name}"] = data
    write_zip("course.zip", course)


main()
