"""Scenes in the page's worker: the numbers of CPython, and the words of `make lab`."""

from __future__ import annotations

import json
from contextlib import contextmanager
from typing import Any

import pytest

from copies import reference
from course_site import BELOW, built
from in_node import NodeEngines, engines_of
from lab.catalog import entries
from typed import typed

RIGHT = reference()
SPRINGS = "ch06_springs/springs.py"
SCENES = [entry.name for entry in entries() if entry.name != "charts"]
FRAMES = 30


def load(engines: NodeEngines, link: int, scene: str, **changes: Any) -> list[dict[str, Any]]:
    """Return the answers to a message that loads a scene."""
    message = {"scene": scene, "values": {}, "peer": "", "files": RIGHT, "given": []}
    return engines.scene(link, "load", **(message | changes))


@pytest.fixture(scope="module")
def on_cpython(tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, Any]]:
    """Return the frame of each scene after a while, on the reference, as make lab has it."""
    messages = []
    for name in SCENES:
        messages.append({"kind": "load", "scene": name, "values": {}, "peer": ""})
        messages.append({"kind": "run", "frames": FRAMES})
    stack = tmp_path_factory.mktemp("engine") / "stack.txt"
    text = "".join(json.dumps(message) + "\n" for message in messages)
    done = typed("lab.child", "--engine", "solutions", "--stack", stack, text=text)
    assert done.returncode == 0, done.stderr
    answers = [json.loads(line) for line in done.stdout.splitlines() if line]
    last = [answer for answer in answers if answer["kind"] == "frame"][1::2]
    return dict(zip(SCENES, last, strict=True))


def test_every_scene_has_the_numbers_of_cpython(
    engines: NodeEngines, on_cpython: dict[str, dict[str, Any]]
) -> None:
    """Sines and powers may differ in their last digit: what is charted by 1e-9 of it at most."""
    for name in SCENES:
        load(engines, 1, name)
        for _ in range(FRAMES):  # as on a page, so that no message lasts longer than it may
            (frame,) = engines.scene(1, "run", frames=1)
        wanted = on_cpython[name]
        assert frame["time"] == wanted["time"]
        assert frame["chart"] == pytest.approx(wanted["chart"], rel=1e-9, abs=1e-9), name
        assert drawn(frame) == pytest.approx(drawn(wanted), rel=1e-4, abs=1e-6), name
        assert frame["say"] == wanted["say"]


def drawn(frame: dict[str, Any]) -> list[float]:
    """Return all coordinates of a frame."""
    found: list[float] = []
    for item in frame["items"]:
        for value in item:
            values = value if isinstance(value, list) else [value]
            found += [number for number in values if type(number) in (int, float)]
    return found


def test_another_engine_that_is_not_there_is_refused(engines: NodeEngines) -> None:
    answers = load(engines, 1, "one-spring", peer="pymunk")
    assert answers == [{"kind": "stopped", "why": "pymunk is not available in the browser."}]
    assert load(engines, 1, "one-spring", peer="exact")[-1]["kind"] == "frame"


def test_a_stub_and_a_mistake_are_told_as_by_make_lab(engines: NodeEngines) -> None:
    (answer,) = load(engines, 1, "one-spring", files={})
    assert "Exercise B" in answer["why"]
    wrong = RIGHT[SPRINGS] + "1 / 0\n"
    (answer,) = load(engines, 1, "one-spring", files=RIGHT | {SPRINGS: wrong})
    line = wrong.count("\n")
    assert answer["why"] == f"ZeroDivisionError: division by zero (chapters/{SPRINGS}, line {line})"


def test_a_file_that_the_grader_rejects_is_rejected_by_a_scene_too(engines: NodeEngines) -> None:
    (answer,) = load(engines, 1, "one-spring", files=RIGHT | {SPRINGS: RIGHT[SPRINGS] + "# \0\n"})
    why = f"{SPRINGS} was rejected: it contains NUL bytes: save it as UTF-8 in your editor"
    assert answer == {"kind": "stopped", "why": why}
    assert load(engines, 1, "one-spring")[-1]["kind"] == "frame"


def test_links_have_engines_of_their_own(engines: NodeEngines) -> None:
    soft = RIGHT | {SPRINGS: RIGHT[SPRINGS].replace("self.stiffness = ", "self.stiffness = 0 * ")}
    assert soft[SPRINGS] != RIGHT[SPRINGS]
    load(engines, 1, "one-spring")
    load(engines, 2, "one-spring", files=soft)
    (right,) = engines.scene(1, "run", frames=30)
    (other,) = engines.scene(2, "run", frames=30)
    assert drawn(right) != drawn(other)
    (right_later,) = engines.scene(1, "run", frames=1)
    assert right_later["time"] > right["time"]


def test_a_scene_may_take_longer_to_load_than_to_answer(engines: NodeEngines) -> None:
    """A busy computer or a phone needs several seconds to import an engine in a browser."""
    slow = "import time\nend = time.monotonic() + 3.5\nwhile time.monotonic() < end: pass\n"
    future, rest = RIGHT[SPRINGS].split("from __future__ import annotations\n")
    files = RIGHT | {SPRINGS: f"{future}from __future__ import annotations\n{slow}{rest}"}
    assert load(engines, 1, "one-spring", files=files)[-1]["kind"] == "frame"


def test_an_endless_loop_ends_the_worker_and_other_scenes_begin_again(
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    """The engines are the test's own, because all their scenes answer once more unasked."""
    with contextmanager(engines_of)(built(tmp_path_factory) / BELOW) as engines:
        assert load(engines, 1, "spring-bridge")[-1]["kind"] == "frame"
        start = "    def update_force(self, particle: Particle, duration: float) -> None:\n"
        assert start in RIGHT[SPRINGS]
        hangs = RIGHT[SPRINGS].replace(start, f"{start}        while True: pass\n")
        load(engines, 2, "one-spring", files=RIGHT | {SPRINGS: hangs})
        (answer,) = engines.scene(2, "run", frames=6)
        lines = [n for n, line in enumerate(hangs.split("\n"), 1) if "while True: pass" in line]
        words = "did not finish within 2.5 seconds. Is there an endless loop?\nwhere     "
        places = [f"{SPRINGS}, line {line}, in update_force" for line in lines]
        assert answer["kind"] == "stopped"
        assert answer["why"] in [words + place for place in places]
        assert engines.scene(1, "run", frames=6)[-1]["kind"] == "frame"
