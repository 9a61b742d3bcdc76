"""Compare the physics of the scenes with closed forms and invariants."""

from __future__ import annotations

import math
from typing import Any

import pytest

from ch04_particle_engine.ballistics import SHOT_TYPES
from ch08_mass_aggregate import blob
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


@pytest.mark.parametrize(
    ("name", "seconds", "values", "answer"),
    [
        # The best elevation is lower with drag.
        ("artillery", 0.0, {"damping": 1.0}, 1),
        ("artillery", 0.0, {"damping": 0.3}, 0),
        # Explicit Euler gains energy in every bounce. Time division finds the time of impact.
        ("bounce", 10.0, {"method": "time division", "rate": 60}, 0),
        ("bounce", 10.0, {"method": "explicit Euler", "rate": 60}, 1),
        ("bounce", 10.0, {"method": "semi-implicit Euler", "rate": 60}, 2),
        # A tall stack needs more iterations.
        ("stack", 4.0, {"count": 10, "per_contact": 2}, 1),
        ("stack", 4.0, {"count": 10, "per_contact": 16}, 0),
        ("stack", 4.0, {"count": 2, "per_contact": 1}, 0),
        # Too few iterations let the bridge sag.
        ("bridge", 3.0, {"iterations": 300}, 0),
        ("bridge", 3.0, {"iterations": 1}, 1),
        # 2 kg at each end have a torque of 2 * 4 - 2 * 3 = 2 kg m. 4 kg at -0.5 m balance them.
        ("platform", 2.0, {"x": -1.0}, 0),
        ("platform", 2.0, {"x": -0.25}, 1),
        # One rod less lets the cube collapse.
        ("cube", 3.0, {"taken": 0}, 0),
        ("cube", 3.0, {"taken": 1}, 1),
        # Only a spin about the middle axis turns over.
        ("spin", 9.0, {"about": "middle", "disturbance": 5.0}, 1),
        ("spin", 9.0, {"about": "smallest", "disturbance": 20.0}, 0),
    ],
)
def test_a_run_shows_what_theory_says(
    name: str, seconds: float, values: dict[str, Any], answer: int
) -> None:
    scene = after(name, seconds, **values)
    assert scene.predict.answer(scene) == answer
    if name == "artillery":
        lengths = [load(name)(**values, elevation=e).length for e in (30.0, 45.0, 60.0)]
        assert lengths.index(max(lengths)) == answer
    elif name == "platform":
        assert (scene.platform.tilt() > 0.0) == (answer == 0), "positive if the right end is higher"
    elif name == "spin":
        assert (scene.turned_over > 0) == bool(answer)
        energy, *momentum = scene.conserved()
        # A splitting of order 2 with sixty steps per turn: (2 pi / 60)^2 is about 1 %.
        assert energy == pytest.approx(scene.first[0], rel=0.01)
        assert momentum == pytest.approx(scene.first[1:], rel=1e-9, abs=1e-12)


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


def test_shells_and_balls_land_where_and_when_the_closed_form_says() -> None:
    shell = after("artillery", 1.0, damping=1.0, elevation=30.0, speed=40.0)
    assert shell.length == pytest.approx(40.0**2 * math.sin(math.radians(60.0)) / G, rel=1e-6)
    scene = after("fall-in-air", 8.0, left_mass=4.0, left_drag=0.02, right_drag=0.0, rate=240)
    speed = math.sqrt(4.0 * G / 0.02)  # terminal speed; y = v^2 / g ln cosh(g t / v)
    drag = speed / G * math.acosh(math.exp(G * scene.TOP / speed**2))
    # One step, plus half a step because the book's integrator lags behind during the fall.
    assert scene.landed[0] == pytest.approx(drag, abs=2.0 / 240.0)
    assert scene.landed[1] == pytest.approx(math.sqrt(2.0 * scene.TOP / G), abs=2.0 / 240.0)


def test_keys_choose_aim_and_fire_and_clicks_play_the_fireworks() -> None:
    scene = after("ballistics", 0.0, ("2", "up", "left", "f", "5", "f"))
    assert [shot.type for shot in scene.range.shots] == ["artillery", "grenade"]
    artillery = scene.range.shots[0].particle.velocity
    assert artillery.x > 0.0  # to the left when looking along Z
    assert artillery.y > SHOT_TYPES["artillery"].velocity[1]
    scene = after("fireworks", 0.0, ("2", "6"))
    scene.click(28.0, 30.0)  # where there is no rocket
    assert scene.display.misses == 1
    types = [firework.type for firework in scene.display.show.fireworks]
    assert (types.count(2), types.count(6)) == (1, 2)  # a firework of type 6 begins the game


