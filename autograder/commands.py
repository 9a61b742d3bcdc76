"""What the command lines share: what they need, and how a student is told to run them."""

from __future__ import annotations

import importlib.util
import io
import shutil
import sys
from pathlib import Path

from autograder.make_venv import shown_python
from autograder.manifest import ROOT

# What make calls a student's options; the exercise of a hint or a reset has no name.
OPTIONS = {
    "CH": "--chapter",
    "EX": "--exercise",
    "GIVEN": "--given",
    "ENGINE": "--engine",
    "N": "--count",
    "WHOLE": "--whole",
}


def prepare() -> bool:
    """Make the screen take any text; return False, and say why, where packages are missing."""
    for stream in (sys.stdout, sys.stderr):  # a console of another encoding shows ? and goes on
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    if importlib.util.find_spec("pytest") is None:
        print(
            "this Python lacks what the companion needs: run make setup (without make: "
            f"{Path(sys.executable).name} autograder/make_venv.py, and then {shown_python()})",
            file=sys.stderr,
        )
        return False
    return True


def find_engine(folder: str) -> list[Path]:
    """Return the folders of an engine, the first on top. Raises ValueError without the folder."""
    # What students do not edit, such as plots, is in chapters/ alone.
    engine = [ROOT / name for name in dict.fromkeys((folder, "chapters"))]
    if not engine[0].is_dir():
        raise ValueError(f"engine must be a folder of chapters, got {folder!r}")
    return engine


def command(name: str, **variables: str) -> str:
    """Return the line that runs a command: make's, or Python's own where there is no make."""
    if shutil.which("make"):
        return " ".join(["make", name, *(f"{key}={value}" for key, value in variables.items())])
    words = [shown_python(), "-m autograder", name]
    for key, value in variables.items():
        if key != "EX" or name == "check":
            words.append(OPTIONS[key])
        if key != "WHOLE":
            words.append(value)
    return " ".join(words)
