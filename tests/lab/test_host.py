"""The host answers every message, whatever a page sends and whatever a student's code does."""

from __future__ import annotations

import asyncio
import json
from typing import Any

import pytest

from lab.child import answered
from lab.engine_process import EngineProcess
from lab.host import MOST_FRAMES, Host
from scenes.reason import reason

Message = dict[str, Any]
RUN = b'{"kind": "run", "frames": 1}'
LARGE = 400 * b"9"


@pytest.fixture
def host() -> Host:
    host = Host(reason)
    host.receive(load())
    return host


def load(**values: object) -> Message:
    return {"kind": "load", "scene": "one-spring", "values": values, "peer": ""}


def changed(host: Host, name: str, value: object) -> Message:
    (answer,) = host.receive({"kind": "set", "name": name, "value": value})
    return answer


def test_a_scene_is_described_and_shown_at_its_start() -> None:
    """A value in `SET="integrator=explicit-euler rate=60"` has no spaces and no decimals."""
    values = {"stiffness": 50.0, "integrator": "explicit-euler", "rate": "60"}
    scene, frame = Host(reason).receive(load(**values))
    assert scene["kind"] == "scene"
    assert {"stiffness", "rate"} <= {parameter["name"] for parameter in scene["parameters"]}
    assert scene["values"] == {"stiffness": 50.0, "integrator": "explicit Euler", "rate": 60.0}
    assert frame["kind"] == "frame"
    assert (frame["time"], frame["error"]) == (0.0, 0.0)
    assert frame["chart"]["energy, J"] == pytest.approx(25.0)  # k x^2 / 2 at x = 1 m


def test_frames_pass_and_not_more_than_half_a_second(host: Host) -> None:
    (frame,) = host.receive({"kind": "run", "frames": 6})
    assert frame["time"] == pytest.approx(0.1)
    assert frame["cost"] is None  # after so few frames
    (frame,) = host.receive({"kind": "run", "frames": 10**9})
    assert frame["time"] == pytest.approx(0.1 + MOST_FRAMES / 60.0, abs=1e-5)


def test_a_parameter_that_shapes_the_scene_builds_it_anew_and_a_live_one_does_not(
    host: Host,
) -> None:
    for _ in range(3):
        (frame,) = host.receive({"kind": "run", "frames": MOST_FRAMES})
    assert frame["cost"] > 0.0
    frame = changed(host, "integrator", "explicit Euler")
    assert frame["time"] > 0.0
    assert frame["cost"] is None, "it is measured anew"
    (later,) = host.receive({"kind": "run", "frames": MOST_FRAMES})
    # Explicit Euler multiplies the energy by 1 + k h^2 / m in every step.
    grown = later["chart"]["energy, J"] / frame["chart"]["energy, J"]
    assert grown == pytest.approx((1.0 + 100.0 / 3600.0) ** MOST_FRAMES)
    frame = changed(host, "stiffness", 200.0)
    assert (frame["time"], frame["chart"]["energy, J"]) == (0.0, pytest.approx(100.0))


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("stiffness", 1e9, "stiffness must be from 1 to 20000"),
        ("stiffness", "soft", "stiffness must be a number, got 'soft'"),
        ("stiffness", float("nan"), "stiffness must be a number"),
        ("integrator", "magic", "integrator must be one of explicit Euler"),
        ("color", 1, "no parameter color"),
    ],
)
def test_a_bad_value_is_refused_and_the_scene_goes_on(
    host: Host, name: str, value: object, words: str
) -> None:
    refused = changed(host, name, value)
    assert refused["kind"] == "refused"
    assert words in refused["why"]
    assert host.receive({"kind": "run", "frames": 1})[0]["kind"] == "frame"
    answers = Host(reason).receive(load(**{name: value}))
    assert [answer["kind"] for answer in answers] == ["scene", "refused", "frame"]


