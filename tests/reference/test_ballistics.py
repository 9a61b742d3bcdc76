"""The ballistic range against closed forms, known figures and pymunk, and its errors."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import scaling
from ch04_particle_engine.ballistics import (
    MUZZLE,
    SHOT_TYPES,
    BallisticRange,
    Shot,
    aim,
    is_spent,
)
from ch04_particle_engine.grenade import FUSE, bounce, fragments
from ch04_particle_engine.targets import TargetBlock, hit_fraction, strike_first
from studies.drawing import slope
from studies.runs.drag_flight import flight_of, with_pymunk

NAN, INF = math.nan, math.inf
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
    theirs = with_pymunk(flight_of(type, 1.5), h, frames)[1:]
    kept = type.damping**h
    a = type.acceleration[1]
    for n, ((place, velocity), body) in enumerate(zip(ours, theirs, strict=True), 1):
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
    exact = flight_of(SHOT_TYPES[name], 1.0).exact(1.0).position[:2]
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


def test_every_shot_leaves_the_range_in_the_end() -> None:
    at = BallisticRange()
    for name in SHOT_TYPES:
        for azimuth in (-2.0, 0.0, 1.0, 3.0):
            for elevation in (None, -1.0, 0.5, math.pi / 2.0):
                at.fire(name, azimuth, elevation)
    for _ in range(600):
        at.update(1.0 / 60.0)
    assert at.shots == []


@given(
    st.floats(-10.0, 10.0),
    st.floats(-7.0, 7.0),
    st.floats(0.0, 1e3),
)
def test_aiming_keeps_the_speed(azimuth: float, elevation: float, speed: float) -> None:
    # The tolerance allows for a dozen roundings.
    assert aim(speed, azimuth, elevation).magnitude() == pytest.approx(speed, rel=1e-14)


def test_a_slowed_bullet_keeps_energy_and_arc() -> None:
    """5 g at 500 m/s, slowed 20 times, has 625 J and falls 0.2 m in 100 m, both ways."""
    mass, speed, gravity, factor = 0.005, 500.0, 10.0, 20.0
    slow = speed / factor
    heavy = scaling.slowed_mass(mass, factor)
    weak = scaling.slowed_gravity(gravity, factor)
    assert scaling.muzzle_energy(mass, speed) == 625.0
    assert scaling.muzzle_energy(heavy, slow) == 625.0
    for g, v in ((gravity, speed), (weak, slow)):
        assert g * (100.0 / v) ** 2 / 2.0 == pytest.approx(0.2, rel=1e-15)


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


def test_no_frame_is_too_long_for_a_thin_block() -> None:
    """At 1 Hz a laser moves 100 m per frame, but a wall of 1 mm stops it."""
    for h in (1.0, 1.0 / 3.0, 1.0 / 60.0):
        wall = TargetBlock(Vector3(0, 1.5, 57.3), (2.0, 2.0, 0.001), mass=INF)
        at = BallisticRange([wall])
        at.fire("laser")
        for _ in range(round(1.0 / h)):
            at.update(h)
        assert (wall.hits, at.shots) == (1, [])


@pytest.mark.parametrize("mass", [0.5, 5.0, 500.0])
def test_a_blow_keeps_the_momentum_along_the_ground(mass: float) -> None:
    block = TargetBlock(Vector3(0, 1, 5), (2.0, 2.0, 2.0), mass=mass)
    block.particle.velocity = Vector3(0.5, 0.0, -1.0)
    shot = Particle(Vector3(0, 1, 5), Vector3(3, -4, 30), mass=2.0)
    before = shot.momentum() + block.particle.momentum()
    assert strike_first(Vector3(0, 1, 0), shot, [block]) is block
    after = block.particle.momentum()
    assert (after.x, after.y) == pytest.approx((before.x, 0.0), rel=1e-15)
    assert after.z == pytest.approx(before.z, rel=1e-15)


def test_a_grenade_never_gains_energy_by_its_bounces() -> None:
    at = BallisticRange()
    at.fire("grenade")
    p = at.shots[0].particle
    energies = []
    for _ in range(round(FUSE * 60) - 2):
        at.update(1.0 / 60.0)
        energies.append(p.kinetic_energy() + p.mass * 10.0 * p.position.y)
    # Explicit Euler adds (g h)^2 / 2 per kilogram and step. Damping and bounces remove more.
    assert all(b <= a + 1e-12 for a, b in itertools.pairwise(energies))


def test_a_burst_adds_the_energy_of_its_fragments_and_nothing_else() -> None:
    p = Particle(Vector3(1, 2, 3), Vector3(4, -5, 6), Vector3(0, -10, 0), mass=0.6)
    pieces = fragments(p)
    energy = math.fsum(piece.kinetic_energy() for piece in pieces)
    # König's theorem: the energy of the whole plus that of the relative motion, m 15^2 / 2.
    assert energy == pytest.approx(p.kinetic_energy() + 0.5 * 0.6 * 15.0**2, rel=1e-14)
    closest = min(
        math.dist(tuple(a.velocity), tuple(b.velocity))
        for i, a in enumerate(pieces)
        for b in pieces[:i]
    )
    # Neighboring corners of an icosahedron are 1.0515 radii apart.
    assert closest == pytest.approx(15.0 * 1.0514622, rel=1e-7)


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


@pytest.mark.parametrize(
    ("call", "error", "complaint"),
    [
        (lambda r: r.fire("cannon"), ValueError, "name must be one of pistol, artillery"),
        (lambda r: r.fire("pistol", NAN), ValueError, "azimuth must be finite, got nan"),
        (lambda r: r.fire("pistol", 0.0, INF), ValueError, "elevation must be finite, got inf"),
        (lambda r: r.fire("pistol", "up"), TypeError, "azimuth must be a number, got 'up'"),
        (lambda r: r.update(0.0), ValueError, "duration must be positive and finite, got 0.0"),
        (lambda r: r.update(NAN), ValueError, "duration must be positive and finite, got nan"),
        (lambda r: r.update("1"), TypeError, "duration must be a number, got '1'"),
        (lambda _: aim(-1.0, 0.0, 0.0), ValueError, "speed must be finite and not negative"),
        (lambda _: scaling.slowed_mass(1.0, 0.0), ValueError, "factor must be positive and finite"),
        (lambda _: scaling.muzzle_energy(NAN, 1.0), ValueError, "mass must be positive and finite"),
        (lambda _: scaling.slowed_gravity(INF, 1.0), ValueError, "gravity must be finite, got inf"),
        (
            lambda _: TargetBlock(Vector3(), (1.0, 0.0, 1.0), mass=1.0),
            ValueError,
            "size must be positive and finite, got 0.0",
        ),
        (
            lambda _: TargetBlock(Vector3(), (1.0, 1.0, 1.0), mass=0.0),
            ValueError,
            "mass must be positive, got 0.0",
        ),
    ],
)
def test_what_means_nothing_is_refused_by_name(
    call: Any, error: type[Exception], complaint: str
) -> None:
    at = BallisticRange()
    at.fire("pistol")
    with pytest.raises(error, match=complaint):
        call(at)
    (shot,) = at.shots
    assert (tuple(shot.particle.position), shot.age) == (MUZZLE, 0.0)


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
