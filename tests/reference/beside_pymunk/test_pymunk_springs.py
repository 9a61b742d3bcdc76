"""Compare pymunk's DampedSpring with our springs.

Its frame is semi-implicit Euler with the move first. Then it multiplies the velocity along the
spring by e^(-c h / m), as our Particle.damping does with d = e^(-c / m).
"""

from __future__ import annotations

import math

import pymunk
import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.closed_form import damped_spring_state
from ch06_springs.integrators import semi_implicit_euler
from ch06_springs.springs import AnchoredSpring

FRAME = 1.0 / 60.0
State = tuple[float, float]


def theirs(k: float, c: float, m: float, h: float, n: int) -> list[State]:
    """Return x and v of a body after every frame. It starts 1 m from the spring's other end."""
    space = pymunk.Space()
    body = pymunk.Body(m, 1.0)
    body.position = (1.0, 0.0)
    space.add(body)
    space.add(pymunk.DampedSpring(body, space.static_body, (0, 0), (0, 0), 0.0, k, c))
    seen = []
    for _ in range(n):
        space.step(h)
        seen.append((body.position.x, body.velocity.x))
    return seen


def ours(particle: Particle, k: float, h: float, n: int) -> list[State]:
    registry = ForceRegistry()
    registry.add(particle, AnchoredSpring(Vector3(), k, 0.0))
    seen = []
    for _ in range(n):
        semi_implicit_euler([particle], registry.update_forces, h)
        seen.append((particle.position.x, particle.velocity.x))
    return seen


SPRINGS = [(100.0, 0.0, 1.0), (100.0, 2.0, 1.0), (100.0, 2.0, 2.5), (30.0, 50.0, 1.0)]


@pytest.mark.parametrize(("k", "c", "m"), SPRINGS)
@pytest.mark.parametrize("h", [FRAME, 1.0 / 240.0])
def test_their_spring_is_our_semi_implicit_step_with_the_move_first(
    k: float, c: float, m: float, h: float
) -> None:
    """Ours begins after the first move, so its n-th velocity and position are pymunk's."""
    n = round(5.0 / h)
    first = Particle(Vector3(1.0), mass=m, damping=math.exp(-c / m))
    mine = ours(first, k, h, n)
    their_places, their_speeds = zip(*theirs(k, c, m, h, n + 1), strict=True)
    # 1200 frames, each with some roundings of 1 m and of 10 m/s, which do not grow.
    assert [x for x, _ in mine] == pytest.approx(list(their_places[1:]), abs=1e-11)
    assert [v for _, v in mine] == pytest.approx(list(their_speeds[:-1]), abs=1e-10)


def test_their_spring_only_seems_to_lose_energy() -> None:
    """With k = 100 at 60 Hz, the energy is x 0.94 after 10 s, and always between x 0.92 and x 1.09.

    The step conserves v^2 + k x^2 + k h x v, which a move and a push leave unchanged.
    """
    states = theirs(100.0, 0.0, 1.0, FRAME, 20_000)
    shares = [(v * v + 100.0 * x * x) / 100.0 for x, v in states]
    assert shares[599] == pytest.approx(0.94, abs=5e-3)  # two digits are known
    # x v h / 2 oscillates by up to k h / 2 w = 1 / 12 of the conserved value.
    assert 0.92 < min(shares[:600]) < 0.93
    assert 1.09 < max(shares[:600]) < 1.095
    assert min(shares[-600:]) == pytest.approx(min(shares[:600]), abs=1e-4)
    assert max(shares[-600:]) == pytest.approx(max(shares[:600]), abs=1e-4)
    kept = [v * v + 100.0 * x * x + 100.0 * FRAME * x * v for x, v in states]
    assert kept == pytest.approx([100.0] * len(kept), rel=1e-10)  # 20,000 roundings


@pytest.mark.parametrize(("k", "c", "time"), [(100.0, 2.0, 0.5), (1e6, 200.0, 0.005)])
def test_both_come_to_the_closed_form_as_frames_grow_short(k: float, c: float, time: float) -> None:
    """Both have order 1 with opposite errors, so half the frame gives half the error."""
    wanted = damped_spring_state(1.0, 0.0, k, c, 1.0, time)[0]
    gaps: list[list[float]] = [[], []]
    for n in (1000, 2000, 4000):
        h = time / n
        particle = Particle(Vector3(1.0), damping=math.exp(-c))
        gaps[0].append(theirs(k, c, 1.0, h, n)[-1][0] - wanted)
        gaps[1].append(ours(particle, k, h, n)[-1][0] - wanted)
    for one, two, four in gaps:
        assert one / two == pytest.approx(2.0, abs=0.01)
        assert two / four == pytest.approx(2.0, abs=0.01)
    assert abs(gaps[0][2]) < 1e-3 > abs(gaps[1][2])
    assert gaps[0][2] * gaps[1][2] < 0.0
