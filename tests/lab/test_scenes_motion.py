"""Compare the physics of the scenes of chapters 2 to 6 with closed forms."""

from __future__ import annotations

import math
from typing import Any

import pytest

from ch04_particle_engine.ballistics import SHOT_TYPES
from lab.catalog import load
from lab.host import Host
from lab.scene import Scene

G = 9.81


def after(name: str, seconds: float, keys: tuple[str, ...] = (), **values: object) -> Any:
    """Return a scene after pressing these keys and running for this time."""
    scene: Scene = load(name)(**values)
    for key in keys:
        scene.press(key)
    for _ in range(round(60 * seconds)):
        scene.advance()
    return scene


def test_dragged_vectors_have_the_shadow_and_the_product_of_the_formula() -> None:
    scene = after("projection", 0.1)
    scene.drag("a", 3.0, 1.0)
    scene.drag("b", 0.0, 2.0)
    assert scene.beside_exact()[0] == pytest.approx([0.0, 1.0])  # onto the y axis
    scene = after("cross-product", 0.1)
    (x, y, z), _ = scene.beside_exact()
    a, b = scene.a, scene.b
    area = math.sqrt(a.squared_magnitude() * b.squared_magnitude() - a.dot(b) ** 2)
    assert math.hypot(x, y, z) == pytest.approx(area)


@pytest.mark.parametrize("rate", [5, 30])
def test_a_throw_is_too_high_by_what_each_step_leaves_out(rate: int) -> None:
    """Each step lacks the term a h^2 / 2, so n steps of length h end n g h^2 / 2 too high."""
    scene = after("frame-rates", 1.0, rate=rate)
    error, *_ = scene.chart().values()
    assert error == pytest.approx(G / rate / 2.0, rel=1e-6)


def test_damping_per_step_brakes_more_at_more_steps() -> None:
    """The distance is a geometric series, v h q (1 - q^n) / (1 - q), with q for each step."""
    scene = after("damping-forms", 3.0, rate=240, kept=0.5)
    q, h = 0.5 ** (1.0 / 60.0), 1.0 / 240.0
    slid = scene.SPEED * h * (1.0 - q ** (3 * 240)) / (1.0 - q)
    assert scene.places[0] == pytest.approx(slid, rel=1e-9)
    assert scene.error() < scene.SPEED * h  # one step


def test_keys_and_clicks_aim_the_ball() -> None:
    scene = after("throw", 0.0, ("up", "right", "right"))
    assert (scene.angle, scene.speed) == (57.0, 9.5)
    scene.press("t")
    velocity = scene.flight.velocity
    assert math.degrees(math.atan2(velocity[1], velocity[0])) == pytest.approx(57.0)
    scene = after("throw", 0.0)
    scene.click(4.0, 6.0)  # the speed is twice the distance from the hand at (1, 2)
    assert scene.flight.velocity == pytest.approx((6.0, 8.0, 0.0))


def test_a_ball_that_falls_through_the_hoop_counts_and_moves_it() -> None:
    scene = after("throw", 0.0)
    hoop = scene.hoop
    run, rise = (to - start for to, start in zip(hoop, scene.HAND, strict=True))
    # The speed of a parabola through the middle of the hoop.
    angle = math.radians(scene.angle)
    fall = run * math.tan(angle) - rise
    speed = run / math.cos(angle) * math.sqrt(G / (2.0 * fall))
    for factor, score in ((0.8, 0), (1.2, 0), (1.0, 1)):
        scene.values["speed"] = factor * speed
        scene.press("t")
        while scene.flies:
            scene.advance()
        assert scene.score == score
    for _ in range(120):
        scene.advance()
    assert scene.hoop != hoop


def test_a_shell_without_drag_lands_where_the_parabola_does() -> None:
    scene = after("artillery", 1.0, damping=1.0, elevation=30.0, speed=40.0)
    assert scene.length == pytest.approx(40.0**2 * math.sin(math.radians(60.0)) / G, rel=1e-6)


@pytest.mark.parametrize(("damping", "best"), [(1.0, 1), (0.3, 0)])
def test_the_best_elevation_is_lower_with_drag(damping: float, best: int) -> None:
    kind = load("artillery")
    lengths = [kind(damping=damping, elevation=e).length for e in (30.0, 45.0, 60.0)]
    assert lengths.index(max(lengths)) == best
    assert kind.predict is not None
    assert kind.predict.answer(kind(damping=damping)) == best


