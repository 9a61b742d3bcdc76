"""Compare the physics of the scenes of chapters 7 to 9 with closed forms and invariants."""

from __future__ import annotations

import math
from typing import Any

import pytest

from ch08_mass_aggregate import blob
from lab.catalog import load
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


def answer(scene: Scene) -> int:
    assert scene.predict is not None
    return scene.predict.answer(scene)


@pytest.mark.parametrize(
    ("method", "rate", "seen"),
    [("time division", 60, 0), ("explicit Euler", 60, 1), ("semi-implicit Euler", 60, 2)],
)
def test_only_time_division_bounces_back_to_the_same_height(
    method: str, rate: int, seen: int
) -> None:
    """Explicit Euler gains energy in every bounce. Time division finds the time of impact."""
    scene = after("bounce", 10.0, method=method, rate=rate)
    assert answer(scene) == seen
    if method == "time division":
        assert scene.error() < 1e-9


def test_a_ball_that_loses_speed_comes_to_rest_at_the_time_of_the_sum() -> None:
    """The impact times form a geometric series: t (1 + c) / (1 - c), with the fall time t."""
    scene = after("bounce", 3.0, method="time division", restitution=0.5)
    end = math.sqrt(2.0 * scene.HEIGHT / G) * 3.0
    assert end < 3.0
    assert scene.ended
    assert f"{end:.3f} s" in scene.facts()


@pytest.mark.parametrize(
    ("count", "per_contact", "stands"), [(10, 2, False), (10, 16, True), (2, 1, True)]
)
def test_a_tall_stack_needs_more_iterations(count: int, per_contact: int, stands: bool) -> None:
    assert answer(after("stack", 4.0, count=count, per_contact=per_contact)) == int(not stands)


def test_the_overlay_shows_the_weight_of_the_stack() -> None:
    """At rest the ground's impulse on the lowest sphere is the total weight times h: N g h."""
    scene = after("stack", 4.0, count=3, per_contact=16)
    given = sum(impulse.y for _, impulse in scene.view_of_contacts.impulses)
    assert given == pytest.approx(3.0 * G / 60.0, rel=0.05)
    assert 0 < scene.view_of_contacts.iterations_used <= 2 * 16 * 3


def test_one_rope_of_rods_stretches_and_another_does_not() -> None:
    """With one step per frame, a pull travels one link per frame. A direct solve has no such lag.

    The lower limit is 1 cm, and the upper limit is a millionth of the rope's length.
    """
    scene = after("ropes", 2.0, angle=60.0)
    (by_frame, by_substeps, solved), _ = scene.beside_exact()
    assert by_frame > 10.0 * by_substeps
    assert by_frame > 0.01
    assert abs(solved) < 3e-6


@pytest.mark.parametrize(("iterations", "too_long"), [(300, 0), (1, 1)])
def test_too_few_iterations_let_the_bridge_sag(iterations: int, too_long: int) -> None:
    assert answer(after("bridge", 3.0, iterations=iterations)) == too_long


def test_late_frames_are_dropped_beyond_the_most_steps() -> None:
    """Each late frame of 0.5 s makes 6 steps of 1 / 60 s and drops the other 0.4 s."""
    scene = after("bridge", 3.0, frames="every 60th late")
    assert scene.stepper.dropped == pytest.approx(3 * 0.4, abs=0.02)


@pytest.mark.parametrize(("x", "lower"), [(-1.0, 0), (-0.25, 1)])
def test_the_side_with_the_larger_torque_goes_down(x: float, lower: int) -> None:
    """2 kg at each end have a torque of 2 * 4 - 2 * 3 = 2 kg m. 4 kg at -0.5 m balance them."""
    scene = after("platform", 2.0, x=x)
    assert answer(scene) == lower
    assert (scene.platform.tilt() > 0.0) == (lower == 0), "positive if the right end is higher"


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


def test_a_wheel_first_gains_what_a_rigid_one_does() -> None:
    """Torque / moment of inertia = 8 F r / (8 m r^2) = 1 rad/s^2, minus the losses of the steps.

    A step removes the speed along the rods. That is a fraction of about (w h)^2 of the spin, or
    1e-4 at 0.5 rad/s.
    """
    scene = after("wheel", 0.5)
    assert scene.spin() == pytest.approx(0.5, rel=0.01)
    assert after("wheel", 4.0).error() > after("wheel", 4.0, rate=240).error()


@pytest.mark.parametrize(("taken", "keeps"), [(0, True), (1, False)])
def test_one_rod_less_lets_the_cube_collapse(taken: int, keeps: bool) -> None:
    assert answer(after("cube", 3.0, taken=taken)) == int(not keeps)


def test_a_trebuchet_gives_less_than_it_takes() -> None:
    scene = after("trebuchet", 4.0)
    assert scene.engine.flies
    assert 0.0 < scene.gained < scene.lost
    # Without drag, the flight is the parabola from the point of release.
    end = after("trebuchet", 7.0)
    x, y = end.way[0]
    assert (x, y) == pytest.approx(scene.way[0])
    assert "It lands" in end.end


@pytest.mark.parametrize(("about", "turns"), [("middle", True), ("smallest", False)])
@pytest.mark.parametrize("disturbance", [5.0, 20.0])
def test_only_a_spin_about_the_middle_axis_turns_over(
    about: str, turns: bool, disturbance: float
) -> None:
    scene = after("spin", 9.0, about=about, disturbance=disturbance)
    assert (scene.turned_over > 0) == turns
    assert answer(scene) == int(turns)
    energy, *momentum = scene.conserved()
    # A splitting of order 2 with sixty steps per turn: (2 pi / 60)^2 is about 1 %.
    assert energy == pytest.approx(scene.first[0], rel=0.01)
    assert momentum == pytest.approx(scene.first[1:], rel=1e-9, abs=1e-12)


def test_euler_angles_break_near_the_lock_and_a_quaternion_does_not() -> None:
    scene = after("orientations", 4.0)
    matrix, quaternion, angles = scene.errors()
    assert quaternion < 1e-9
    assert angles > matrix
    about_x = after("orientations", 4.0, tilt=90.0)  # only one angle changes
    assert about_x.errors()[2] < 1e-9


@pytest.mark.parametrize("rate", [10, 30])
def test_normalizing_does_not_repair_the_angle(rate: int) -> None:
    """A step moves q by w h / 2 along the tangent, so the rotation is only 2 atan(w h / 2)."""
    scene = after("first-order", 2.0, rate=rate)
    turned = 2.0 * rate * 2.0 * math.atan(math.pi / rate)
    assert scene.angle == pytest.approx(turned, rel=1e-9)
    assert scene.q.magnitude() == pytest.approx(1.0, rel=1e-12)
    longer = after("first-order", 2.0, rate=rate, normalize="no")
    length = (1.0 + (math.pi / rate) ** 2) ** (0.5 * 2 * rate)
    assert longer.q.magnitude() == pytest.approx(length, rel=1e-9)
