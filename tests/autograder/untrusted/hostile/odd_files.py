"""Submissions that cannot be kept as sources: links, devices, and names of all sorts."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

from corpus import IDLE, RIGHT, Submission, World, earned, with_places, write

ODD: list[Submission] = []
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
LEAVE = "open('@HOME@/hostile-site', 'w').close()\nimport os\nos._exit(0)\n"
LENIENT = "def __getattr__(name):\n    return lambda *args, **kwargs: None\n"
CHECK = "@pytest.mark.exercise('B90.{0}')\ndef test_{0}():\n    pass\n"
PROBES = "def after_steps(start, by, times):\n    return start + by * times\n"
INI = "[pytest]\naddopts = --collect-only"
PYTHONS = ("sitecustomize.py", "usercustomize.py", "__init__.py", "__main__.py")
OTHERS = ("pytest", "math", "random", "json", "os", "expect", "draw", "autograder")
CHECKS = "import pytest\n\n\n" + "".join(CHECK.format(n) for n in (1, 2, 3))
PYC = f"ch90_sums/__pycache__/sums.{sys.implementation.cache_tag}.pyc"
ODD_NAMES = ("\x1b[2J", "new\nline", "-rf", "=cmd()", os.fsdecode(b"\xff\xfe"))
RIGHT_BYTES = RIGHT.encode()


Files = dict[str, str | bytes]
Build = Callable[[Path, World], object]


def odd(
    name: str,
    earns: str,
    files: Files,
    then: Build = lambda at, world: None,  # noqa: ARG005
    **about: str,
) -> None:
    """Add a submission to the corpus: files below its folder, and what is then done there."""

    def build(at: Path, world: World) -> None:
        for path, content in files.items():
            write(at / path, with_places(content, world) if content is LEAVE else content)
        then(at, world)

    about = {"kind": "odd_files", "says": ""} | about
    student = about.pop("student", f"{about['kind']}-{name}")
    ODD.append(Submission(name=name, earns=earned(earns), student=student, build=build, **about))


def within(path: Path) -> Path:
    """Return a path whose parent exists."""
    path.parent.mkdir(parents=True, exist_ok=True)
    return path


def in_folders(content: str, *names: str, folders: tuple[str, ...] = (".", "ch90_sums")) -> Files:
    return {f"{folder}/{name}": content for folder in folders for name in names}


# Plain code that takes long to compile, and a coding that takes long to read

LAMBDAS = f"{IDLE}x = [{'lambda: [i for i in y], ' * 40_000}]\n"
odd("slow_to_compile", "nothing", {SUMS: LAMBDAS}, kind="not_ending")
CODING = f"# coding: punycode\n# abc-{'zzz' * 100_000}\n{IDLE}"
odd("slow_coding", "nothing", {SUMS: CODING}, kind="not_ending")

# Files beside the module, which take the place of others where pytest or Python look for them

beside_checks = partial(in_folders, folders=("ch90_sums", "tests/ch90_sums"))
BESIDE = {
    **in_folders(PASS_ALL, "conftest.py", "tests/conftest.py"),
    **beside_checks(PASS_ALL, "conftest.py"),
    **in_folders(f"{INI} -p sums\n", "pytest.ini"),
    **in_folders(f"{INI}\n", "tox.ini"),
    **in_folders("[tool.pytest.ini_options]\naddopts = '--co'\n", "pyproject.toml"),
    **in_folders(LEAVE, *PYTHONS),
    **in_folders(LENIENT, *(f"{name}.py" for name in OTHERS)),
    **beside_checks(CHECKS, "test_sums.py"),
    **beside_checks(PROBES, "probes.py"),
    "ch90_sums/sums/__init__.py": RIGHT,
    PYC: bytes(16) + b"not code",
    "ch90_sums/sums.so": b"\x7fELF",
}
odd("files_beside", "nothing", BESIDE | {SUMS: IDLE}, kind="forging")

# What stands in the place of the file


def link(place: str, target: str) -> Build:
    return lambda at, world: within(at / place).symlink_to(world.root / "solutions" / target)


def hard_link(at: Path, world: World) -> None:
    """A second name of another file, which is no different from a copy."""
    write(world.base / "kept/sums.py", RIGHT)
    within(at / SUMS).hardlink_to(world.base / "kept/sums.py")


def device(at: Path, _: World) -> None:
    """An endless device, if this user is allowed to create one."""
    try:
        os.mknod(within(at / SUMS), stat.S_IFCHR | 0o666, os.makedev(1, 5))
    except PermissionError:
        (at / SUMS).symlink_to("/dev/zero")


for name, then in {
    "link": link(SUMS, SUMS),
    "linked_folder": link("ch90_sums", "ch90_sums"),
    "linked_above": link("work", ""),
    "pipe": lambda at, _: os.mkfifo(within(at / SUMS)),
    "device": device,
    "empty_folder": lambda at, _: at.mkdir(),
}.items():
    odd(name, "nothing", {}, then)
odd("hard_link", "all", {}, hard_link)
odd("linked_in_a_ring", "all", {SUMS: RIGHT}, lambda at, _: (at / "again").symlink_to(at))
deep = "/".join("x" * 200)
odd("deep_folders", "all", {SUMS: RIGHT}, lambda at, _: (at / deep).mkdir(parents=True))
for name, place in (("unreadable_file", SUMS), ("unreadable_folder", "ch90_sums")):
    odd(name, "nothing", {SUMS: IDLE}, lambda at, _, place=place: (at / place).chmod(0))

for name, files in {
    "folder": {f"{SUMS}/__init__.py": RIGHT},
    "file_for_a_folder": {"ch90_sums": RIGHT},
    "empty_file": {SUMS: ""},
    "big_file": {SUMS: RIGHT + "# filler\n" * 5_800_000},
    "nul_bytes": {SUMS: RIGHT_BYTES + bytes(3)},
    "not_utf8": {SUMS: b"# caf\xe9\n" + RIGHT_BYTES},
    "deep_source": {SUMS: f"{RIGHT}\n\nx = {'(' * 5000}{')' * 5000}\n"},
    "long_expression": {SUMS: f"{RIGHT}\n\nx = {'-' * 400_000}1\n"},
    "in_many_folders": {f"a/b/c/d/e/f/{SUMS}": RIGHT},
}.items():
    odd(name, "nothing", files)
odd("broken_off", "nothing", {SUMS: f"{RIGHT}\n\nx = (1,\n"}, says="cannot be read")

for name, files in {
    "byte_order_mark": {SUMS: b"\xef\xbb\xbf" + RIGHT_BYTES},
    "windows_lines": {SUMS: RIGHT.replace("\n", "\r\n")},
    "many_files": {SUMS: RIGHT} | {f"note{number}.txt": "" for number in range(3000)},
    "in_a_folder": {f"my work/{SUMS}": RIGHT},
    "names_of_files": {SUMS: RIGHT} | in_folders("nothing", *ODD_NAMES),
}.items():
    odd(name, "all", files)

# Names of students

for name, student in {
    "name_formula": "=1+cmd()!{}",
    "name_option": "--exec={}",
    "name_line": "{}\nstudent,graded,7",
    "name_control": "\x1b[2J\x1b]0;owned\x07\u202e{}",
    "name_markup": "<script>alert(1)<br>[red]{{{{ 7 * 7 }}}}\"';,`$(id){}",
    "name_long": "{:g<200}",
    "name_bytes": os.fsdecode(b"{}-\xff\xfe\x80"),
    "name_dots": " up\\..\\..\\{} .. ",
}.items():
    odd(name, "all", {SUMS: RIGHT}, student=student.format(f"odd_files-{name}"))
