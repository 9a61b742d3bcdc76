"""Create the virtual environment .venv, and install the packages listed in requirements.lock.

`make` runs this script before its first command. Without make, run `python3
autograder/make_venv.py` yourself. The script uses only syntax that Python 3.6 understands. If your
Python is too old for the project, you therefore see a helpful message instead of a syntax error.
"""

import os
import subprocess
import sys
import sysconfig
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VENV = ROOT / ".venv"
LOCK = ROOT / "requirements.lock"
NETWORK_WORDS = ("connection broken", "name resolution", "read timed out", "is unreachable")


def stop(sentence: str) -> None:
    """Print why the virtual environment could not be set up, and exit.

    The next attempt starts from scratch, because the file .venv/ready has not been written.
    """
    sys.exit(f"Cannot set up: {sentence}")


def python_of_venv() -> Path:
    """Return the path of the Python interpreter in the virtual environment .venv.

    The path follows the layout that Python 3.11 and later use on this operating system.
    """
    return Path(sysconfig.get_path("scripts", "venv", {"base": str(VENV)})) / "python"


def shown_python() -> str:
    """Return the path of the Python interpreter in .venv, as shown to the user.

    The path is relative to the current folder if possible.
    """
    try:
        return str(python_of_venv().relative_to(Path.cwd()))
    except ValueError:
        return str(python_of_venv())


def check_python() -> None:
    """Exit with a helpful message if this Python is too old or cannot create an environment."""
    version = ".".join(str(part) for part in sys.version_info[:2])
    if sys.version_info < (3, 11):  # noqa: UP036 - an old Python ends here
        newer = "py -3.12" if os.name == "nt" else "python3.12"
        stop(
            f"{sys.executable} is Python {version}, but the companion needs 3.11 or newer. "
            f"Install one and name it: make setup PYTHON=python3.12 (without make: {newer} "
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


def install(python: str) -> str:
    """Install the packages listed in requirements.lock with pip, and print the progress.

    Return pip's output if the installation fails, and an empty string if it succeeds.
    """
    lock = LOCK.read_text(encoding="utf-8").splitlines()
    total = sum("==" in line and line[0].isalpha() for line in lock)
    command = [python, "-m", "pip", "install", "--disable-pip-version-check", "--retries", "1"]
    command += ["--timeout", "30", "--require-hashes", "-r", str(LOCK)]
    output, fetched = "", 0
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace"
    ) as pip:
        for line in pip.stdout or []:
            output += line
            fetched += line.startswith("Collecting ")
            if line.startswith("Collecting ") and sys.stdout.isatty():
                print(f"\r  package {fetched} of at most {total} ", end="", flush=True)
            if line.startswith("Installing "):
                print(f"\r  {fetched} packages fetched, unpacking them ...", flush=True)
    return output if pip.returncode else ""


def main() -> None:
    """Create the virtual environment .venv from scratch.

    The file .venv/ready is written last, as proof that the environment is complete.
    """
    check_python()
    print(
        f"Setting up .venv with {sys.executable}; this one-time step takes about a minute.",
        flush=True,
    )
    made = subprocess.run(
        [sys.executable, "-m", "venv", "--clear", str(VENV)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        errors="replace",
    )
    if made.returncode:
        stop(f"python -m venv failed: {made.stdout.strip()}")
    failure = install(str(python_of_venv()))
    if any(word in failure.lower() for word in NETWORK_WORDS):
        stop(
            "the package index (PyPI) cannot be reached. Check the network or proxy settings "
            "and run the command again."
        )
    if failure:
        stop(f"pip could not install requirements.lock. Its output ends with:\n{failure[-1500:]}")
    (VENV / "ready").write_text("made from requirements.lock\n", encoding="utf-8")
    print(f"Set up: .venv is ready. Without make: {shown_python()} -m autograder check")


if __name__ == "__main__":
    main()
