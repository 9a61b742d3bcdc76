"""What the command lines share: what they need, and how a student is told to run them."""

from __future__ import annotations

import importlib.util
import io
import shutil
import sys
from pathlib import Path

from autograder.make_venv import shown_python
from autograder.manifest import ROOT

# What make calls a student's options. A scene, and the exercise of a hint or a reset, have no name.
OPTIONS = {
    "CH": "--chapter",
    "EX": "--exercise",
    "GIVEN": "--given",
    "ENGINE": "--engine",
    "N": "--count",
    "WHOLE": "--whole",
}
MODULES = {"plot": "studies plot", "demo": "lab play", "lab": "lab serve"}  # not the autograder's


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
    """Return the line that runs a command: make's, or Python's own where there is no make.

    In a browser there are no commands. The page has buttons with the names of make's.
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
    """Return what names an engine in a command: nothing where it is the student's own."""
    if engine[0] == ROOT / "chapters":
        return {}
    inside = engine[0].is_relative_to(ROOT)
    return {"ENGINE": (engine[0].relative_to(ROOT) if inside else engine[0]).as_posix()}


def check_command(engine: list[Path], **arguments: str) -> str:
    """Return the command that checks this engine again."""
    return command("check", **arguments, **engine_variables(engine))
