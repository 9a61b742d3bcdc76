"""The ballistic range against closed forms, known figures and pymunk, and its errors."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.ballistics import SHOT_TYPES, BallisticRange, Shot, is_spent
from ch04_particle_engine.grenade import FUSE, bounce
from ch04_particle_engine.targets import TargetBlock, hit_fraction
from ch05_forces import particle as chapter_5
from plots.drawing import slope
from scenes.setup import alone
from scenes.shots_and_sparks import flight_of
from scenes.twin import twin_of

INF = math.inf
FRAMES = (1.0 / 240.0, 1.0 / 60.0, 1.0 / 15.0)


def flight(name: str, h: float, frames: int) -> list[tuple[tuple[float, ...], tuple[float, ...]]]:
    """Return positions and velocities of a shot, with x along the range, for each frame."""
    at = BallisticRange()
    at.fire(name)
    p = at.shots[0].particle
    seen = []
    for _ in range(frames):
        at.update(h)
        seen.append(((p.position.z, p.position.y), (p.velocity.z, p.velocity.y)))
    return seen


@pytest.mark.parametrize("h", FRAMES)
@pytest.mark.parametrize("name", SHOT_TYPES)
def test_shots_are_pymunk_bodies_in_the_vertical_plane_but_for_the_order_of_damping(
    name: str, h: float
) -> None:
    """Pymunk damps before it adds the acceleration (Eq. 3.6), and the engine after it (E-16).

    With D = d^h, pymunk's velocity is ahead by a h (1 - D^n), and its position by the sum of that.
    """
    type = SHOT_TYPES[name]
    frames = round(1.5 / h)  # before any shot is removed or bounces
    ours = flight(name, h, frames)
    space, (body,) = twin_of(alone(flight_of(type).particle(chapter_5.Particle)))
    kept = type.damping**h
    a = type.acceleration[1]
    for n, (place, velocity) in enumerate(ours, 1):
        space.step(h)
        ahead = a * h * (1.0 - kept**n)
        gone = a * h * h * (n - (1.0 - kept**n) / (1.0 - kept))
        # The tolerance allows for 360 roundings of numbers up to 150, twice.
        assert body.velocity[0] == pytest.approx(velocity[0], abs=1e-10)
        assert body.velocity[1] == pytest.approx(velocity[1] + ahead, abs=1e-10)
        assert body.position[0] == pytest.approx(place[0], abs=1e-10)
        assert body.position[1] == pytest.approx(place[1] + gone, abs=1e-10)


@pytest.mark.parametrize("name", SHOT_TYPES)
def test_the_error_of_a_shot_is_of_first_order(name: str) -> None:
    counts = (200, 400, 800)
    exact = flight_of(SHOT_TYPES[name]).exact(1.0).position[:2]
    errors = [math.dist(flight(name, 1.0 / n, n)[-1][0], exact) for n in counts]
    # The next order is h / t of the first, and changes the slope by less than a hundredth.
    assert slope(counts, errors) == pytest.approx(-1.0, abs=0.01)


@pytest.mark.parametrize(
    ("damping", "time", "reach"), [(1.0, 3.0491933, 121.96773), (0.99, 3.0347583, 119.557788)]
)
def test_flight_time_and_range_reach_the_known_figures(
    monkeypatch: pytest.MonkeyPatch, damping: float, time: float, reach: float
) -> None:
    shell = replace(SHOT_TYPES["artillery"], damping=damping)
    monkeypatch.setitem(SHOT_TYPES, "artillery", shell)
    landings = []
    for h in (1.0 / 1000.0, 1.0 / 2000.0):
        at = BallisticRange()
        at.fire("artillery")
        p = at.shots[0].particle
        now = 0.0
        while at.shots:
            before = (now, p.position.y, p.position.z)
            at.update(h)
            now += h
        share = before[1] / (before[1] - p.position.y)
        landings.append((before[0] + share * h, before[2] + share * (p.position.z - before[2])))
    coarse, fine = landings
    # With order 1, twice the finer result minus the coarser one has an error of h^2: 1e-6 of 120.
    assert 2.0 * fine[0] - coarse[0] == pytest.approx(time, abs=2e-6)
    assert 2.0 * fine[1] - coarse[1] == pytest.approx(reach, abs=1e-4)


point = st.tuples(*[st.floats(-10.0, 10.0)] * 3)


@given(point, point, point, st.tuples(*[st.floats(0.5, 8.0)] * 3))
def test_the_first_touch_of_a_block_is_that_of_its_faces(
    start: Any, end: Any, middle: Any, size: Any
) -> None:
    """Another method finds the crossings of the faces' planes that are on the box."""
    block = TargetBlock(Vector3(*middle), size, mass=1.0)
    got = hit_fraction(Vector3(*start), Vector3(*end), block)

    def outside(share: float) -> float:
        """Return the distance in m of the point at this fraction of the path from the box."""
        return max(
            abs(s + (e - s) * share - m) - side / 2.0
            for s, e, m, side in zip(start, end, middle, size, strict=True)
        )

    shares = [0.0, 1.0]
    for s, e, m, side in zip(start, end, middle, size, strict=True):
        if abs(e - s) > 1e-9:
            shares += [(m + sign * side / 2.0 - s) / (e - s) for sign in (-1.0, 1.0)]
    # 1e-9 m is far above rounding, and far below the distance of any other face.
    touching = sorted(t for t in shares if 0.0 <= t <= 1.0 and outside(t) <= 1e-9)
    if got is not None:
        assert outside(got) <= 1e-9
        assert touching
        assert abs(got - touching[0]) * math.dist(start, end) <= 1e-9
    else:
        assert all(outside(t) > -1e-9 for t in touching)


def test_a_grenade_that_hits_a_block_is_gone() -> None:
    wall = TargetBlock(Vector3(0, 10, 8), (40.0, 20.0, 1.0), mass=INF)
    at = BallisticRange([wall])
    at.fire("grenade")
    for _ in range(300):
        at.update(1.0 / 60.0)
    assert (wall.hits, at.shots) == (1, [])


def test_a_grenade_below_the_ground_when_it_bursts_is_put_back_first() -> None:
    at = BallisticRange()
    at.fire("grenade")
    p = at.shots[0].particle
    p.position, p.velocity = Vector3(0, 0.5, 0), Vector3(0, -60, 0)
    at.update(FUSE)
    assert len(at.shots) == 12
    assert {shot.particle.position.y for shot in at.shots} == {0.0}


@pytest.mark.parametrize("limit", ["height", "age", "range"])
def test_a_lifetime_ends_just_past_its_limit(limit: str) -> None:
    for past in (False, True):
        y, age, z = 1.0, 1.0, 1.0
        if limit == "height":
            y = -5e-324 if past else 0.0
        elif limit == "age":
            age = math.nextafter(5.0, 9.0) if past else 5.0
        else:
            z = math.nextafter(200.0, 999.0) if past else 200.0
        shot = Shot("pistol", Particle(Vector3(0.0, y, z)))
        shot.age = age
        assert is_spent(shot) is past


def test_a_bounce_is_no_trap() -> None:
    """Repeated bounces end at rest along Y on the ground, and not below it."""
    p = Particle(Vector3(0, 1, 0), Vector3(1, 0, 0), Vector3(0, -10, 0))
    for _ in range(2000):
        p.integrate(1.0 / 60.0)
        bounce(p)
        assert p.position.y >= 0.0
    assert p.position.y < 0.01
