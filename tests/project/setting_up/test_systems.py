"""Students' commands work alike on Linux, macOS and Windows, with and without make."""

from __future__ import annotations

import ast
import codecs
import os
import re
import shlex
import subprocess
import sys
import sysconfig
from collections.abc import Iterator
from pathlib import Path

import pytest

from autograder import make_venv
from autograder.checks.runner import Limits, run_checks
from autograder.handouts.handout import make_handout, student_tools
from autograder.manifest import ROOT, load_chapters
from copies import copy_tree
from graded import points_of
from small import RIGHT, make_root

# Modules that, according to Python's documentation, exist only on POSIX.
POSIX_ONLY = {"curses", "fcntl", "grp", "posix", "pty", "pwd", "readline", "resource"}
POSIX_ONLY |= {"syslog", "termios", "tty"}
STUDENTS_COMMANDS = {"check", "watch", "debug", "python", "hint", "reset", "plot", "lab"}


def run(*command: str, cwd: Path = ROOT, **variables: str) -> subprocess.CompletedProcess[str]:
    environment = os.environ | variables
    return subprocess.run(
        command, cwd=cwd, env=environment, capture_output=True, encoding="utf-8", check=False
    )


def imported_at_once(body: list[ast.stmt]) -> Iterator[str]:
    """Yield the modules imported at the top level, not in functions or behind a guard."""
    for node in body:
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module.split(".")[0]
        elif isinstance(node, ast.ClassDef | ast.With):
            yield from imported_at_once(node.body)


def test_a_hand_out_imports_what_every_system_has(tmp_path: Path) -> None:
    make_handout(load_chapters(), [], tmp_path / "out")
    files = [*(tmp_path / "out").rglob("*.py")]
    assert len(files) > 100
    for file in files:
        tree = ast.parse(file.read_text(encoding="utf-8"))
        assert POSIX_ONLY.isdisjoint(imported_at_once(tree.body)), file


@pytest.mark.slow
def test_the_students_tools_call_nothing_that_windows_lacks(tmp_path: Path) -> None:
    """The type checker knows Python's library on Windows: os.killpg, say, needs a guard."""
    modules = [
        ".".join(file.relative_to(ROOT).with_suffix("").parts)
        for file in student_tools()
        if file.suffix == ".py" and file.name != "__init__.py"
    ]
    options = ("--platform", "win32", "--follow-imports", "silent", "--cache-dir", str(tmp_path))
    named = [word for module in modules for word in ("-p", module)]
    done = run(sys.executable, "-m", "mypy", *options, *named)
    assert done.stdout == f"Success: no issues found in {len(modules)} source files\n"


def test_every_text_file_says_its_encoding() -> None:
    """The default is not UTF-8 on Windows. Hostile submissions run only on Linux."""
    for folder in ("autograder", "plots", "scenes", "studies", "chapters", "solutions", "tests"):
        for file in (ROOT / folder).rglob("*.py"):
            if "hostile" in file.relative_to(ROOT).parent.parent.parts:
                continue
            for call in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
                if isinstance(call, ast.Call) and _opens_a_text(call):
                    named = {keyword.arg for keyword in call.keywords}
                    assert "encoding" in named, f"{file}:{call.lineno}"


def _opens_a_text(call: ast.Call) -> bool:
    """Return whether a call reads or writes text. The first argument of Path.open is a mode."""
    function = call.func
    if isinstance(function, ast.Attribute) and function.attr in ("read_text", "write_text"):
        return True
    if isinstance(function, ast.Attribute) and function.attr == "open":
        mode = call.args[0] if call.args else ast.Constant("r")
    elif isinstance(function, ast.Name) and function.id == "open":
        mode = call.args[1] if len(call.args) > 1 else ast.Constant("r")
    else:
        return False
    return isinstance(mode, ast.Constant) and "b" not in str(mode.value)


def test_the_python_of_an_environment_is_where_this_system_puts_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(make_venv, "VENV", tmp_path / ".venv")
    assert run(sys.executable, "-m", "venv", "--without-pip", make_venv.VENV).returncode == 0
    monkeypatch.chdir(tmp_path)
    done = run(make_venv.shown_python(), "-c", "import sys; print(sys.prefix)", cwd=tmp_path)
    assert Path(done.stdout.strip()).samefile(tmp_path / ".venv")


@pytest.mark.parametrize(("system", "scheme"), [("Windows_NT", "nt_venv"), ("", "posix_venv")])
def test_make_takes_the_python_of_the_environment(system: str, scheme: str) -> None:
    folder = sysconfig.get_path("scripts", scheme, {"base": ".venv"}).replace("\\", "/")
    assert would_run("check", system).startswith(f"{folder}/python -m autograder check ")


def would_run(arguments: str, system: str = "") -> str:
    """Return the last command that make would run, without its handling of the exit status."""
    make = ("make", "--no-print-directory", "--dry-run")
    done = run(*make, *arguments.split(), OS=system)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()[-1].partition(" ; ")[0]


