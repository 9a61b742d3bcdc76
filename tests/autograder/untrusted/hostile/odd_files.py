"""Submissions that cannot be kept as sources: links, devices, and names of all sorts."""

from __future__ import annotations

import os
import socket
import stat
import sys
from collections.abc import Callable
from pathlib import Path

from corpus import IDLE, RIGHT, Submission, World, earned, with_places, write

ODD: list[Submission] = []
Build = Callable[[Path, World], None]
SUMS = "ch90_sums/sums.py"
PASS_ALL = """
import pytest


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem):
    return True


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item, call):
    call.excinfo = None
    report = yield
    report.outcome = "passed"
    return report
"""


def odd(tries: str, earns: str, *, says: str = "", kind: str = "odd_files") -> Callable[..., Build]:
    """Add a submission to the corpus, named after the function that makes it."""

    def add(build: Build) -> Build:
        name = build.__name__
        student = f"{kind}-{name}"
        ODD.append(Submission(kind, name, tries, earned(earns), says, student, build))
        return build

    return add


def named(name: str, tries: str, student: str) -> None:
    """Add a right submission of a student with this name."""

    def build(at: Path, world: World) -> None:  # noqa: ARG001
        write(at / SUMS, RIGHT)

    ODD.append(Submission("odd_files", name, tries, earned("all"), "", student, build))


# Sources that take long to be compiled, long before they run


@odd("Plain code that takes long to compile.", "nothing", kind="not_ending")
def slow_to_compile(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, IDLE + "x = [" + "lambda: [i for i in y], " * 40_000 + "]\n")


@odd("A coding of the source that takes long to read.", "nothing", kind="not_ending")
def slow_coding(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, "# coding: punycode\n" + "# abc-" + "zzz" * 100_000 + "\n" + IDLE)


# Files beside the module, which take the place of others where pytest or Python look for them


@odd("A conftest.py beside the module lets everything pass.", "nothing", kind="forging")
def conftest_beside(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, IDLE)
    for folder in (".", "ch90_sums", "tests", "tests/ch90_sums"):
        write(at / folder / "conftest.py", PASS_ALL)


@odd("Settings of pytest beside the module ask for no checks.", "nothing", kind="forging")
def settings_beside(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, IDLE)
    for folder in (".", "ch90_sums"):
        write(at / folder / "pytest.ini", "[pytest]\naddopts = --collect-only -p sums\n")
        write(at / folder / "tox.ini", "[pytest]\naddopts = --collect-only\n")
        write(at / folder / "pyproject.toml", "[tool.pytest.ini_options]\naddopts = '--co'\n")


@odd("Modules that Python runs when it starts stand beside the module.", "nothing", kind="forging")
def site_customised(at: Path, world: World) -> None:
    write(at / SUMS, IDLE)
    leave = with_places("open('@HOME@/hostile-site', 'w').close()\nimport os\nos._exit(0)\n", world)
    for folder in (".", "ch90_sums"):
        for name in ("sitecustomize.py", "usercustomize.py", "__init__.py", "__main__.py"):
            write(at / folder / name, leave)


@odd("Modules called like those of Python and the checks stand beside.", "nothing", kind="forging")
def shadows(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, IDLE)
    lenient = "def __getattr__(name):\n    return lambda *args, **kwargs: None\n"
    for name in ("pytest", "math", "random", "json", "os", "expect", "draw", "autograder"):
        write(at / f"{name}.py", lenient)
        write(at / "ch90_sums" / f"{name}.py", lenient)


@odd("Checks and probes that always pass are handed in as well.", "nothing", kind="forging")
def own_checks(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, IDLE)
    checks = "import pytest\n\n\n@pytest.mark.exercise('B90.{0}')\ndef test_{0}():\n    pass\n"
    probes = "def after_steps(start, by, times):\n    return start + by * times\n"
    for folder in ("ch90_sums", "tests/ch90_sums"):
        write(at / folder / "test_sums.py", "".join(checks.format(n) for n in (1, 2, 3)))
        write(at / folder / "probes.py", probes)


@odd("A package called sums, and a compiled module, stand beside.", "nothing", kind="forging")
def compiled_beside(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, IDLE)
    write(at / "ch90_sums/sums/__init__.py", RIGHT)
    tag = sys.implementation.cache_tag
    write(at / f"ch90_sums/__pycache__/sums.{tag}.pyc", b"\0" * 16 + b"not code")
    write(at / "ch90_sums/sums.so", b"\x7fELF")


# What stands in the place of the file


@odd("sums.py is a link to the solution.", "nothing")
def link(at: Path, world: World) -> None:
    (at / "ch90_sums").mkdir(parents=True)
    (at / SUMS).symlink_to(world.root / "solutions" / SUMS)


@odd("The chapter's folder is a link to the solution's.", "nothing")
def linked_folder(at: Path, world: World) -> None:
    at.mkdir()
    (at / "ch90_sums").symlink_to(world.root / "solutions/ch90_sums")


@odd("A folder above the chapter's is a link to the solutions.", "nothing")
def linked_above(at: Path, world: World) -> None:
    at.mkdir()
    (at / "work").symlink_to(world.root / "solutions")


@odd("A folder is a link to the one above it, so that the tree never ends.", "all")
def linked_in_a_ring(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT)
    (at / "again").symlink_to(at)


