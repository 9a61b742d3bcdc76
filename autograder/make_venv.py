"""Create the virtual environment .venv, or add a group of packages to it.

`python3 autograder/make_venv.py` installs the packages of autograder/locks/requirements.lock, which
are all that most commands of students need. `python3 autograder/make_venv.py pictures` adds those
of pictures.lock. `make` runs this script before a command that needs it.

The script uses only syntax that Python 3.6 understands, so that a Python that is too old for the
project shows a helpful message instead of a syntax error.
"""

import os
import subprocess
import sys
import sysconfig
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VENV = ROOT / ".venv"
LOCKS = ROOT / "autograder" / "locks"
STUDENTS = "requirements"  # the lock with the packages of students
EVERYTHING = "everything"  # the group that contains all others
NETWORK_WORDS = ("connection broken", "name resolution", "read timed out", "is unreachable")


def stop(sentence: str) -> None:
    """Print why the virtual environment could not be set up, and exit."""
    sys.exit(f"Cannot set up: {sentence}")


def python_of_venv() -> Path:
    """Return the path of the Python in .venv, as Python 3.11 and later lay it out here."""
    return Path(sysconfig.get_path("scripts", "venv", {"base": str(VENV)})) / "python"


def shown_python() -> str:
    """Return the path of the Python in .venv, relative to the current folder if possible."""
    try:
        return str(python_of_venv().relative_to(Path.cwd()))
    except ValueError:
        return str(python_of_venv())


def check_python() -> None:
    """Exit with a helpful message if this Python is too old or cannot create an environment."""
    version = ".".join(str(part) for part in sys.version_info[:2])
    if sys.version_info < (3, 11):  # noqa: UP036 - an old Python ends here
        newer = "py -3.14" if os.name == "nt" else "python3.14"
        stop(
            f"{sys.executable} is Python {version}, but the companion needs 3.11 or newer. "
            f"Install one and name it: make setup PYTHON=python3.14 (without make: {newer} "
            "autograder/make_venv.py)"
        )
    try:
        import ensurepip  # noqa: F401 - Debian and Ubuntu leave it out of python3
        import venv  # noqa: F401
    except ImportError:
        stop(
            f"{sys.executable} has no venv module. Install it (Debian, Ubuntu: "
            f"sudo apt install python{version}-venv) and run the command again."
        )


def install(name: str) -> None:
    """Install the packages listed in a lock, or print why pip failed, and exit."""
    lock = LOCKS / f"{name}.lock"
    failure = run_pip(lock)
    if any(word in failure.lower() for word in NETWORK_WORDS):
        stop(
            "the package index (PyPI) cannot be reached. Check the network or proxy settings "
            "and run the command again."
        )
    if failure:
        stop(f"pip could not install {lock.name}. Its output ends with:\n{failure[-1500:]}")


def run_pip(lock: Path) -> str:
    """Install the packages of a lock. Return pip's output if it fails, or an empty string."""
    pip = [str(python_of_venv()), "-m", "pip", "install", "--disable-pip-version-check"]
    return run(*pip, "--retries", "1", "--timeout", "30", "--require-hashes", "-r", str(lock))


def run(*command: str) -> str:
    """Run a program. Return its output if it fails, or an empty string."""
    done = subprocess.run(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace"
    )
    return (done.stdout or f"it ended with status {done.returncode}") if done.returncode else ""


def make_venv() -> None:
    """Create .venv from scratch. The file .venv/ready is written last, as proof."""
    check_python()
    print(
        f"Setting up .venv with {sys.executable}; this one-time step takes less than a minute.",
        flush=True,
    )
    failure = run(sys.executable, "-m", "venv", "--clear", str(VENV))
    if failure:
        stop(f"python -m venv failed: {failure.strip()}")
    install(STUDENTS)
    put_engine_on_path()
    (VENV / "ready").write_text(f"made from {STUDENTS}.lock\n", encoding="utf-8")
    print(f"Set up: .venv is ready. Without make: {shown_python()} -m autograder check")


def put_engine_on_path() -> None:
    """Make the modules in chapters/ importable from every script that .venv runs.

    The path in engine.pth, which Python reads when it starts, is relative to that file.
    """
    packages = Path(sysconfig.get_path("purelib", "venv", {"base": str(VENV)}))
    engine = os.path.relpath(str(ROOT / "chapters"), str(packages))
    (packages / "engine.pth").write_text(engine + "\n", encoding="utf-8")


def main(group: str = "") -> None:
    """Create .venv, or add the packages of ``group``, and create .venv first if it is missing."""
    groups = sorted(lock.stem for lock in LOCKS.glob("*.lock") if lock.stem != STUDENTS)
    if group and group not in groups:
        stop(f"there is no group of packages called {group!r}; choose from {', '.join(groups)}")
    if not group or not (VENV / "ready").exists():
        make_venv()
    if group:
        print(f"Installing the packages of {group}.lock into .venv, once.", flush=True)
        install(group)
        for done in groups if group == EVERYTHING else [group]:
            (VENV / done).write_text(f"made from {group}.lock\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:2])