def test_the_rifle_shoots_where_the_scope_is_clicked() -> None:
    scene = after("sniper", 0.0)
    scene.click(13.0, 10.0)
    velocity = scene.range.bullet.velocity
    # In one frame, wind and gravity turn the bullet by less than 0.5 mrad. Scope +x is right.
    assert -1000.0 * velocity.x / velocity.z == pytest.approx(13.0, abs=0.5)
    assert 1000.0 * velocity.y / velocity.z == pytest.approx(10.0, abs=0.5)
    assert scene.range.shots_left == 9


@pytest.mark.parametrize(("share", "explodes"), [(0.9, False), (1.1, True)])
def test_the_bridge_explodes_beyond_its_limit(share: float, explodes: bool) -> None:
    """With nine planks, the limit of an endless row is 3 % too low: 4 is 4 sin^2(8 pi / 18)."""
    stiffness = share * load("spring-bridge")(rate=120.0).limit()
    host = Host(str)
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


def test_a_ball_that_loses_speed_comes_to_rest_at_the_time_of_the_sum() -> None:
    """The impact times form a geometric series: t (1 + c) / (1 - c), with the fall time t."""
    scene = after("bounce", 3.0, method="time division", restitution=0.5)
    end = math.sqrt(2.0 * scene.HEIGHT / G) * 3.0
    assert end < 3.0
    assert scene.ended
    assert f"{end:.3f} s" in scene.facts()


def test_the_overlay_shows_the_weight_of_the_stack() -> None:
    """At rest the ground's impulse on the lowest sphere is the total weight times h: N g h."""
    scene = after("stack", 4.0, count=3, per_contact=16)
    given = sum(impulse.y for _, impulse in scene.view_of_contacts.impulses)
    assert given == pytest.approx(3.0 * G / 60.0, rel=0.05)
    assert 0 < scene.view_of_contacts.iterations_used <= 2 * 16 * 3


def test_one_rope_of_rods_stretches_and_another_does_not() -> None:
    """In one step, a pull travels one link per frame. A direct solve has no such lag."""
    scene = after("ropes", 2.0, angle=60.0)
    (by_frame, by_substeps, solved), _ = scene.beside_exact()
    assert by_frame > 10.0 * by_substeps
    assert by_frame > 0.01
    assert abs(solved) < 3e-6


def test_late_frames_are_dropped_beyond_the_most_steps() -> None:
    """Each late frame of 0.5 s makes 6 steps of 1 / 60 s and drops the other 0.4 s."""
    scene = after("bridge", 3.0, frames="every 60th late")
    assert scene.stepper.dropped == pytest.approx(3 * 0.4, abs=0.02)


def test_the_pivot_can_be_freed_and_the_weight_dragged() -> None:
    scene = after("platform", 0.5, ("right", "f"))
    assert (scene.x, scene.free) == (-0.5, True)
    scene.drag("weight", 99.0, 0.0)
    assert scene.x == 4.0


@pytest.mark.parametrize(("cables", "whole"), [("none", False), ("along each bond", True)])
def test_cables_keep_a_blob_together(cables: str, whole: bool) -> None:
    """A bond breaks at twice its length, and a cable keeps it from getting that long."""
    scene = after("blob", 1.0, cables=cables, push=20.0)
    fewest = len(scene.blob.bonds)
    for key in ("up", "down", "down"):
        scene.press(key)
        for _ in range(20):
            scene.advance()
            fewest = min(fewest, scene.holding())
            lengths = [
                (b.b.position - b.a.position).magnitude() / b.rest_length for b in scene.blob.bonds
            ]
            if whole:
                assert max(lengths) < 1.05 * blob.BREAK
    assert (fewest == len(scene.blob.bonds)) == whole


def test_a_trebuchet_gives_less_than_it_takes() -> None:
    scene = after("trebuchet", 4.0)
    assert scene.engine.flies
    assert 0.0 < scene.gained < scene.lost
    # Without drag, the flight is the parabola from the point of release.
    end = after("trebuchet", 7.0)
    x, y = end.way[0]
    assert (x, y) == pytest.approx(scene.way[0])
    assert "It lands" in end.end


def test_euler_angles_break_near_the_lock_and_a_quaternion_does_not() -> None:
    scene = after("orientations", 4.0)
    matrix, quaternion, angles = scene.errors()
    assert quaternion < 1e-9
    assert angles > matrix
    about_x = after("orientations", 4.0, tilt=90.0)  # only one angle changes
    assert about_x.errors()[2] < 1e-9


def test_an_orientation_that_is_not_normalized_gets_longer() -> None:
    """A step moves q by w h / 2 along the tangent, so its length grows by the same factor."""
    rate = 10
    assert after("first-order", 2.0, rate=rate).q.magnitude() == pytest.approx(1.0, rel=1e-12)
    longer = after("first-order", 2.0, rate=rate, normalize="no")
    length = (1.0 + (math.pi / rate) ** 2) ** (0.5 * 2 * rate)
    assert longer.q.magnitude() == pytest.approx(length, rel=1e-9)