@odd("sums.py is a second name of another file: that is no different from a copy.", "all")
def hard_link(at: Path, world: World) -> None:
    write(world.base / "kept/sums.py", RIGHT)
    (at / "ch90_sums").mkdir(parents=True)
    (at / SUMS).hardlink_to(world.base / "kept/sums.py")


@odd("sums.py is a pipe that nobody writes to.", "nothing")
def pipe(at: Path, world: World) -> None:  # noqa: ARG001
    (at / "ch90_sums").mkdir(parents=True)
    os.mkfifo(at / SUMS)


@odd("sums.py is a socket.", "nothing")
def unix_socket(at: Path, world: World) -> None:
    (at / "ch90_sums").mkdir(parents=True)
    with socket.socket(socket.AF_UNIX) as server:  # its path must be short
        server.bind(str(world.base / "s"))
    (world.base / "s").rename(at / SUMS)


@odd("sums.py is a device without end, where whoever builds this may make one.", "nothing")
def device(at: Path, world: World) -> None:  # noqa: ARG001
    (at / "ch90_sums").mkdir(parents=True)
    try:
        os.mknod(at / SUMS, stat.S_IFCHR | 0o666, os.makedev(1, 5))
    except PermissionError:
        (at / SUMS).symlink_to("/dev/zero")


@odd("sums.py is a folder.", "nothing")
def folder(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS / "__init__.py", RIGHT)


@odd("The chapter's folder is a file.", "nothing")
def file_for_a_folder(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / "ch90_sums", RIGHT)


@odd("There is nothing in the folder.", "nothing")
def empty_folder(at: Path, world: World) -> None:  # noqa: ARG001
    at.mkdir()


@odd("sums.py is empty.", "nothing")
def empty_file(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, "")


@odd("sums.py has fifty megabytes.", "nothing")
def big_file(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT + "# filler\n" * 5_800_000)


@odd("sums.py has NUL bytes in it.", "nothing")
def nul_bytes(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT.encode() + b"\0\0\0")


@odd("sums.py is no UTF-8.", "nothing")
def not_utf8(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, "# caf\xe9\n".encode("latin-1") + RIGHT.encode())


@odd("sums.py is in UTF-16, as some editors save.", "nothing")
def utf16(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT.encode("utf-16"))


@odd("sums.py begins with the mark that some editors put before UTF-8.", "all")
def byte_order_mark(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, b"\xef\xbb\xbf" + RIGHT.encode())


@odd("sums.py ends its lines as on Windows.", "all")
def windows_lines(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT.replace("\n", "\r\n"))


@odd("sums.py breaks off in the middle.", "nothing", says="cannot be read")
def broken_off(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT + "\n\nx = (1,\n")


@odd("sums.py is nested so deeply that Python's parser gives up.", "nothing")
def deep_source(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT + "\n\nx = " + "(" * 5000 + ")" * 5000 + "\n")


@odd("sums.py has one line whose expression overflows the compiler's stack.", "nothing")
def long_expression(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT + "\n\nx = " + "-" * 400_000 + "1\n")


@odd("sums.py may not be read by its owner.", "nothing")
def unreadable_file(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, IDLE)  # root may read it all the same
    (at / SUMS).chmod(0)


@odd("The folder may not be opened by its owner.", "nothing")
def unreadable_folder(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, IDLE)
    (at / "ch90_sums").chmod(0)


# Trees


@odd("Thousands of files stand beside the module.", "all")
def many_files(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT)
    for number in range(3000):
        (at / f"note{number}.txt").touch()


@odd("Folders are nested two hundred deep beside the module.", "all")
def deep_folders(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT)
    (at / "/".join("x" * 200)).mkdir(parents=True)


@odd("The chapter's folder stands in a folder, as many hand it in.", "all")
def in_a_folder(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / "my work" / SUMS, RIGHT)


@odd("The chapter's folder stands far too deep to be meant.", "nothing")
def in_many_folders(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / "a/b/c/d/e/f" / SUMS, RIGHT)


@odd("Files have names that no terminal should print.", "all")
def names_of_files(at: Path, world: World) -> None:  # noqa: ARG001
    write(at / SUMS, RIGHT)
    for name in ("\x1b[2J", "new\nline", "-rf", "=cmd()", os.fsdecode(b"\xff\xfe")):
        write(at / name, "nothing")
        write(at / "ch90_sums" / name, "nothing")


# Names of students

named("name_formula", "The name is a formula.", "=1+cmd()!odd_files-name_formula")
named("name_option", "The name looks like an option.", "--exec=odd_files-name_option")
named("name_line", "The name has two lines.", "odd_files-name_line\nstudent,graded,7")
named("name_color", "The name clears the screen.", "\x1b[2J\x1b]0;owned\x07odd_files-name_color")
named("name_markup", "The name is mark-up.", "<script>alert(1)<br>[red]odd_files-name_markup")
named("name_long", "The name has two hundred letters.", "odd_files-name_long".ljust(200, "g"))
named("name_quotes", "The name has quotes and commas.", "\"';,`$(id)odd_files-name_quotes")
named("name_bytes", "The name is no text.", os.fsdecode(b"odd_files-name_bytes-\xff\xfe\x80"))
named("name_turned", "The name runs from right to left.", "\u202eodd_files-name_turned")
named("name_space", "The name ends in spaces and dots.", " odd_files-name_space .. ")
named("name_template", "The name is code for a template.", "{{ 7 * 7 }}odd_files-name_template")
named("name_dots", "The name climbs out.", "up\\..\\..\\odd_files-name_dots")
