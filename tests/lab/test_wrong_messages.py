"""Messages that the lab's page never sends, and answers that a page cannot take."""

from __future__ import annotations

import asyncio
import json

import pytest

from lab.child import answered
from lab.engine_process import EngineProcess
from lab.host import Host
from scenes.reason import reason

LOAD = b'{"kind": "load", "scene": "one-spring", "values": {}, "peer": ""}'
RUN = b'{"kind": "run", "frames": 1}'
LARGE = 400 * b"9"


@pytest.fixture
def host() -> Host:
    host = Host(reason)
    answered(host, LOAD)
    return host


@pytest.mark.parametrize(
    "line",
    [b"hello", b"", b"\xff", b"\0", 20_000 * b"[", b'{"a":' + 5000 * b"9" + b"}", RUN + RUN],
    ids=["no JSON", "empty", "no text", "NUL", "nested", "long number", "two messages"],
)
def test_what_is_no_json_is_refused_and_the_scene_goes_on(host: Host, line: bytes) -> None:
    assert [json.loads(answer)["kind"] for answer in answered(host, line)] == ["refused"]
    assert json.loads(answered(host, RUN)[0])["time"] > 0.0


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        (b"[]", "stopped"),
        (b"null", "stopped"),
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
    assert [json.loads(answer)["kind"] for answer in answered(host, line)] == [kind]
    assert json.loads(answered(host, b'{"kind": "restart"}')[-1])["kind"] == "frame"


def test_an_answer_that_json_does_not_have_stops_the_scene(
    host: Host, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A student may well return a complex number, as (-2) ** 0.5 is one."""
    monkeypatch.setattr("ch03_laws_of_motion.particle.Particle.kinetic_energy", lambda _: 1j)
    (answer,) = answered(host, RUN)
    assert json.loads(answer)["kind"] == "stopped"


def test_an_answer_without_end_stops_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    async def talk() -> list[str]:
        engine = EngineProcess("solutions")
        try:
            return [answer async for answer in engine.ask(LOAD.decode())]
        finally:
            await engine.close()

    monkeypatch.setattr("lab.engine_process.LONGEST_LINE", 100)
    (stopped,) = asyncio.run(talk())
    assert "draws more than the lab can show" in json.loads(stopped)["why"]
