"""Helpers that all commands share: set-up, finding an engine, and suggesting the next command."""

from __future__ import annotations

import errno
import importlib.util
import io
import os
import shutil
import sys
from pathlib import Path

from autograder.clean import clean
from autograder.make_venv import shown_python
from autograder.manifest import ROOT

# The option for each variable of make. Scenes, and the exercise of hint and reset, are positional.
OPTIONS = {
    "CH": "--chapter",
    "EX": "--exercise",
    "GIVEN": "--given",
    "ENGINE": "--engine",
    "N": "--count",
    "WHOLE": "--whole",
}
ADVICE = {
    (errno.ENOSPC, errno.EDQUOT): "Free some space on that disk, and run the same command again",
    (errno.EROFS, errno.EACCES, errno.EPERM): "Check who may write there, or use another folder",
    (errno.EFBIG,): "A limit on the size of files is too low here (see ulimit -f)",
}
MODULES = {"plot": "studies plot", "demo": "lab play", "lab": "lab serve"}  # of other packages


def prepare() -> bool:
    """Set up the output streams, and return whether the required packages are installed.

    If a package is missing, print how to install it. If file names are not encoded in UTF-8, as
    with LC_ALL=C and PYTHONUTF8=0, restart the program in Python's UTF-8 mode.
    """
    if sys.getfilesystemencoding() != "utf-8" and os.environ.get("PYTHONUTF8") != "1":
        os.environ["PYTHONUTF8"] = "1"  # also affects the processes that are started later
        os.execv(sys.executable, [sys.executable, *sys.orig_argv[1:]])
    for stream in (sys.stdout, sys.stderr):  # show ? for characters that the console cannot encode
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    if importlib.util.find_spec("pytest") is None:
        print(
            "this Python lacks the companion's packages. Run make setup (without make: run "
            f"{Path(sys.executable).name} autograder/make_venv.py, then use {shown_python()})",
            file=sys.stderr,
        )
        return False
    return True


def advice(error: BaseException) -> str:
    """Return advice on a file system error. For any other error, return an empty string."""
    number = error.errno if isinstance(error, OSError) else None
    return next((words for numbers, words in ADVICE.items() if number in numbers), "")


def sentence(error: Exception) -> str:
    """Return the text of ``error`` as a sentence, followed by advice if there is any."""
    what, words = clean(str(error)), advice(error)
    return f"{what}. {words}" if words else what


def find_engine(folder: str) -> list[Path]:
    """Return the engine for ``folder``, which is a list of folders with chapters.

    If a file exists in several folders, the first folder takes precedence.

    Raises:
        ValueError: The folder does not exist.
    """
    # Files that students do not edit exist only in chapters/.
    engine = [ROOT / name for name in dict.fromkeys((folder, "chapters"))]
    if not engine[0].is_dir():
        raise ValueError(f"engine must be a folder of chapters, got {folder!r}")
    return engine


def command(name: str, **variables: str) -> str:
    """Return the command line for the command ``name``.

    The command line uses make, or Python if make is missing. A student in the browser has no
    command line, but the buttons on the page have the same names as the make commands.
    """
    if sys.platform == "emscripten" or shutil.which("make"):
        return " ".join(["make", name, *(f"{key}={value}" for key, value in variables.items())])
    words = [shown_python(), "-m", MODULES.get(name, f"autograder {name}")]
    for key, value in variables.items():
        if key not in ("DEMO", "SCENE") and (key != "EX" or name == "check"):
            words.append(OPTIONS[key])
        if key != "WHOLE":
            words.append(value)
    return " ".join(words)


def engine_variables(engine: list[Path]) -> dict[str, str]:
    """Return the make variables that select ``engine``. The student's own engine needs none."""
    if engine[0] == ROOT / "chapters":
        return {}
    inside = engine[0].is_relative_to(ROOT)
    return {"ENGINE": (engine[0].relative_to(ROOT) if inside else engine[0]).as_posix()}


def check_command(engine: list[Path], **arguments: str) -> str:
    """Return the command that checks ``engine`` again.

    Commands print it as the next step.
    """
    return command("check", **arguments, **engine_variables(engine))
