"""The hostile submissions: what each one tries, what it honestly earns, and how it is handed in.

Most are a table in a TOML file in the folder of their kind. The table has the name of the attack:

    tries = what the attack tries
    earns = the exercises that its code solves: some of "add counter total", or "all"; if this line
            is left out, the code solves nothing
    says = words that must appear in the messages of the checks that it loses (may be left out)
    source = the text that is handed in as sums.py (may be left out)

A source may leave out add, Counter and total_of. They are then added at the end, solved if the
exercise is earned and idle if it is not. Idle code returns the value that the source calls RIGHT,
or the result of its attack(), or None if it has neither. A source may call send, which writes to
the grader in place of the answer that it is waiting for.

A word such as @ROOT@ stands for a path that an attacker may well know. Many attacks end in a right
answer only if they succeed: the score then shows that. Submissions that are not a single source are
in odd_files.py.
"""

from __future__ import annotations

import ast
import json
import re
import shutil
import sysconfig
import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

HOSTILE = Path(__file__).parent
CHECKS = "root/tests/ch90_sums/test_sums.py"
KINDS = ("leaving", "not_ending", "taking", "reading", "writing", "network", "forging", "lying")
EXERCISES = {"add": "B90.1", "counter": "B90.2", "total": "B90.3"}
POINTS = {"B90.1": 1, "B90.2": 2, "B90.3": 4}
DEFINITIONS = {"add": "add", "Counter": "counter", "total_of": "total"}
RIGHT = """
def add(a, b):
    return a + b


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        self.count += by

    def __add__(self, other):
        return Counter(self.count + other.count)


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(i) for i in range(n))
"""
IDLE = """
def add(a, b):
    return None


class Counter:
    def __init__(self, count):
        self.count = None

    def step(self, by):
        pass

    def __add__(self, other):
        return self


def total_of(f, n):
    return None
"""
SEND = """
import json
import os
import sys


def send(line=b"", **answer):
    frame = sys._getframe()
    while "request" not in frame.f_locals:
        frame = frame.f_back
    answer["id"] = frame.f_locals["request"]["id"]
    for file in range(3, 64):
        left = line or json.dumps(answer).encode() + b"\\n"
        try:
            while left:
                left = left[os.write(file, left) :]
        except OSError:
            pass
"""
# Where each token is planted; none may reach a report on anybody but the neighbor itself.
TOKENS = {
    "the solution": "TOKEN-SOLUTION-9C41E7",
    "the checks": "TOKEN-CHECKS-5B08D2",
    "the environment": "TOKEN-ENVIRONMENT-D3F664",
    "the home folder": "TOKEN-HOME-0A99C1",
    "the name of a file": "TOKEN-NAME-E87B25",
    "the network": "TOKEN-NETWORK-46FD18",
    "another submission": "TOKEN-NEIGHBOR-71AD30",
}
NEIGHBOR = "controls-plain"


@dataclass
class World:
    """The places of a run. All of them lie in one folder, which everybody may read."""

    base: Path
    tcp: int = 0
    udp: int = 0
    run: str = ""

    def __post_init__(self) -> None:
        self.root = self.base / "root"
        self.home = self.base / "home"
        self.submissions = self.base / "class"
        self.out = self.base / "out"
        self.temporary = self.base / "temporary"


@dataclass(frozen=True)
class Submission:
    """A hostile submission and its worth. ``label`` is part of the student's name, or all of it."""

    kind: str
    name: str
    earns: frozenset[str]
    says: str
    student: str
    build: Callable[[Path, World], None]

    @property
    def label(self) -> str:
        return f"{self.kind}-{self.name}"

    @property
    def score(self) -> int:
        return sum(POINTS[exercise] for exercise in self.earns)


def earned(words: str) -> frozenset[str]:
    """Return the ids of the exercises that a line such as "add counter" names."""
    names = {"all": list(EXERCISES), "nothing": []}.get(words, words.split())
    return frozenset(EXERCISES[name] for name in names)


def all_submissions() -> list[Submission]:
    """Return the whole corpus, honest controls first."""
    from odd_files import ODD

    return [
        _attack(path, name, **words)
        for kind in ("controls", *KINDS)
        for path in sorted((HOSTILE / kind).glob("*.toml"))
        for name, words in tomllib.loads(path.read_text(encoding="utf-8")).items()
    ] + ODD


def _attack(
    path: Path, name: str, *, tries: str, earns: str = "nothing", says: str = "", source: str = ""
) -> Submission:
    assert tries
    kind, solved = path.parent.name, earned(earns)

    def build(at: Path, world: World) -> None:
        text = with_places(completed(f"\n{source}", solved), world)
        write(at / "ch90_sums/sums.py", text)

    return Submission(kind, name, solved, says, f"{kind}-{name}", build)