def test_an_explosion_stops_the_scene_and_a_restart_begins_again(host: Host) -> None:
    changed(host, "stiffness", 20_000.0)
    answers = [host.receive({"kind": "run", "frames": MOST_FRAMES}) for _ in range(20)]
    stopped = next(a for (a,) in filter(None, answers) if a["kind"] == "stopped")
    assert "exploded" in stopped["why"]
    assert answers[-1] == []
    assert host.receive({"kind": "restart"})[0]["time"] == 0.0


def test_a_prediction_is_judged_by_theory(host: Host) -> None:
    """Semi-implicit Euler is stable up to k h^2 / m = 4: 14,400 N/m at 60 Hz and 1 kg."""
    for stiffness, right in ((14_390.0, 0), (14_410.0, 1)):
        changed(host, "stiffness", stiffness)
        (judged,) = host.receive({"kind": "predict", "option": 1})
        assert judged["kind"] == "judged"
        assert judged["answer"] == right
        assert judged["right"] == (right == 1)


@pytest.mark.parametrize(
    "line",
    [b"", b"\xff", b"\0", 20_000 * b"[", b'{"a":' + 5000 * b"9" + b"}", RUN + RUN],
    ids=["empty", "no text", "NUL", "nested", "long number", "two messages"],
)
def test_what_is_no_json_is_refused_and_the_scene_goes_on(host: Host, line: bytes) -> None:
    assert [json.loads(answer)["kind"] for answer in answered(host, line)] == ["refused"]
    assert json.loads(answered(host, RUN)[0])["time"] > 0.0


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        (b"[]", "stopped"),
        (b"{}", "unknown kind of message"),
        (b'{"kind": "run", "frames": "3"}', "unknown kind of message"),
        (b'{"kind": "drag", "x": 1}', "unknown kind of message"),
        (b'{"kind": "run", "frames": -5}', "frame"),
        (b'{"kind": "click", "x": NaN, "y": Infinity}', "frame"),
        (b'{"kind": "click", "x": %s, "y": 1}' % LARGE, "stopped"),
        (b'{"kind": "set", "name": "stiffness", "value": %s}' % LARGE, "refused"),
        (b'{"kind": "set", "name": "\\ud800", "value": 1}', "refused"),
        (b'{"kind": "load", "scene": "../x", "values": {}, "peer": ""}', "stopped"),
        (b'{"kind": "load", "scene": "one-spring", "values": {}, "peer": "__class__"}', "stopped"),
    ],
)
def test_every_other_message_gets_one_answer(host: Host, line: bytes, kind: str) -> None:
    (answer,) = answered(host, line)
    told = json.loads(answer)
    assert kind == told["kind"] or kind in told["why"]
    assert json.loads(answered(host, b'{"kind": "restart"}')[-1])["kind"] == "frame"


def test_what_a_body_raises_or_returns_stops_the_scene_and_is_told(
    host: Host, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A student may well return a complex number, as (-2) ** 0.5 is one. JSON does not have it."""
    monkeypatch.setattr("ch03_laws_of_motion.particle.Particle.kinetic_energy", lambda _: 1j)
    (answer,) = answered(host, RUN)
    assert json.loads(answer)["kind"] == "stopped"

    def unwritten(self: object, particle: object, duration: float) -> None:
        raise NotImplementedError("Exercise B6.2: Springs")

    monkeypatch.undo()
    monkeypatch.setattr("ch06_springs.springs.AnchoredSpring.update_force", unwritten)
    host.receive({"kind": "restart"})
    (stopped,) = host.receive({"kind": "run", "frames": 1})
    assert stopped["kind"] == "stopped"
    assert "Exercise B6.2: Springs" in stopped["why"]


def test_an_answer_without_end_stops_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    async def talk() -> list[str]:
        engine = EngineProcess("solutions")
        try:
            return [answer async for answer in engine.ask(json.dumps(load()))]
        finally:
            await engine.close()

    monkeypatch.setattr("lab.engine_process.LONGEST_LINE", 100)
    (stopped,) = asyncio.run(talk())
    assert "draws more than the lab can show" in json.loads(stopped)["why"]
