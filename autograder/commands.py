"""Prepare and run commands, and name the command that a user can type next."""

from __future__ import annotations

import errno
import importlib
import importlib.util
import io
import os
import shlex
import shutil
import sys
from collections.abc import Mapping
from pathlib import Path

from autograder.manifest import ROOT
from autograder.text.clean import clean

FULL = "Free some space on that disk, and run the same command again"
FORBIDDEN = "Make sure that you can write there, or use another folder"
ADVICE = {errno.EFBIG: "A limit on the size of files is too low here (see ulimit -f)"}
ADVICE |= dict.fromkeys((errno.ENOSPC, errno.EDQUOT), FULL)
ADVICE |= dict.fromkeys((errno.EROFS, errno.EACCES, errno.EPERM), FORBIDDEN)
# The packages that each lock adds, as they are called in import statements (see pyproject.toml).
PACKAGES = {
    "requirements": "pymunk pytest rich tornado watchfiles",
    "pictures": "matplotlib",
    "teaching": "dateparser jinja2 matplotlib msgspec yaml",
    "everything": "jinja2 matplotlib scipy yaml",
}
TUNED = "studies/tuned"  # the fast engine


class LackingError(Exception):
    """Some of the packages that a command needs are not installed. The message says what to do."""


def require(group: str) -> None:
    """Raise LackingError if Python lacks a package of students or of ``group``."""
    from autograder.make_venv import shown_python  # not in the browser

    needed = f"{PACKAGES['requirements']} {PACKAGES[group]}".split()
    lacking = [name for name in needed if importlib.util.find_spec(name) is None]
    if lacking and lacking[0] in PACKAGES["requirements"]:
        raise LackingError(
            "this Python lacks the companion's packages. Run make setup (without make: run "
            f"{Path(sys.executable).name} autograder/make_venv.py, then use {shown_python()})"
        )
    if lacking:
        raise LackingError(
            f"this Python lacks {lacking[0]}, which is one of the packages for this command. Run "
            f"{shown_python()} autograder/make_venv.py {group}, and then the same command again "
            f"with {shown_python()}"
        )


def prepare(group: str = "requirements") -> bool:
    """Prepare Python to run a command, or say which package of ``group`` is missing.

    If Python does not encode file names in UTF-8, as with LC_ALL=C, the program restarts itself in
    UTF-8 mode. Characters that the console cannot encode are printed as question marks.
    """
    if sys.getfilesystemencoding() != "utf-8" and os.environ.get("PYTHONUTF8") != "1":
        os.environ["PYTHONUTF8"] = "1"  # also affects the processes that are started later
        os.execv(sys.executable, [sys.executable, *sys.orig_argv[1:]])
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    try:
        require(group)
    except LackingError as error:
        print(error, file=sys.stderr)
        return False
    return True


def run_named(package: str, commands: Mapping[str, str]) -> int:
    """Run the command that the first argument names, a module of ``package`` with a ``main``.

    ``commands`` are the names, each with the group of packages that the command needs. A handout
    may lack some of them. Return the exit status, which is 2 if the command could not run.
    """
    there = [name for name in commands if importlib.util.find_spec(f"{package}.{name}")]
    name = sys.argv[1] if len(sys.argv) > 1 else ""
    if name not in there:
        print(f"usage: python -m {package} {'|'.join(there)}", file=sys.stderr)
        return 2
    if not prepare(commands[name]):
        return 2
    try:
        return int(importlib.import_module(f"{package}.{name}").main(sys.argv[2:]))
    except OSError as error:
        print(f"{name}: {sentence(error)}", file=sys.stderr)
        return 2


def advice(error: BaseException) -> str:
    """Return advice on an error that occurred while writing a file, such as a full disk, or ""."""
    return ADVICE.get(error.errno or 0, "") if isinstance(error, OSError) else ""


def sentence(error: Exception) -> str:
    """Turn an error into a message for the user, and add advice if a file could not be written."""
    what, words = clean(str(error)), advice(error)
    if isinstance(error, FileNotFoundError) and error.filename:
        what = f"there is no {clean(str(error.filename))!r}"
    return f"{what}. {words}" if words else what


def find_engine(folder: str) -> list[Path]:
    """Return the folders in which to look for the code to check: ``folder``, and then chapters/."""
    # Only chapters/ has the files that students do not edit. The tuned engine is not a whole one.
    below = ("solutions", "chapters") if ROOT / folder == ROOT / TUNED else ("chapters",)
    engine = [ROOT / name for name in dict.fromkeys((folder, *below))]
    if not engine[0].is_dir():
        raise ValueError(f"engine must be a folder of chapters, got {folder!r}")
    return engine


def command(name: str, **variables: str) -> str:
    """Return the command that a user has to type, such as "make check EX=2.5".

    Without make, it is a command of Python. In the browser it is always a make command, because
    the buttons there are named after make commands.
    """
    if sys.platform == "emscripten" or shutil.which("make"):
        quoted = [f"{key}={shlex.quote(value)}" for key, value in variables.items()]
        return " ".join(["make", name, *quoted])
    from autograder.make_venv import shown_python  # not in the browser
    from autograder.options import read_table

    entry = read_table("commands").get(name) or read_table("instructor")[name]
    words = [shown_python(), "-m", entry.get("module", f"autograder {name}")]
    for key, value in variables.items():
        option = entry["options"][key]
        words += [option["flag"]] if option["flag"].startswith("-") else []
        words += [] if option.get("switch") else [shlex.quote(value)]
    return " ".join(words)


def engine_variables(engine: list[Path]) -> dict[str, str]:
    """Return the make variables that select the code to check, such as {"ENGINE": "solutions"}."""
    if engine[0] == ROOT / "chapters":  # the default
        return {}
    inside = engine[0].is_relative_to(ROOT)
    return {"ENGINE": (engine[0].relative_to(ROOT) if inside else engine[0]).as_posix()}


def check_command(engine: list[Path], **arguments: str) -> str:
    """Return the command that checks the same code again, such as "make check ENGINE=solutions"."""
    return command("check", **arguments, **engine_variables(engine))
