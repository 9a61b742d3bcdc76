"""The host answers every message and reports what is wrong with the student's code."""

from __future__ import annotations

from typing import Any

import pytest

from lab.host import MOST_FRAMES, Host

Message = dict[str, Any]


def told(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}"


@pytest.fixture
def host() -> Host:
    host = Host(told)
    host.receive(load())
    return host


def load(**values: object) -> Message:
    return {"kind": "load", "scene": "one-spring", "values": values, "peer": ""}


def test_a_scene_is_described_and_shown_at_its_start() -> None:
    scene, frame = Host(told).receive(load(stiffness=50.0))
    assert scene["kind"] == "scene"
    assert {"stiffness", "rate"} <= {parameter["name"] for parameter in scene["parameters"]}
    assert frame["kind"] == "frame"
    assert frame["time"] == 0.0
    assert frame["chart"]["energy, J"] == pytest.approx(25.0)  # k x^2 / 2 at x = 1 m
    assert frame["error"] == 0.0


def test_frames_pass_and_not_more_than_half_a_second(host: Host) -> None:
    (frame,) = host.receive({"kind": "run", "frames": 6})
    assert frame["time"] == pytest.approx(0.1)
    assert frame["cost"] is None  # after so few frames
    (frame,) = host.receive({"kind": "run", "frames": 10**9})
    assert frame["time"] == pytest.approx(0.1 + MOST_FRAMES / 60.0, abs=1e-5)


def test_a_parameter_that_shapes_the_scene_builds_it_anew(host: Host) -> None:
    host.receive({"kind": "run", "frames": 6})
    (frame,) = host.receive({"kind": "set", "name": "stiffness", "value": 200.0})
    assert (frame["time"], frame["chart"]["energy, J"]) == (0.0, pytest.approx(100.0))


def test_a_live_parameter_changes_while_the_scene_runs(host: Host) -> None:
    host.receive({"kind": "run", "frames": 6})
    (frame,) = host.receive({"kind": "set", "name": "integrator", "value": "explicit Euler"})
    assert frame["time"] > 0.0
    (later,) = host.receive({"kind": "run", "frames": MOST_FRAMES})
    # Explicit Euler multiplies the energy by 1 + k h^2 / m in every step.
    grown = later["chart"]["energy, J"] / frame["chart"]["energy, J"]
    assert grown == pytest.approx((1.0 + 100.0 / 3600.0) ** MOST_FRAMES)


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
    (refused,) = host.receive({"kind": "set", "name": name, "value": value})
    assert refused["kind"] == "refused"
    assert words in refused["why"]
    assert host.receive({"kind": "run", "frames": 1})[0]["kind"] == "frame"
    answers = Host(told).receive(load(**{name: value}))
    assert [answer["kind"] for answer in answers] == ["scene", "refused", "frame"]


def test_an_explosion_stops_the_scene_and_a_restart_begins_again(host: Host) -> None:
    host.receive({"kind": "set", "name": "stiffness", "value": 20_000.0})
    answers = [host.receive({"kind": "run", "frames": MOST_FRAMES}) for _ in range(20)]
    stopped = next(a for (a,) in filter(None, answers) if a["kind"] == "stopped")
    assert "exploded" in stopped["why"]
    assert answers[-1] == []
    assert host.receive({"kind": "restart"})[0]["time"] == 0.0


def test_what_a_body_raises_is_told(host: Host, monkeypatch: pytest.MonkeyPatch) -> None:
    def unwritten(self: object, particle: object, duration: float) -> None:
        raise NotImplementedError("Exercise B6.2: Springs")

    monkeypatch.setattr("ch06_springs.springs.AnchoredSpring.update_force", unwritten)
    (stopped,) = host.receive({"kind": "run", "frames": 1})
    assert stopped == {"kind": "stopped", "why": "NotImplementedError: Exercise B6.2: Springs"}


@pytest.mark.parametrize(
    "message", [{}, {"kind": "run"}, {"kind": "run", "frames": "3"}, {"kind": "drag", "x": 1}]
)
def test_an_unknown_message_is_answered(host: Host, message: Message) -> None:
    (answer,) = host.receive(message)
    assert answer["kind"] == "stopped"
    assert "unknown kind of message" in answer["why"]


def test_a_prediction_is_judged_by_theory(host: Host) -> None:
    """Semi-implicit Euler is stable up to k h^2 / m = 4: 14,400 N/m at 60 Hz and 1 kg."""
    for stiffness, right in ((14_390.0, 0), (14_410.0, 1)):
        host.receive({"kind": "set", "name": "stiffness", "value": stiffness})
        (judged,) = host.receive({"kind": "predict", "option": 1})
        assert judged["kind"] == "judged"
        assert judged["answer"] == right
        assert judged["right"] == (right == 1)


def test_a_choice_may_be_spelled_as_a_command_line_needs_it() -> None:
    """A value in `SET="integrator=explicit-euler rate=60"` has no spaces and no decimals."""
    host = Host(told)
    values = {"integrator": "explicit-euler", "rate": "60"}
    message = {"kind": "load", "scene": "one-spring", "values": values, "peer": ""}
    scene, frame = host.receive(message)
    assert frame["kind"] == "frame"
    assert scene["values"] == {"integrator": "explicit Euler", "rate": 60.0}
