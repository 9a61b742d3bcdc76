"""Submissions that cannot be kept as sources: links, devices, and names of all sorts."""

from __future__ import annotations

import os
import stat
import sys
import zipfile
from collections.abc import Callable, Mapping
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

# What stands in the place of the file (tests/autograder/submissions has more, without grading it)


def link(place: str) -> Build:
    return lambda at, world: within(at / place).symlink_to(world.root / "solutions" / place)


def device(at: Path, _: World) -> None:
    """An endless device, if this user is allowed to create one."""
    try:
        os.mknod(within(at / SUMS), stat.S_IFCHR | 0o666, os.makedev(1, 5))
    except PermissionError:
        (at / SUMS).symlink_to("/dev/zero")


for name, then in {
    "link": link(SUMS),
    "linked_folder": link("ch90_sums"),
    "pipe": lambda at, _: os.mkfifo(within(at / SUMS)),
    "device": device,
}.items():
    odd(name, "nothing", {}, then)
deep = "/".join("x" * 200)
odd("deep_folders", "all", {SUMS: RIGHT}, lambda at, _: (at / deep).mkdir(parents=True))

for name, text in {
    "deep_source": f"{RIGHT}\n\nx = {'(' * 5000}{')' * 5000}\n",
    "long_expression": f"{RIGHT}\n\nx = {'-' * 400_000}1\n",
}.items():
    odd(name, "nothing", {SUMS: text})
odd("broken_off", "nothing", {SUMS: f"{RIGHT}\n\nx = (1,\n"}, says="cannot be read")
odd("windows", "all", {SUMS: b"\xef\xbb\xbf" + RIGHT.replace("\n", "\r\n").encode()})
odd("names_of_files", "all", {SUMS: RIGHT} | in_folders("nothing", *ODD_NAMES))

# Zips (tests/autograder/submissions/test_stage_zips.py has more)

CLIMBING = ["../" * depth + "hostile-climbed" for depth in range(1, 6)]
CLIMBING += [f"../../root/solutions/{SUMS}", "..\\..\\hostile-climbed"]


def write_zip(at: Path, entries: Mapping[str | zipfile.ZipInfo, str | bytes]) -> None:
    with zipfile.ZipFile(at.with_name(at.name + ".zip"), "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in entries.items():
            file.writestr(name, content)


def zip_climbs(at: Path, world: World) -> None:
    paths = world.home / "hostile-climbed", world.root / "tests/shared/expect.py", world.root / SUMS
    write_zip(at, dict.fromkeys([*CLIMBING, *map(str, paths)], "climbed") | {SUMS: IDLE})


def zip_linked(place: str, more: Files) -> Build:
    """A zip with a link to the solution, and perhaps a file below the link."""
    entry = zipfile.ZipInfo(place)
    entry.create_system, entry.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    return lambda at, world: write_zip(at, {entry: f"{world.root}/solutions/{place}", **more})


odd("zip_right", "all", {}, lambda at, _: write_zip(at, {f"work/{SUMS}": RIGHT}))
odd("zip_bomb", "nothing", {}, lambda at, _: write_zip(at, {SUMS: b"\n" * 200_000_000}))
odd("zip_climbs", "nothing", {}, zip_climbs)
odd("zip_link", "nothing", {}, zip_linked(SUMS, {}))
odd("zip_linked_folder", "nothing", {}, zip_linked("ch90_sums", {SUMS: IDLE}))

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
