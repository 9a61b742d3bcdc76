"""The rope bridge and the tilting platform against SciPy and geometry."""

from __future__ import annotations

import math

import pytest

from ch08_mass_aggregate.bridge import Bridge
from ch08_mass_aggregate.tilting_platform import TiltingPlatform
from ch08_mass_aggregate.world import mechanical_energy

FRAME = 1.0 / 60.0
G = 9.81
# The minimum of the potential energy of one side of the bridge, limited by the cables' lengths. It
# was found with SciPy's minimize, SLSQP, ftol 1e-13, as the best of 20 starts. All 11 cables are
# taut there, also with a ball in the middle. They also go 0.2 m sideways, from z 1 to z 0.8.
HALF = [(0.95, 2.007820), (2.772244, 2.545803), (4.572245, 3.154078)]
HANGS = [(-x, y) for x, y in reversed(HALF)] + HALF


def come_to_rest(scene: Bridge | TiltingPlatform, seconds: float) -> None:
    """Run a scene, which never has more energy than at first, and rests for the last 5 s."""
    start, energies = mechanical_energy(scene.world.particles), []
    for _ in range(round(seconds * 60)):
        scene.step(FRAME)
        energies.append(mechanical_energy(scene.world.particles))
    assert all(map(math.isfinite, energies))
    # The first frame already loses energy, so no rounding has to be allowed for.
    assert max(energies) < start
    last = energies[-5 * 60 :]
    assert max(last) - min(last) < 1e-3 * abs(last[-1])


@pytest.mark.parametrize(
    ("x", "height", "near"),
    [(20.0, 0.5, 1e-3), (0.0, HANGS[2][1] + 0.5, 0.03)],
    ids=["beside", "on"],
)
def test_a_bridge_hangs_where_scipy_has_it(x: float, height: float, near: float) -> None:
    """With the ball beside it, a rest of 0.5 mm was measured. With it on the deck, all sways."""
    bridge = Bridge(x=x)
    for _ in range(8 * 60):
        bridge.step(FRAME)
    for ends, (along, y) in zip(bridge.rows, HANGS, strict=True):
        for end, z in zip(ends, (-1.0, 1.0), strict=True):
            assert tuple(end.position) == pytest.approx((along, y, z), abs=near)
    assert bridge.ball.position.y == pytest.approx(height, abs=G * FRAME**2)


@pytest.mark.parametrize(
    ("mass", "low", "high", "side"), [(0.0, 4, 2, 1.0), (3.0, 2, 4, -1.0)], ids=["alone", "tipped"]
)
def test_a_platform_comes_to_rest_where_geometry_says(
    mass: float, low: int, high: int, side: float
) -> None:
    """One end lies on the ground, and the other is 2.36 rad around."""
    platform, arms = TiltingPlatform(), {2: math.hypot(3.0, 2.0), 4: math.hypot(4.0, 2.0)}
    platform.put_weight(mass, -3.0)
    come_to_rest(platform, 12.0)
    for rod in platform.rods:
        length = (rod.b.position - rod.a.position).magnitude()
        assert length == pytest.approx(rod.length, rel=1e-4)  # 1e-5 was measured at 30 Hz
    angle = math.atan2(2.0, -3.0) - math.atan2(2.0, 4.0)
    for end, x, y in ((low, 1.0, 0.0), (high, math.cos(angle), math.sin(angle))):
        position, wanted = platform.particles[end].position, (side * arms[end] * x, arms[end] * y)
        assert (position.x, position.y) == pytest.approx(wanted, abs=3e-3)