def completed(source: str, earns: frozenset[str]) -> str:
    defined = {getattr(node, "name", "") for node in ast.parse(source).body}
    missing = DEFINITIONS.keys() - defined
    solved = {name for name in missing if EXERCISES[DEFINITIONS[name]] in earns}
    answers = {"\nRIGHT = ": "RIGHT", "\ndef attack():": "attack()"}
    answer = next((answers[words] for words in answers if words in source), "None")
    idle = IDLE.replace("None", answer)
    helper = SEND if " send(" in source else ""
    return helper + source + _only(RIGHT, solved) + _only(idle, missing - solved)


def _only(source: str, names: set[str]) -> str:
    found = (node for node in ast.parse(source).body if getattr(node, "name", "") in names)
    return "".join(f"\n\n{ast.unparse(node)}\n" for node in found)


def with_places(text: str, world: World) -> str:
    places = {
        "ROOT": world.root,
        "HOME": world.home,
        "CLASS": world.submissions,
        "OUT": world.out,
        "SITE": sysconfig.get_path("purelib"),
        "TCP": world.tcp,
        "UDP": world.udp,
        "RUN": world.run,
        "LINE": _line(world.root / "solutions/ch90_sums/sums.py"),
        "CHECKLINE": _line(world.base / CHECKS),
        "VERDICTS": _verdicts(),
    }
    for name, place in places.items():
        text = text.replace(f"@{name}@", str(place))
    return text


def _verdicts() -> str:
    """Return the events of a run that passes, escaped for a literal in double quotes."""
    names = re.findall(r"def (test_\w+)", (HOSTILE / CHECKS).read_text(encoding="utf-8"))
    named = zip(names, POINTS, strict=True)
    listed = [{"name": name, "exercise": exercise, "weight": 1} for name, exercise in named]
    events: list[dict[str, Any]] = [{"event": "checks", "checks": listed}]
    for name in names:
        events.append({"event": "start", "name": name})
        events.append({"event": "verdict", "name": name, "status": "passed", "message": ""})
    text = "".join(json.dumps(event) + "\n" for event in [*events, {"event": "end"}])
    return json.dumps(text)[1:-1]


def _line(path: Path) -> int:
    """Return the number of the first line with a token."""
    lines = enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
    return next(number for number, line in lines if "TOKEN-" in line)


def write(path: Path, content: str | bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content.encode() if isinstance(content, str) else content)


def build_world(world: World, submissions: list[Submission], tests: Path) -> None:
    """Make a root with one chapter, a home with secrets, and the folder of the class."""
    shutil.copytree(HOSTILE / "root", world.root, ignore=shutil.ignore_patterns("__pycache__"))
    (world.root / "tests/shared").mkdir()
    for name in ("conftest.py", "shared/compared.py", "shared/draw.py", "shared/expect.py"):
        shutil.copyfile(tests / name, world.root / "tests" / name)
    shutil.copyfile(tests.parent / "pyproject.toml", world.root / "pyproject.toml")
    write(world.home / "secret.txt", TOKENS["the home folder"] + "\n")
    write(world.home / f"{TOKENS['the name of a file']}.txt", "nothing\n")
    world.temporary.mkdir()
    world.submissions.mkdir()
    for submission in submissions:
        submission.build(world.submissions / submission.student, world)


def read_results(out: Path) -> list[dict[str, Any]]:
    files = sorted((out / "results").glob("*.json"))
    return [json.loads(path.read_text(encoding="utf-8")) for path in files]


def result_of(submission: Submission, results: list[dict[str, Any]]) -> dict[str, Any] | None:
    """Return a submission's result, found by the student's name, or by what is left of it."""
    names = {result["student"]: result for result in results}
    near = [names[name] for name in names if submission.label in name]
    if submission.student != submission.label and submission.student not in names:
        return near[0] if near else None
    return names.get(submission.student)


def leaks(out: Path) -> list[tuple[str, str]]:
    """Return the files below a folder that hold a token of somebody else's, and whose it is."""
    found = []
    for path in sorted(path for path in out.rglob("*") if path.is_file()):
        data = path.read_bytes().lower() + str(path.relative_to(out)).encode().lower()
        for place, token in TOKENS.items():
            own = place == "another submission" and NEIGHBOR in path.name
            if not own and token.encode().lower() in data:
                found.append((str(path.relative_to(out)), place))
    return found
