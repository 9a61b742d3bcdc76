"""Collisions agree with their closed forms, and bodies at rest on the ground stay at rest."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import GroundPlane, ParticlePairs

FRAME = 1.0 / 60.0
ROUNDING = 2.0**-53
UP = Vector3(0.0, 1.0, 0.0)


def direction(a: float, b: float) -> Vector3:
    return Vector3(math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b))


turn = st.floats(0.0, 2.0 * math.pi)
normals = st.builds(direction, turn, turn)
masses = st.floats(0.01, 100.0)
velocities = st.builds(Vector3, *[st.floats(-50.0, 50.0)] * 3)
restitutions = st.sampled_from([0.0, 0.5, 1.0]) | st.floats(0.0, 1.0)


@pytest.mark.parametrize("off", [-0.9e-6, 0.0, 0.9e-6])
def test_a_normal_within_a_millionth_of_unit_length_is_taken_and_copied(off: float) -> None:
    normal = direction(0.3, 0.7) * (1.0 + off)
    contact = Contact(Particle(), None, normal)
    assert contact.normal == normal
    assert contact.normal is not normal


# Collisions


@given(masses, masses, velocities, velocities, normals, restitutions)
def test_any_collision_keeps_momentum_and_loses_what_the_closed_form_says(
    m: float, n: float, va: Vector3, vb: Vector3, normal: Vector3, c: float
) -> None:
    a, b = Particle(velocity=va, mass=m), Particle(velocity=vb, mass=n)
    closing = (va - vb).dot(normal)
    before = a.kinetic_energy() + b.kinetic_energy()
    Contact(a, b, normal, c).resolve_velocity()
    if closing >= 0.0:
        assert (a.velocity, b.velocity) == (va, vb)
        return
    # Each velocity is the sum of two numbers of at most 300 m/s with about 8 roundings. Multiplied
    # by the mass, this is the allowed error of the momentum.
    heavy = (m + n) * 300.0 * 8.0 * ROUNDING
    for axis in range(3):
        kept = m * tuple(va)[axis] + n * tuple(vb)[axis]
        now = m * tuple(a.velocity)[axis] + n * tuple(b.velocity)[axis]
        assert now == pytest.approx(kept, abs=heavy)
    # Velocity differences of 300 m/s have as many roundings, and so has the normal.
    slip = 300.0 * 24.0 * ROUNDING
    apart = a.velocity - b.velocity
    assert apart.dot(normal) == pytest.approx(-c * closing, abs=slip)
    for particle, first in ((a, va), (b, vb)):
        change = particle.velocity - first
        along = change.dot(normal)
        assert (change - normal * along).magnitude() <= slip  # no change along the surface
    reduced = m * n / (m + n)
    lost = before - a.kinetic_energy() - b.kinetic_energy()
    wanted = 0.5 * reduced * (1.0 - c * c) * closing**2
    # The error of an energy is m v times that of the velocity.
    assert lost == pytest.approx(wanted, abs=(m + n) * 300.0 * slip)


@given(masses, velocities, normals, restitutions, st.sampled_from(["none", "other", "particle"]))
def test_what_is_immovable_gives_all_of_the_change_to_its_partner(
    m: float, v: Vector3, normal: Vector3, c: float, wall: str
) -> None:
    ball, fixed = Particle(velocity=v, mass=m), Particle(mass=math.inf)
    if wall == "particle":  # seen from the ball, the normal is reversed
        Contact(fixed, ball, -normal, c).resolve_velocity()
    else:
        Contact(ball, fixed if wall == "other" else None, normal, c).resolve_velocity()
    closing = min(0.0, v.dot(normal))
    wanted = v - normal * ((1.0 + c) * closing)
    # The tolerance allows for some roundings of at most 87 m/s times two, on each axis.
    assert tuple(ball.velocity) == pytest.approx(tuple(wanted), abs=170.0 * 16.0 * ROUNDING)
    assert tuple(fixed.velocity) == (0.0, 0.0, 0.0)


def test_a_moving_wall_throws_twice_its_speed_back_and_is_not_slowed() -> None:
    ball, wall = Particle(velocity=Vector3(-3.0)), Particle(velocity=Vector3(2.0), mass=math.inf)
    Contact(ball, wall, Vector3(1.0), 1.0).resolve_velocity()
    assert (ball.velocity.x, wall.velocity.x) == (2.0 * 2.0 + 3.0, 2.0)


# Resolving penetrations


@given(masses, masses, normals, st.floats(1e-6, 10.0))
def test_the_depth_is_shared_by_inverse_mass(
    m: float, n: float, normal: Vector3, depth: float
) -> None:
    """The particles separate by the depth, their center stays, and the moves are returned."""
    a, b = Particle(Vector3(1.0, 2.0, 3.0), mass=m), Particle(mass=n)
    contact = Contact(a, b, normal, 0.5, depth)
    moves = contact.resolve_penetration()
    assert contact.penetration == 0.0
    off = (10.0 + 4.0) * 16.0 * ROUNDING  # for depths up to 10 m and positions up to 4 m
    for particle, place, move, share in (
        (a, Vector3(1.0, 2.0, 3.0), moves[0], n / (m + n)),
        (b, Vector3(), moves[1], -m / (m + n)),
    ):
        assert tuple(move) == pytest.approx(tuple(normal * (depth * share)), abs=off)
        assert tuple(particle.position) == pytest.approx(tuple(place + move), abs=off)
    assert tuple(moves[0] * m + moves[1] * n) == pytest.approx((0.0, 0.0, 0.0), abs=off * (m + n))
    assert contact.resolve_penetration() == (Vector3(), Vector3())


# Rest


def fall(
    step: Integrator, height: float, c: float, frames: int, *, built_in: bool, g: float = 9.81
) -> list[float]:
    """Return the height of a ball over level ground after every frame."""
    ball = Particle(Vector3(0.0, height), acceleration=UP * (-g if built_in else 0.0))
    registry, resolver = ForceRegistry(), ContactResolver()
    if not built_in:
        registry.add(ball, Gravity(UP * -g))
    ground, heights = GroundPlane([ball], restitution=c), []
    for _ in range(frames):
        step([ball], registry.update_forces, FRAME)
        resolver.resolve_contacts(ground.contacts(), FRAME)
        heights.append(ball.position.y)
    return heights


@pytest.mark.parametrize("built_in", [True, False])
@pytest.mark.parametrize("c", [0.0, 0.9])
@pytest.mark.parametrize("height", [1e-6, 5e-4])
def test_what_rests_moves_less_than_a_millimeter_in_a_minute(
    c: float, height: float, built_in: bool
) -> None:
    """The first frame closes with g h at most, so the ball is stopped, corrected, and stays."""
    heights = fall(semi_implicit_euler, height, c, 3600, built_in=built_in)
    # Each frame corrects the depth, with an error of one rounding of g h^2 = 3 mm.
    assert max(abs(y) for y in heights) <= 1e-18
    assert max(abs(y - height) for y in heights) < 1e-3


@pytest.mark.parametrize(("c", "left"), [(0.5, 1.36e-3), (0.9, 2.70e-3)])
def test_the_book_s_step_leaves_a_jitter_of_millimeters(c: float, left: float) -> None:
    """Released 1e-6 m above the ground, the first bounces reach g h^2 c with g = 9.81 m/s^2.

    Explicit Euler misses the contact in the first frame, so the ball arrives with the speed of two
    frames, and the rule removes the speed of one.
    """
    heights = fall(explicit_euler, 1e-6, c, 3600, built_in=True)
    assert max(heights) == pytest.approx(left, rel=0.01)  # three digits are known
    # The ball leaves with c g h and is back within two frames, again and again.
    assert max(heights[-600:]) > 0.3 * left
    assert max(fall(explicit_euler, 0.0, c, 600, built_in=True)) == 0.0  # exactly on the ground


def test_a_ball_that_falls_from_a_height_comes_to_rest() -> None:
    """Above a millimeter the rule lets the ball bounce, to about c^2 of the height."""
    heights = fall(semi_implicit_euler, 1.0, 0.5, 600, built_in=False)
    low = heights.index(min(heights[:40]))
    # The ball leaves with c (v - g h), which is 1/27 less and costs 8 % of the height. The step,
    # velocity first, costs another v h / 2, or 18 mm of 250.
    assert max(heights[low:]) == pytest.approx(0.25, rel=0.16)
    assert max(map(abs, heights[-300:])) < 1e-15


def test_two_balls_at_rest_on_each_other_stay() -> None:
    """Four iterations almost end the exchange of velocities between the two contacts."""
    balls = [Particle(Vector3(0.0, y), acceleration=UP * -9.81) for y in (0.5, 1.5)]
    ground, pairs = GroundPlane(balls, radius=0.5), ParticlePairs(balls, 0.5)
    resolver = ContactResolver()
    for _ in range(3600):
        semi_implicit_euler(balls, lambda _: None, FRAME)
        resolver.resolve_contacts(ground.contacts() + pairs.contacts(), FRAME)
        # Twice the fall in a frame, which is 2.7 mm.
        wanted = pytest.approx([0.5, 1.5], abs=2.0 * 9.81 * FRAME**2)
        assert [ball.position.y for ball in balls] == wanted