def test_the_commands_without_make_are_those_that_make_runs() -> None:
    page = (ROOT / "chapters/README.md").read_text(encoding="utf-8")
    rows = re.findall(r"(?m)^\| `make (.+?)` \| `(.+?)` \|$", page)
    assert {make.split()[0] for make, _ in rows} == STUDENTS_COMMANDS
    for make, python in rows:
        words = shlex.split(would_run(make))
        at = words.index("--engine") if "--engine" in words else len(words)
        assert words[at + 1 : at + 2] in ([], ["chapters"]), "the default of the Python command"
        assert sorted(words[:at] + words[at + 2 :]) == sorted(python.split())


def test_where_there_is_no_make_the_screen_names_commands_that_run(tmp_path: Path) -> None:
    no_make = {"PATH": str(tmp_path)}
    done = run(sys.executable, "-m", "autograder", "check", "--exercise", "B2.5", **no_make)
    for pattern in (r"(?m)^For a hint: (\S+) (.+)$", r"For the next one: (\S+) (.+)$"):
        nudge = re.search(pattern, done.stdout)
        assert nudge, done.stdout
        assert nudge[1] == make_venv.shown_python()
        done = run(sys.executable, *nudge[2].split(), **no_make)
        assert done.returncode == 0, done.stderr
    engine = ("--engine", "sample_class/hana", "--chapter", "3")
    done = run(sys.executable, "-m", "autograder", "check", *engine, **no_make)
    onward = re.search(r"(?m)^Or continue: +\S+ (.+)$", done.stdout)
    assert onward, done.stdout
    done = run(sys.executable, *onward[1].split(), **no_make)
    assert done.returncode in (0, 1), done.stderr
    assert "Chapter 3" in done.stdout


@pytest.mark.parametrize(
    "command", ["autograder check", "plots draw --chapter 2", "lab record fireworks"]
)
def test_a_command_without_the_packages_says_what_to_do(command: str) -> None:
    done = run(sys.executable, "-S", "-m", *command.split())  # no installed packages
    assert done.returncode == 2
    needed = "this Python lacks the companion's packages. Run make setup (without make: "
    assert needed in done.stderr
    assert "Traceback" not in done.stderr


# A stack dump escapes letters that are not ASCII, but not backslashes.
@pytest.mark.parametrize(
    "name", [r"C:\xfaces\u00e9t\games", "Spiele für \u5b66\u751f", "drive/engine"]
)
def test_an_endless_loop_is_placed_whatever_the_folder_is_called(name: str, tmp_path: Path) -> None:
    """The drive is a link to another folder, as /tmp on macOS, or a mapped drive on Windows."""
    (tmp_path / "disk").mkdir()
    (tmp_path / "drive").symlink_to(tmp_path / "disk", target_is_directory=True)
    root, folder = make_root(tmp_path / "root"), tmp_path / name / "ch90_small"
    folder.mkdir(parents=True)
    endless = RIGHT.replace("return 4 * x", "while True: pass")
    (folder / "small.py").write_text(endless, encoding="utf-8")
    (chapter,) = load_chapters(root)
    verdicts = run_checks(chapter, [folder.parent], seed="1", root=root, limits=Limits(2.0))
    assert "where     ch90_small/small.py, line 7, in quadruple" in str(verdicts[-2].message)


def test_files_as_editors_on_windows_save_them_are_taken(tmp_path: Path) -> None:
    """They have two characters at the end of each line, and a byte order mark at the start."""
    chapter, out = load_chapters()[0], tmp_path / "out"
    make_handout([chapter], [], out)
    folder = out / "chapters" / chapter.name
    copy_tree(ROOT / "sample_class/ada" / chapter.name, folder)
    for file in [*folder.glob("*.py"), folder / "answers.md"]:
        text = file.read_bytes().removeprefix(codecs.BOM_UTF8).replace(b"\r\n", b"\n")
        file.write_bytes(codecs.BOM_UTF8 + text.replace(b"\n", b"\r\n"))
    command = (sys.executable, "-P", "-m", "autograder", "check", "--chapter", "2")
    done = run(*command, cwd=out, PYTHONPATH=".")
    assert done.returncode == 0, done.stdout
    assert f"] {points_of(chapter)} of {points_of(chapter)} points" in done.stdout
    with (folder / "vector.py").open("a", encoding="utf-8", newline="\r\n") as file:
        file.write("\nVector3.invert = lambda self: None\n")
    done = run(*command, cwd=out, PYTHONPATH=".")
    place = re.search(r"Next: open .+vector\.py:(\d+)", done.stdout)
    assert place, done.stdout
    lines = (folder / "vector.py").read_text(encoding="utf-8-sig").splitlines()
    assert "def invert(self)" in lines[int(place[1]) - 1]
