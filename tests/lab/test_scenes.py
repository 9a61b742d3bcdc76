"""Check every scene of the lab: drawing, descriptions, parameters, question and peers."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path
from typing import Any

import pytest

from autograder.manifest import Chapter, load_chapters
from lab.catalog import entries, load
from lab.drawing.pen import COLORS, Pen
from lab.host import Host
from lab.scene import Scene, parameters_of
from plots.draw import plots_of
from scenes.parameters import Choice, Slider

SCENES = [entry.name for entry in entries()]
# The scene of the charts replays measurements of the reference. Other plots of the same chapters
# claim the functions that these call.
CLAIM_NOTHING = {"charts", "trajectories", "integration_error", "energy_over_time"}
RESERVED = {" ", ".", "r", "?"}  # keys that the page uses itself


def told(error: BaseException) -> str:
    raise error


def frames(name: str, peer: str = "", seconds: float = 1.0, **values: object) -> list[Any]:
    """Return the frames of a scene on the reference, as the page receives them."""
    host = Host(told)
    answers = host.receive({"kind": "load", "scene": name, "values": values, "peer": peer})
    assert [answer["kind"] for answer in answers] == ["scene", "frame"]
    for _ in range(round(60 * seconds)):
        assert host.scene is not None
        host.scene.play(host.scene.time)
        answers += host.receive({"kind": "run", "frames": 1})
    return answers[1:]


def inside(view: tuple[float, float, float, float], item: list[Any]) -> bool:
    """Return whether the first point of a drawn item is in the view."""
    kind, _, *values = item
    if kind == "ground":
        return True
    flat = values[0] if isinstance(values[0], list) else values[:2]
    left, right, bottom, top = view
    return bool(flat) and left <= flat[0] <= right and bottom <= flat[1] <= top


def test_there_are_three_scenes_per_chapter_and_two_for_the_first() -> None:
    numbers = [entry.chapter for entry in entries()]
    assert {number: min(3, numbers.count(number)) for number in numbers} == {
        2: 2,
        **dict.fromkeys(range(3, 10), 3),
    }


@pytest.mark.parametrize("chapter", load_chapters(), ids=lambda chapter: chapter.name)
def test_every_scene_and_almost_every_plot_claims_what_it_shows(chapter: Chapter) -> None:
    file = Path(__file__).parent / "shown.toml"
    claims = tomllib.loads(file.read_text(encoding="utf-8"))[chapter.name]
    scenes = {entry.name for entry in entries() if entry.chapter == chapter.number}
    for kind, shown in (("scenes", scenes), ("plots", plots_of(chapter.name).keys())):
        claimed = claims.get(kind, {}).keys()
        left = shown - claimed - CLAIM_NOTHING
        assert not left, f"list the functions that these {kind} show in {file}: {left}"
        assert claimed <= shown, f"{file} lists {kind} that are not there: {claimed - shown}"


def test_every_chapter_has_a_question_to_predict() -> None:
    asking = {entry.chapter for entry in entries() if load(entry.name).predict}
    assert asking == set(range(3, 10))


@pytest.mark.parametrize("name", SCENES)
def test_a_scene_draws_charts_and_tells_what_happens(name: str) -> None:
    scene = load(name)
    first, *_, last = frames(name, seconds=scene.seconds)
    assert scene.question.endswith("?")
    assert not RESERVED & scene.keys.keys()
    for frame in (first, last):
        assert all(item[1] in COLORS for item in frame["items"])
        assert sum(inside(scene.view, item) for item in frame["items"]) >= 0.5 * len(frame["items"])
        assert all(math.isfinite(value) for value in frame["chart"].values())
        assert frame["facts"]
        assert frame["say"].endswith(".")
    assert last["time"] == pytest.approx(scene.seconds, abs=0.02)
    assert first["items"] != last["items"], "nothing moves"
    assert (last["error"] is not None) == bool(scene.exact_from) or first["error"] == 0.0


def ends(name: str) -> list[dict[str, object]]:
    """Return values for a scene: both ends of each slider, and each choice."""
    found: list[dict[str, object]] = []
    for parameter in parameters_of(load(name)).values():
        if isinstance(parameter, Slider):
            found += [{parameter.name: end} for end in (parameter.low, parameter.high)]
        elif isinstance(parameter, Choice):
            found += [{parameter.name: option} for option in parameter.options]
    return found


@pytest.mark.parametrize("name", SCENES)
def test_a_scene_takes_the_extremes_of_its_parameters(name: str) -> None:
    """If a scene explodes, it says so. As long as it runs, its question can be asked."""
    question = load(name).predict
    for values in ends(name):
        host = Host(lambda error: f"{type(error).__name__}: {error}")
        last = host.receive({"kind": "load", "scene": name, "values": values, "peer": ""})[-1]
        for frames in (0, 15):
            if frames and host.scene:
                (last,) = host.receive({"kind": "run", "frames": frames})
            if question and host.scene:
                (judged,) = host.receive({"kind": "predict", "option": 0})
                assert judged["kind"] == "judged", (values, judged)
                assert judged["answer"] in range(len(question.options))
        assert last.get("time") == pytest.approx(0.25) or "The scene exploded" in last["why"], (
            values
        )


@pytest.mark.parametrize("name", [name for name in SCENES if load(name).predict])
def test_a_question_has_one_answer_that_a_run_confirms(name: str) -> None:
    scene = load(name)
    question = scene.predict
    assert question is not None
    run: Scene = scene()
    before = question.answer(run) if name not in MEASURED else None
    for _ in range(round(60 * question.seconds)):
        run.advance()
    run.draw(Pen())
    assert question.answer(run) in range(len(question.options))
    assert before in (None, question.answer(run)), "the run contradicts the answer from theory"


# Scenes whose question is about the result of the run itself.
MEASURED = {"bounce", "stack", "bridge", "cube", "trebuchet", "orientations"}


def test_a_peer_runs_the_same_physics() -> None:
    """The pull of a wheel's spokes turns by 3 rad/s / 60 Hz per step, which is 5 % of 3 rad/s."""
    own, other = frames("wheel"), frames("wheel", "pymunk")
    assert max(frame["error"] for frame in other) <= 0.15
    for key in ("spin, rad/s", "rigid wheel, rad/s"):
        wanted = pytest.approx(own[30]["chart"][key], abs=0.25)
        assert other[30]["chart"][key] == wanted
