"""Compare the error that a scene shows at every step rate with an independent calculation.

The calculation repeats the method in plain numbers, and compares it with a closed form or SciPy at
the time of the last complete step. A scene shows this error only if it compares its state with the
exact answer at the time that it has simulated, because below 60 steps per second the state lags.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import cache, partial
from typing import Any

import numpy
import pytest
from scipy.integrate import solve_ivp

from ch08_mass_aggregate import wheel
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


def damping_forms(h: float) -> Errors:
    """A step moves by v h, and then keeps q = d^h of v: a geometric series."""
    d, n = 0.4, 0
    while True:
        stepped = 8.0 * h * (1.0 - d ** (n * h)) / (1.0 - d**h)
        yield abs(stepped - 8.0 * (1.0 - d ** (n * h)) / -math.log(d))
        n += 1


def fall_in_air(h: float) -> Errors:
    """The exact fall is v^2 / g ln cosh(g t / v), where v is the terminal speed."""
    balls, t = [[m, 0.0, 0.0] for m in (4.0, 0.5)], 0.0  # mass, fallen and speed
    while True:
        worst = 0.0
        for m, fallen, _ in balls:
            v = math.sqrt(m * G / 0.02)
            worst = max(worst, abs(fallen - v * v / G * math.log(math.cosh(G * t / v))))
        yield worst
        for ball in balls:
            ball[1] += ball[2] * h
            ball[2] += (G - 0.02 * ball[2] ** 2 / ball[0]) * h
        t += h


@cache
def kepler() -> Any:
    """Return the orbit by SciPy for mu = 4, a semi-major axis of 1.5, and eccentricity 0.4."""

    def rates(_: float, s: Any) -> list[float]:
        pull = -4.0 / math.hypot(s[0], s[1]) ** 3
        return [s[2], s[3], pull * s[0], pull * s[1]]

    start = [0.9, 0.0, 0.0, math.sqrt(4.0 / 1.5 * 1.4 / 0.6)]
    span = (0.0, SECONDS + 0.1)
    return solve_ivp(rates, span, start, "DOP853", rtol=1e-12, atol=1e-12, dense_output=True).sol


def orbit(order: str, h: float) -> Errors:
    x, y, vx, vy = kepler()(0.0)
    n = 0
    while True:
        truth = kepler()(n * h)
        yield max(abs(x - truth[0]), abs(y - truth[1]))
        pull = -4.0 / math.hypot(x, y) ** 3
        ax, ay = pull * x, pull * y
        if order == "position first":
            x, y, vx, vy = x + vx * h, y + vy * h, vx + ax * h, vy + ay * h
        else:
            vx, vy = vx + ax * h, vy + ay * h
            x, y = x + vx * h, y + vy * h
        n += 1


def matrix_of(name: str, k: float, c: float, h: float) -> Any:
    """Return the matrix of one step, which maps (x, v) to its new value for 1 kg on a spring."""
    one, a = numpy.eye(2), numpy.array([[0.0, 1.0], [-k, -c]])
    drift, kick = (
        numpy.array([[1.0, h], [0.0, 1.0]]),
        numpy.array([[1.0, 0.0], [-k * h, 1 - c * h]]),
    )
    half = numpy.array([[1.0, 0.5 * h], [0.0, 1.0]])
    if name == "velocity Verlet":
        moved = numpy.array([one[0] + h * a[0] @ one + 0.5 * h * h * a[1], one[1] + h * a[1]])
        return numpy.array([moved[0], one[1] + 0.5 * h * (a[1] + (a @ moved)[1])])
    z = h * a
    return {
        "explicit Euler": one + z,
        "semi-implicit Euler": drift @ kick,
        "pymunk": kick @ drift,
        "leapfrog": half @ kick @ half,
        "Runge-Kutta 4": one + z @ (one + z / 2 @ (one + z / 3 @ (one + z / 4))),
    }[name]


def one_spring(name: str, c: float, h: float) -> Errors:
    """The exact swing is e^(-c t / 2) (cos w t + c / (2 w) sin w t), where w^2 = k - c^2 / 4."""
    step, state, n = matrix_of(name, 100.0, c, h), numpy.array([1.0, 0.0]), 0
    w = math.sqrt(100.0 - 0.25 * c * c)
    while True:
        t = n * h
        truth = math.exp(-0.5 * c * t) * (math.cos(w * t) + 0.5 * c / w * math.sin(w * t))
        yield abs(state[0] - truth)
        state, n = step @ state, n + 1


def integrator_race(h: float) -> Errors:
    step, state, n = matrix_of("Runge-Kutta 4", 40.0, 0.0, h), numpy.array([1.0, 0.0]), 0
    w = math.sqrt(40.0)
    while True:
        truth = math.cos(w * n * h), -math.sin(w * n * h)
        yield max(abs(state[0] - truth[0]), abs(state[1] / w - truth[1]))
        state, n = step @ state, n + 1


def bounced(t: float) -> float:
    """Return the height of a ball dropped from 2 m that keeps 0.8 of its speed in each impact."""
    begun, speed = -math.sqrt(4.0 / G), math.sqrt(4.0 * G)  # as if it had been thrown up before
    while t > begun + 2.0 * speed / G:
        begun, speed = begun + 2.0 * speed / G, 0.8 * speed
    return speed * (t - begun) - 0.5 * G * (t - begun) ** 2


def bounce(name: str, h: float) -> Errors:
    y, v, n = 2.0, 0.0, 0
    while True:
        yield abs(y - bounced(n * h))
        if name == "explicit Euler":
            y, v = y + v * h, v - G * h
        else:
            v -= G * h
            y += v * h
        if y <= 0.0:
            y = 0.0
            if v < 0.0:
                v = max(0.0, 0.8 * (-v - G * h))  # what gravity adds in a step does not bounce
        n += 1


def driven_wheel(h: float) -> Errors:
    """Yield how far the spin lags behind that of a rigid wheel, whose rim has mass 8 at 1 m."""
    machine, n = wheel.Wheel(1.0, 8), 0
    machine.world.resolver.iterations = 300
    while True:
        yield abs(wheel.spin(machine.hub, machine.rim) - n * h)
        machine.step(h)
        n += 1


def first_order(h: float) -> Errors:
    n = 0
    while True:
        yield n * abs(math.tau * h - 2.0 * math.atan(math.pi * h))
        n += 1


def no_error(_: float) -> Errors:
    while True:
        yield 0.0


CASES: list[tuple[str, str, Method, dict[str, Any]]] = [
    ("frame-rates", "", frame_rates, {}),
    ("throw", "", throw, {"angle": 55.0, "speed": 12.0, "damping": 0.7}),
    ("artillery", "", artillery, {}),
    ("damping-forms", "", damping_forms, {}),
    ("fall-in-air", "", fall_in_air, {}),
    ("orbit", "", partial(orbit, "position first"), {"order": "position first"}),
    ("orbit", "", partial(orbit, "velocity first"), {"order": "velocity first"}),
    *[
        ("one-spring", "", partial(one_spring, name, c), {"integrator": name, "damping": c})
        for name in load("one-spring").integrator.options
        for c in (0.0, 1.0)
    ],
    ("one-spring", "exact", no_error, {}),
    ("one-spring", "pymunk", partial(one_spring, "pymunk", 0.0), {}),
    ("integrator-race", "", integrator_race, {}),
    (
        "bounce",
        "",
        partial(bounce, "semi-implicit Euler"),
        {"method": "semi-implicit Euler", "restitution": 0.8},
    ),
    (
        "bounce",
        "",
        partial(bounce, "explicit Euler"),
        {"method": "explicit Euler", "restitution": 0.8},
    ),
    ("bounce", "", no_error, {"method": "time division"}),
    ("wheel", "", driven_wheel, {}),
    ("orientations", "", no_error, {"speed": 360.0}),
    ("first-order", "", first_order, {}),
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
    assert offered == {name for name, *_ in CASES}


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
    """Runge-Kutta 4 multiplies (x, v) by a matrix in each step, whatever the rate was before."""
    scene = load("one-spring")(integrator="Runge-Kutta 4", rate=480.0)
    state, time = numpy.array([1.0, 0.0]), 0.0
    for rate in (15.0, 240.0, 30.0, 480.0):
        scene.values["rate"] = rate
        for _ in range(7):
            scene.advance()
        while time + 1.0 / rate <= scene.time + 1e-9:
            state = matrix_of("Runge-Kutta 4", 100.0, 0.0, 1.0 / rate) @ state
            time += 1.0 / rate
        assert scene.error() == pytest.approx(abs(state[0] - math.cos(10.0 * time)), rel=1e-6)


@pytest.mark.parametrize("rate", load("orientations").rate.options)
def test_an_unrepaired_matrix_shows_its_own_error(rate: int) -> None:
    """About X, each step multiplies the other axes by 1 + i w h, seen as complex numbers."""
    scene = load("orientations")(rate=rate, tilt=90.0, speed=180.0, repair="no")
    for frame in range(1, 121):
        scene.advance()
        n = frame * rate // 60
        wanted = abs((1.0 + 1j * math.pi / rate) ** n - numpy.exp(1j * math.pi * n / rate))
        assert scene.errors()[0] == pytest.approx(100.0 * wanted, rel=1e-6, abs=1e-9)
