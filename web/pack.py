"""Pack the Python code that the website runs in the browser with Pyodide.

The archive course.xz contains all chapters' tests and settings, with the parts of pytest and of
the tools that they import. Another archive contains Python's standard library. Modules are compiled
if that saves loading time. Two builds from the same sources produce identical files.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import shutil
import tempfile
import zipfile
from pathlib import Path
from sysconfig import get_path

from autograder.handouts.handout import make_handout
from autograder.handouts.stubs import LOCK_NAME
from autograder.manifest import ROOT, load_chapters
from web.imports import imported_by
from web.node import PACKAGES, WEB, run_node

KEPT = ROOT / "build" / "python-library"
OURS = ("autograder", "lab", "plots", "scenes", "studies", "web")
# Packages copied whole, because pytest finds their parts by name, and packages used only in part.
WHOLE, IN_PART = ("_pytest", "pytest", "pluggy", "iniconfig"), ("packaging", "py", "pygments")
SETS_UP = "make_venv.py"  # a browser has no .venv
PYTEST = "[tool.pytest.ini_options]"
LICENSED = ("pytest", "pluggy", "iniconfig", "packaging", "pygments")
# Parts of Python's library that need another process, a socket, a terminal or a database.
LEFT_OUT = "_pyrepl/ ctypes/macholib/ multiprocessing/ sqlite3/ wsgiref/ xmlrpc/ mailbox. imaplib."
LEFT_OUT += " smtplib. ftplib. poplib."


def pack(out: Path, *, with_solutions: bool = False) -> None:
    """Write the archives ``course.xz`` (a zip in xz format) and ``pyodide/python_stdlib.zip``.

    ``with_solutions`` adds the compiled reference, for students who skip a chapter. The compiled
    standard library is kept in build/, because compiling it takes most of the time.
    """
    library = out / "pyodide" / "python_stdlib.zip"
    library.parent.mkdir(parents=True, exist_ok=True)
    kept = KEPT / f"{_state_of_library()}.zip"
    with tempfile.TemporaryDirectory(prefix="pack-") as name:
        stage = Path(name)
        _stage_course(stage / "course", with_solutions=with_solutions)
        _stage_packages(stage / "packages", stage / "course")
        if not kept.exists():
            _stage_library(stage / "library")
        run_node("builder/compile.mjs", str(stage), str(out.resolve()))
    if kept.exists():
        shutil.copyfile(kept, library)
    else:
        KEPT.mkdir(parents=True, exist_ok=True)
        part = KEPT / f"{os.getpid()}.part"  # another build may be doing the same
        shutil.copyfile(library, part)
        part.replace(kept)


def _stage_course(folder: Path, *, with_solutions: bool) -> None:
    """Copy the tests, settings and tools into a folder, or the reference's modules too."""
    with tempfile.TemporaryDirectory(prefix="handout-") as place:
        handout = Path(place) / "handout"
        with contextlib.redirect_stdout(io.StringIO()):  # its output is meant for an instructor
            make_handout(load_chapters(), [], handout)
        _copy_tree(ROOT / "web" / "python", handout / "web" / "python", "*.py")
        text = '"""The course in a browser."""\n'
        (handout / "web" / "__init__.py").write_text(text, encoding="utf-8")
        # The pages' data has the stubs and the given modules of the chapters.
        _copy_tree(handout / "chapters", folder / "chapters", "chapter.toml")
        _copy_tree(handout / "tests", folder / "tests", "*")
        for name in (LOCK_NAME, "LICENSE"):
            _copy(handout / name, handout, folder)
        # pytest reads its settings in every run, and a whole file takes a seventh of a short one.
        settings = (handout / "pyproject.toml").read_text(encoding="utf-8")
        table = settings[settings.index(PYTEST) :].split("\n\n")[0]
        (folder / "pyproject.toml").write_text(f"{table}\n", encoding="utf-8")
        roots = [*handout.glob("web/python/**/*.py"), *handout.glob("lab/scenes/*/*.py")]
        roots += handout.glob("tests/**/*.py")
        for file in imported_by(roots, [handout], OURS):
            if file.name != SETS_UP:
                _copy(file, handout, folder)
    if with_solutions:
        _copy_tree(ROOT / "solutions", folder / "solutions", "*.py")


def _stage_packages(folder: Path, course: Path) -> None:
    """Copy pytest and its dependencies into a folder, and copy their licenses into the course."""
    site = Path(get_path("purelib"))
    for name in WHOLE:
        _copy_tree(site / name, folder / name, "*.py")
    for file in imported_by(folder.rglob("*.py"), [site], (*WHOLE, *IN_PART)):
        _copy(file, site, folder)
    for name in LICENSED:
        for file in sorted(site.glob(f"{name}-*.dist-info/licenses/*")):
            if file.is_file():
                (course / "licenses" / name).mkdir(parents=True, exist_ok=True)
                shutil.copyfile(file, course / "licenses" / name / file.name)


def _stage_library(folder: Path) -> None:
    """Copy Pyodide's standard library into a folder, without the parts that browsers cannot use."""
    left_out = tuple(LEFT_OUT.split())
    with zipfile.ZipFile(PACKAGES / "pyodide" / "python_stdlib.zip") as archive:
        wanted = [name for name in archive.namelist() if not name.startswith(left_out)]
        archive.extractall(folder, wanted)


def _state_of_library() -> str:
    """Hash everything that the compiled standard library depends on, to detect changes."""
    state = hashlib.sha256(LEFT_OUT.encode())
    for file in (PACKAGES / "pyodide" / "python_stdlib.zip", WEB / "builder" / "compile.py"):
        state.update(file.read_bytes())
    return state.hexdigest()[:16]


def _copy_tree(source: Path, target: Path, pattern: str) -> None:
    for file in sorted(source.rglob(pattern)):
        if file.is_file() and "__pycache__" not in file.parts:
            copy = target / file.relative_to(source)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)


def _copy(file: Path, source: Path, target: Path) -> None:
    copy = target / file.relative_to(source)
    copy.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(file, copy)
