"""Commands that are killed at random moments lose nothing, and the same command completes them.

KILLS=40 in the environment kills each so often, and KILL_SEED=2 changes the moments.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from http.client import HTTPException
from pathlib import Path
from random import Random
from typing import Any
from urllib.parse import urlsplit
from urllib.request import Request, urlopen

import pytest
from tornado.httpclient import HTTPClientError
from tornado.iostream import StreamClosedError
from tornado.websocket import WebSocketClosedError, websocket_connect

from autograder.manifest import ROOT
from killed import MARK, Victim, half_written, survivors
from small import RIGHT, hand_in, make_root
from small_class import HALF, results
from staging import make_zip

KILLS = int(os.environ.get("KILLS", "1"))
SEED = int(os.environ.get("KILL_SEED", "1"))
GONE = (OSError, HTTPException, HTTPClientError, StreamClosedError, WebSocketClosedError)
RESUMED = 0.3  # of the kills are followed by a whole run
GRADE = """
import sys
from pathlib import Path
from autograder.course.model import Work
from autograder.grader import cohort
from autograder.manifest import load_chapters
folder, out, root = map(Path, sys.argv[1:])
options = cohort.ClassOptions(root=root, jobs=2, unsafe=True)
sys.exit(cohort.grade(folder, out, Work("", load_chapters(root), seed="1"), options))
"""
UNPACK = """
import sys
from pathlib import Path
from autograder.submissions.unpack import class_folder
class_folder(Path(sys.argv[1]))
"""
PLACE = """
import shutil, sys
from pathlib import Path
from web.__main__ import put_in_place
built, out = map(Path, sys.argv[1:])
shutil.rmtree(built, ignore_errors=True)
shutil.copytree("lab/page", built)
put_in_place(built, out)
"""


def killed_again_and_again(
    victim: Victim,
    same: Callable[[Path], dict[str, str]],
    check: Callable[[bool], None],
    least: int = 1,
) -> None:
    """Kill a command and start it again, until it was killed often enough.

    ``same`` returns what every whole run must give, and ``check`` gets whether the folder was new.
    """
    victim.run_whole()
    expected, starts = same(victim.folder), 0
    assert expected
    shutil.rmtree(victim.folder)
    while victim.kills < max(KILLS, least):
        starts += 1
        is_new = not victim.folder.exists()
        is_killed = victim.kill_once()
        check(is_new)
        if is_killed and victim.rng.random() >= RESUMED:
            continue
        if is_killed:
            victim.run_whole()
            check(False)
        assert same(victim.folder) == expected
        shutil.rmtree(victim.folder)
    is_new = not victim.folder.exists()
    victim.run_whole()
    check(is_new)
    assert same(victim.folder) == expected
    many = f"{victim.kills} times in {starts} starts of {victim.steps} steps"
    print(f"{' '.join(victim.command[:3])}: killed {many}")


def texts(folder: Path, pattern: str = "*") -> dict[str, str]:
    """Return the files in a folder without the time that grading took."""
    return {
        str(path.relative_to(folder)): re.sub(
            r'"(seconds|execution_time)": [0-9.]+', "", path.read_bytes().decode(errors="replace")
        )
        for path in sorted(folder.rglob(pattern))
        if path.is_file()
    }


def test_a_killed_grading_keeps_every_report(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root, out, temporary = make_root(tmp_path / "root"), tmp_path / "out", tmp_path / "temporary"
    temporary.mkdir()
    monkeypatch.setenv("TMPDIR", str(temporary))
    for number in range(4):
        hand_in(tmp_path / "class", f"student {number}", RIGHT if number % 2 else HALF)
    script = tmp_path / "grade.py"
    script.write_text(GRADE, encoding="utf-8")
    command = [str(script), str(tmp_path / "class"), str(out), str(root)]
    landed: dict[str, object] = {}

    def check(is_new: bool) -> None:
        assert half_written(out) == []
        now = results(out)
        if not is_new:
            kept = {student: now[student] for student in landed}
            assert kept == landed, "nothing is graded twice"
        landed.clear()
        landed.update(now)

    victim = Victim(command, out, Random(SEED))
    killed_again_and_again(victim, texts, check, least=3)
    assert [*out.glob(".temporary"), *out.rglob("*.tmp"), *temporary.iterdir()] == []


def test_a_class_whose_unpacking_is_killed_is_unpacked_again(tmp_path: Path) -> None:
    work = {f"student {n}/ch02_vectors/vector.py": f"x = {n}\n".encode() for n in range(8)}
    zipped = make_zip(tmp_path, work).rename(tmp_path / "lab1.zip")
    script = tmp_path / "unpack.py"
    script.write_text(UNPACK, encoding="utf-8")
    victim = Victim([str(script), str(zipped)], tmp_path / "lab1", Random(SEED))
    killed_again_and_again(victim, lambda folder: texts(folder, "*.py"), lambda _: None)


def test_a_site_is_whole_although_its_build_is_killed(tmp_path: Path) -> None:
    """Only the last part of the build is killed, which puts the new site in the old one's place."""
    out, built, script = tmp_path / "host/site", tmp_path / "built", tmp_path / "place.py"
    script.write_text(PLACE, encoding="utf-8")
    victim = Victim([str(script), str(built), str(out)], out.parent, Random(SEED))
    victim.run_whole()
    expected = texts(out)
    assert expected
    victim.steps = 0  # count those of a build that replaces a site
    victim.run_whole()
    while victim.kills < max(KILLS, 5):
        victim.kill_once()
        assert not out.exists() or texts(out) == expected
    victim.run_whole()
    assert texts(out) == expected
    assert [*out.parent.iterdir()] == [out]
    print(f"site: killed {victim.kills} times, {victim.steps} steps")