def test_keys_choose_aim_and_fire() -> None:
    scene = after("ballistics", 0.0, ("2", "up", "left", "f", "5", "f"))
    assert [shot.type for shot in scene.range.shots] == ["artillery", "grenade"]
    artillery = scene.range.shots[0].particle.velocity
    assert artillery.x > 0.0  # to the left when looking along Z
    assert artillery.y > SHOT_TYPES["artillery"].velocity[1]


def test_clicks_and_keys_play_the_fireworks() -> None:
    scene = after("fireworks", 0.0, ("2", "6"))
    scene.click(28.0, 30.0)  # where there is no rocket
    assert scene.display.misses == 1
    types = [firework.type for firework in scene.display.show.fireworks]
    assert (types.count(2), types.count(6)) == (1, 2)  # a firework of type 6 begins the game


def test_balls_land_at_the_times_of_the_closed_form() -> None:
    scene = after("fall-in-air", 8.0, left_mass=4.0, left_drag=0.02, right_drag=0.0, rate=240)
    speed = math.sqrt(4.0 * G / 0.02)  # terminal speed; y = v^2 / g ln cosh(g t / v)
    drag = speed / G * math.acosh(math.exp(G * scene.TOP / speed**2))
    # One step, plus the half step by which the book's integrator is late in the whole fall.
    assert scene.landed[0] == pytest.approx(drag, abs=2.0 / 240.0)
    assert scene.landed[1] == pytest.approx(math.sqrt(2.0 * scene.TOP / G), abs=2.0 / 240.0)


def test_an_orbit_closes_only_with_the_velocity_first() -> None:
    """The energy per kg is v^2 / 2 - mu / r. Semi-implicit Euler keeps it up to order h."""
    drift = {}
    for order in load("orbit").order.options:
        scene = load("orbit")(order=order)
        first = scene.chart()["energy, J"]
        while scene.time < 3.0 * scene.orbit.period:
            scene.advance()
        drift[order] = scene.chart()["energy, J"] / first - 1.0
    assert abs(drift["velocity first"]) < 0.1 * abs(drift["position first"])


def test_the_rifle_shoots_where_the_scope_is_clicked() -> None:
    scene = after("sniper", 0.0)
    scene.click(13.0, 10.0)
    velocity = scene.range.bullet.velocity
    # In one frame, wind and gravity turn the bullet by less than 0.5 mrad. Scope +x is right.
    assert -1000.0 * velocity.x / velocity.z == pytest.approx(13.0, abs=0.5)
    assert 1000.0 * velocity.y / velocity.z == pytest.approx(10.0, abs=0.5)
    assert scene.range.shots_left == 9


def test_each_integrator_gains_or_loses_what_theory_says() -> None:
    """Explicit Euler multiplies the energy by 1 + k h^2 / m per step; backward Euler divides."""
    scene = after("integrator-race", 1.0, stiffness=40.0, rate=30.0)
    factor = (1.0 + 40.0 / 900.0) ** 30
    energy = {name: math.hypot(*scene.phase(ball)) ** 2 for name, ball in scene.balls.items()}
    assert energy["explicit Euler"] == pytest.approx(factor, rel=1e-9)
    assert energy["backward Euler"] == pytest.approx(1.0 / factor, rel=1e-9)
    assert energy["trapezoidal rule"] == pytest.approx(1.0, rel=1e-9)
    assert energy["Runge-Kutta 4"] == pytest.approx(1.0, abs=(40.0 / 900.0) ** 3 * 30)


@pytest.mark.parametrize(("share", "explodes"), [(0.9, False), (1.1, True)])
def test_the_bridge_explodes_beyond_its_limit(share: float, explodes: bool) -> None:
    """The limit holds for an endless row. With nine planks, 4 becomes 4 sin^2(8 pi / 18), 3 % more.

    At 60 Hz a bridge just above the limit only shakes, because its springs are then slanted.
    """

    def told(error: BaseException) -> str:
        return str(error)

    stiffness = share * load("spring-bridge")(rate=120.0).limit()
    host = Host(told)
    values = {"stiffness": stiffness, "rate": 120.0}
    host.receive({"kind": "load", "scene": "spring-bridge", "values": values, "peer": ""})
    answers = [a for _ in range(40) for a in host.receive({"kind": "run", "frames": 30})]
    assert any(answer["kind"] == "stopped" for answer in answers) == explodes


def test_a_corner_of_the_cloth_can_be_pulled() -> None:
    scene = after("cloth", 0.5)
    scene.drag("right", 1.5, 0.3)
    corner = scene.particles[dict(scene.HELD)["right"]]
    for _ in range(30):
        scene.advance()
    assert (corner.position.x, corner.position.y) == (1.5, 0.3)
