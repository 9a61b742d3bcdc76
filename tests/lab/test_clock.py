"""Compare the error that a scene shows at every step rate with an independent calculation.

Below 60 steps per second the state lags, so the exact answer must be that of the simulated time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from lab.catalog import entries, load
from lab.scene import parameters_of
from scenes.parameters import Choice

G = 9.81
SECONDS = 2.0
Errors = Iterator[float]  # at the start and after every step
Method = Callable[[float], Errors]  # takes the length of a step


def drag_flight(h: float, x: float, y: float, vx: float, vy: float, d: float) -> Errors:
    """Yield the error of a throw with linear drag, by position first and velocity after."""
    k, t, start = -math.log(d), 0.0, (x, y, vx, vy)
    while True:
        x0, y0, vx0, vy0 = start
        if k:
            gone = -math.expm1(-k * t) / k
            truth = x0 + vx0 * gone, y0 + (vy0 + G / k) * gone - G * t / k
        else:
            truth = x0 + vx0 * t, y0 + vy0 * t - 0.5 * G * t * t
        yield max(abs(x - truth[0]), abs(y - truth[1]))
        x, y, t = x + vx * h, y + vy * h, t + h
        vx, vy = vx * d**h, (vy - G * h) * d**h


def frame_rates(h: float) -> Errors:
    angle = math.radians(50.0)
    speed = 14.0
    return drag_flight(h, 0.0, 1.0, speed * math.cos(angle), speed * math.sin(angle), 1.0)


def throw(h: float) -> Errors:
    angle, speed = math.radians(55.0), 12.0
    return drag_flight(h, 1.0, 2.0, speed * math.cos(angle), speed * math.sin(angle), 0.7)


def artillery(h: float) -> Errors:
    speed = 40.0 * math.sqrt(0.5)  # at 45 degrees
    return drag_flight(h, 0.0, 0.0, speed, speed, 0.8)


def no_error(_: float) -> Errors:
    while True:
        yield 0.0


CASES: list[tuple[str, str, Method, dict[str, Any]]] = [
    ("frame-rates", "", frame_rates, {}),
    ("throw", "", throw, {"angle": 55.0, "speed": 12.0, "damping": 0.7}),
    ("artillery", "", artillery, {}),
    ("one-spring", "exact", no_error, {}),
    ("bounce", "", no_error, {"method": "time division"}),
    ("orientations", "", no_error, {"speed": 360.0}),
]
# Scenes whose errors are not calculated here, but must fall by this order with the step length.
ORDERS = {"velocity Verlet": 2, "leapfrog": 2, "Runge-Kutta 4": 4}
OTHERS: list[tuple[str, str, int, dict[str, Any]]] = [
    *[(name, "", 1, {}) for name in ("damping-forms", "fall-in-air", "first-order", "wheel")],
    ("orbit", "", 1, {"order": "position first"}),
    ("orbit", "", 1, {"order": "velocity first"}),
    *[
        ("one-spring", "", ORDERS.get(name, 1), {"integrator": name, "damping": c})
        for name in load("one-spring").integrator.options
        for c in (0.0, 1.0)
        if not (name == "leapfrog" and c)  # its order falls if a force depends on the velocity
    ],
    ("one-spring", "pymunk", 1, {}),
    ("integrator-race", "", 4, {}),
    ("bounce", "", 1, {"method": "semi-implicit Euler", "restitution": 0.8}),
    ("bounce", "", 1, {"method": "explicit Euler", "restitution": 0.8}),
]
RUNS = [
    pytest.param(
        *case, rate, id=f"{case[0]}-{case[1]}-{rate:g}-{'-'.join(map(str, case[3].values()))}"
    )
    for case in CASES
    for rate in load(case[0]).rate.options
]


def test_every_scene_with_an_exact_answer_and_a_rate_is_compared() -> None:
    offered = {
        entry.name
        for entry in entries()
        if load(entry.name).exact_from
        and isinstance(parameters_of(load(entry.name)).get("rate"), Choice)
    }
    assert offered == {name for name, *_ in (*CASES, *OTHERS)}


@pytest.mark.parametrize(("name", "peer", "method", "values", "rate"), RUNS)
def test_a_scene_shows_the_error_of_its_method(
    name: str, peer: str, method: Method, values: dict[str, Any], rate: float
) -> None:
    kind = load(name)
    kind = kind.peers[peer] if peer else kind
    scene = kind(rate=rate, **values)
    own = scene.rates[-1] if name == "frame-rates" else rate  # shows the error of its last ball
    if name == "throw":
        scene.press("t")
    found, n = [], 0
    errors = method(1.0 / own)
    error = next(errors)
    for frame in range(1, round(60 * SECONDS) + 1):
        scene.advance()
        while n < int(frame * own + 1e-6) // 60:
            n, error = n + 1, next(errors)
        if getattr(scene, "flies", True):  # a shell or a ball stops where it lands
            found.append((scene.error(), error))
    assert len(found) > 60
    # The two round differently in every step. What explicit Euler rounds grows as the swing does.
    largest = max(wanted for _, wanted in found)
    for shown, wanted in found:
        assert shown == pytest.approx(wanted, rel=1e-6, abs=1e-9 * max(1.0, largest))


def test_a_change_of_the_rate_leaves_the_state_and_the_exact_answer_together() -> None:
    """The exact solver's state belongs to the simulated time, whatever the rate was before."""
    scene = load("one-spring").peers["exact"](rate=480.0)
    for rate in (15.0, 240.0, 30.0, 480.0):
        scene.values["rate"] = rate
        for _ in range(7):
            scene.advance()
        assert scene.time - 1.0 / rate < scene.simulated + 1e-9
        assert scene.beside_exact()[0][0] == pytest.approx(math.cos(10.0 * scene.simulated))
        assert scene.error() < 1e-9


@pytest.mark.parametrize(("name", "peer", "order", "values"), OTHERS, ids=str)
def test_an_error_changes_only_with_a_step_and_falls_by_its_order(
    name: str, peer: str, order: int, values: dict[str, Any]
) -> None:
    largest = []
    kind = load(name).peers[peer] if peer else load(name)
    rates = [rate for rate in kind.rate.options if rate >= 30]
    for rate in (min(rates), max(rates)):
        scene = kind(rate=rate, **values)
        errors, simulated = [scene.error()], scene.simulated
        for _ in range(round(60 * SECONDS)):
            scene.advance()
            errors.append(scene.error())
            assert errors[-1] == errors[-2] or scene.simulated > simulated
            simulated = scene.simulated
        largest.append(max(errors))
    # Errors vary with the phase of a bounce.
    assert 0.0 < largest[1] < 3.0 * largest[0] * (min(rates) / max(rates)) ** order