# The page for marking and the lab, while they are in use


@contextlib.contextmanager
def killed_after(seconds: float, *command: str) -> Iterator[str]:
    """Start a server, yield its address, and kill it after so long. Nothing of it remains."""
    mark = os.urandom(8).hex()
    process = subprocess.Popen(
        [sys.executable, "-m", *command, "--no-browser"],
        cwd=ROOT,
        env=os.environ | {MARK: mark},
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    assert process.stdout
    address = process.stdout.readline().split()[-1]
    timer = threading.Timer(seconds, process.send_signal, [signal.SIGKILL])
    timer.start()
    try:
        yield address
    finally:
        timer.join()
        process.wait()
        process.stdout.close()
    assert survivors(mark, patience=15.0) == []


def ask(address: str, path: str, sent: Any = None) -> Any:
    """Return what the server answers to a GET, or to a POST of something."""
    where = urlsplit(address)
    headers = {"Content-Type": "application/json", "Origin": f"http://{where.netloc}"}
    data = None if sent is None else json.dumps(sent).encode()
    with urlopen(Request(address + path, data, headers), timeout=10.0) as answer:
        return json.loads(answer.read())


def test_no_saved_mark_is_lost_when_the_page_is_killed(tmp_path: Path) -> None:
    for student in ("ann", "bob", "cem"):
        (tmp_path / student / "ch02_vectors").mkdir(parents=True)
        shutil.copy(ROOT / "chapters/ch02_vectors/answers.md", tmp_path / student / "ch02_vectors")
    rng = Random(SEED)
    command = ("autograder", "mark", str(tmp_path), "--chapters", "2")
    saved: dict[str, Any] = {}
    asked: tuple[str, Any] | None = None  # without an answer, so it may be saved or not
    changes = 0
    for _ in range(KILLS + 1):
        with killed_after(rng.uniform(0.1, 0.4), *command) as address, contextlib.suppress(*GONE):
            codes = [a["code"] for a in ask(address, "questions.json")["questions"][0]["answers"]]
            known = ask(address, "marks.json")["marks"]["2.2b"]
            if asked:
                assert known in (saved, {**saved, asked[0]: asked[1]})
            saved, asked = known, None
            while True:
                code = rng.choice(codes)
                points, comment = rng.choice([0.0, 0.5, 1.0]), "x" * rng.randrange(3000)
                mark = {"points": points, "comment": comment, "changed": False}
                asked = (code, mark)
                sent = {"exercise": "2.2b", "code": code, "mark": mark, "seen": saved.get(code)}
                saved = ask(address, "marks.json", sent)["marks"]["2.2b"]
                assert saved[code] == mark
                changes += 1
    assert changes
    print(f"mark: killed {KILLS + 1} times, {changes} marks were saved")


def test_nothing_remains_of_a_lab_that_is_killed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No engine outlives it. The engines remove the files that the lab has made for them."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    rng = Random(SEED)
    frames = 0

    async def play(address: str) -> None:
        nonlocal frames
        socket = await websocket_connect(f"{address.replace('http', 'ws', 1)}engine")
        message = {"kind": "load", "scene": "one-spring", "values": {}, "peer": ""}
        await socket.write_message(json.dumps(message))
        while (answer := await socket.read_message()) is not None:
            if json.loads(answer)["kind"] == "frame":
                frames += 1
                await socket.write_message('{"kind": "run", "frames": 1}')

    async def use(address: str) -> None:
        await asyncio.gather(*(play(address) for _ in range(2)))

    command = ("lab", "serve", "--engine", "solutions")
    for number in range(KILLS):
        seconds = rng.uniform(0.0, 1.0) if number else 5.0
        with killed_after(seconds, *command) as address, contextlib.suppress(*GONE):
            if number % 4 == 3:
                ask(address, "record.gif?scene=one-spring")
            else:
                asyncio.run(use(address))
        if number == 0:  # later kills may come while an engine starts, or during a recording
            assert [*tmp_path.iterdir()] == []
    assert frames
    print(f"lab: killed {KILLS} times after {frames} frames")
