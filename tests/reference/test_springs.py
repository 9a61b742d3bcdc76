"""Chapter 6's generators against closed forms, SciPy's figures and conservation laws."""

from __future__ import annotations

import math

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator, ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, runge_kutta_4, velocity_verlet
from ch06_springs.springs import (
    AnchoredBungee,
    Bungee,
    Buoyancy,
    ElasticLimitSpring,
    HomingBullet,
    LighterThanAir,
    Overcrowding,
    connect,
)

FRAME = 1.0 / 60.0
GRAVITY = Vector3(0.0, -10.0, 0.0)


def registry_of(*pairs: tuple[Particle, ForceGenerator]) -> ForceRegistry:
    registry = ForceRegistry()
    for particle, generator in pairs:
        registry.add(particle, generator)
    return registry


def run(
    particles: list[Particle],
    registry: ForceRegistry,
    time: float,
    steps: int,
    step: Integrator = runge_kutta_4,
) -> None:
    for _ in range(steps):
        step(particles, registry.update_forces, time / steps)


def momentum(particles: list[Particle]) -> list[float]:
    """Return the sum of m v on each axis, added without rounding."""
    return [math.fsum(tuple(p.momentum())[axis] for p in particles) for axis in range(3)]


# Springs between two ends


UP = Vector3(0.0, 1.0, 0.0)
JUMP = (Vector3(0.5), Vector3(1.0))


@pytest.mark.parametrize(
    ("damping", "end"),
    [
        (0.0, (-1.7418225184467868, -5.198362149391038, 9.344971003139815, -3.60336010371746)),
        (3.0, (0.11569293131201239, -5.696811999759349, 3.8601764159903738, -1.2865604494233007)),
    ],
)
@pytest.mark.parametrize("kind", [AnchoredBungee, Bungee])
def test_a_jump_on_a_bungee_ends_where_scipy_has_it(
    kind: type[Bungee] | type[AnchoredBungee], damping: float, end: tuple[float, ...]
) -> None:
    """The rope is slack, taut, slack and taut again within 4 s, in the plane.

    The end states are SciPy's: solve_ivp, DOP853, rtol 1e-12, with an event whenever the rope
    becomes taut or slack. k is 40 N/m, the rope 5 m, the mass 2 kg, and g 10 m/s^2.
    """
    hook = Vector3() if kind is AnchoredBungee else Particle(mass=math.inf)
    rope = kind(hook, 40.0, 5.0, damping)  # type: ignore[arg-type]
    jumper = Particle(*JUMP, GRAVITY, mass=2.0)
    run([jumper], registry_of((jumper, rope)), 4.0, 8000)
    p, v = jumper.position, jumper.velocity
    # A frame h = 5e-4 across a kink of the force has an error of about k h^3 v / m, because the
    # kinks do not fall on frames: 1e-6 after three of them. With damping they are jumps of up to
    # c v / m = 15 m/s^2, each for part of a frame: at most 15 h = 7e-3, and less on average.
    assert (p.x, p.y, v.x, v.y) == pytest.approx(end, abs=1e-3 if damping else 5e-6)


def test_a_spring_with_a_limit_of_elasticity_keeps_its_energy() -> None:
    """The energy is the area under the force: k e^2 / 2, with a softer slope beyond the limit."""

    def stored(length: float) -> float:
        within, beyond = min(length, 3.0) - 1.0, max(length - 3.0, 0.0)
        return 0.5 * 50.0 * within**2 + 50.0 * beyond * (2.0 + 0.2 * beyond / 2.0)

    hook, body = Particle(mass=math.inf), Particle(Vector3(5.0), UP, mass=2.0)
    registry = registry_of((body, ElasticLimitSpring(hook, 50.0, 1.0, 3.0, 0.2)))
    assert stored(5.0) == 320.0  # 100 J up to the limit, 200 and 20 J beyond it
    lengths = []
    for _ in range(2000):
        velocity_verlet([body], registry.update_forces, 0.0005)
        length = body.position.magnitude()
        lengths.append(length)
        # A fraction (w h)^2 / 4 of it oscillates, 2e-6 with w = 5 and 18 m/s, and there is a kink.
        # Near the hook it rotates at 50 rad/s, where (50 h)^2 / 4 of it oscillates.
        assert body.kinetic_energy() + stored(length) == pytest.approx(321.0, rel=2e-4)
    assert min(lengths) < 1.0 < 3.0 < max(lengths)


# Water and air


@pytest.mark.parametrize(("mass", "height"), [(0.5, 0.0), (0.3, 0.02), (0.9, -0.04)])
def test_a_body_floats_at_the_height_of_archimedes(mass: float, height: float) -> None:
    """Nothing moves at y_w + s (1 - 2 m / (rho V)), with 1 liter, s = 0.05 m and y_w = 2 m."""
    boat = Particle(Vector3(0.0, 2.0 + height, 0.0), acceleration=GRAVITY, mass=mass)
    registry = registry_of((boat, Buoyancy(0.05, 0.001, 2.0, gravity=10.0)))
    run([boat], registry, 5.0, 300)
    # A rounding of 2 m is 4e-16, and the lift turns a meter into up to 330 m/s^2.
    assert boat.position.y == pytest.approx(2.0 + height, abs=1e-12)


def test_a_balloon_hovers_where_its_lift_is_its_weight_and_bobs_about_it() -> None:
    """It hovers at H ln(F / (m g)). The lift falls by m g / H per meter: T = 2 pi sqrt(H / g)."""
    middle = 800.0 * math.log(60.0 / (2.0 * 10.0))
    balloon = Particle(Vector3(0.0, middle, 0.0), acceleration=GRAVITY, mass=2.0)
    registry = registry_of((balloon, LighterThanAir(60.0, 800.0)))
    run([balloon], registry, 20.0, 100)
    assert balloon.position.y == pytest.approx(middle, abs=1e-10)  # a rounding or two of 880 m
    balloon.position.y += 0.08
    run([balloon], registry, 2.0 * math.pi * math.sqrt(80.0), 200)
    # At 1e-4 of H the period is longer by 1e-8 / 24, and the force is nonlinear by 1e-4.
    assert balloon.position.y == pytest.approx(middle + 0.08, abs=1e-7)
    assert balloon.velocity.y == pytest.approx(0.0, abs=1e-8)


# A crowd, and a bullet


def test_two_that_are_too_near_part_as_a_spring_that_is_let_go() -> None:
    """The gap is d - (d - l) cos w t for a quarter period, with w^2 = k / mu. Then they coast."""
    crowd = [Particle(Vector3(0.2)), Particle(Vector3(-0.3), mass=3.0)]
    pushing = Overcrowding(crowd, 2.0, 12.0)
    registry = registry_of(*((one, pushing) for one in crowd))
    quarter = math.pi / 2.0 / 4.0  # w = sqrt(12 / 0.75) = 4 per second
    # The cosine is followed with order 4. The last step ends within 1e-9 m of the distance.
    for time, gap in ((quarter / 2.0, 2.0 - 1.5 * math.sqrt(0.5)), (quarter / 2.0, 2.0)):
        run(crowd, registry, time, 200)
        assert crowd[0].position.x - crowd[1].position.x == pytest.approx(gap, abs=1e-8)
    run(crowd, registry, 3.0, 200)
    gap = 2.0 + 1.5 * 4.0 * 3.0
    assert crowd[0].position.x - crowd[1].position.x == pytest.approx(gap, abs=1e-6)
    assert momentum(crowd) == pytest.approx([0.0, 0.0, 0.0], abs=1e-13)  # some roundings of 4.5


def test_a_bullet_s_way_to_a_steady_target_is_a_damped_spring_s() -> None:
    """Seen from the target, m r'' = -k (r + L r'), which is critical with L = 2 sqrt(m / k).

    So r = (r0 + (v0 + w r0) t) e^(-w t) with w = sqrt(k / m) = 2. It hits without overshooting.
    """
    target = Particle(Vector3(30.0, 5.0, -10.0), Vector3(-3.0, 1.0, 2.0))
    bullet = Particle(velocity=Vector3(40.0, 0.0, 0.0), mass=0.5)
    registry = registry_of((bullet, HomingBullet(target, 2.0, 1.0)))
    apart, speed = (-30.0, -5.0, 10.0), (43.0, -1.0, -2.0)
    for t in (1.0, 2.0, 12.0):
        run([bullet, target], registry, 1.0 if t < 12.0 else 10.0, 200)
        wanted = [
            (r + (v + 2.0 * r) * t) * math.exp(-2.0 * t) for r, v in zip(apart, speed, strict=True)
        ]
        # Order 4 with w h of 0.1 at most, over 30 m at most: 1e-4 / 120 of it, and decaying.
        assert tuple(bullet.position - target.position) == pytest.approx(wanted, abs=1e-5)
    assert bullet.position.x == pytest.approx(-6.0, abs=1e-5)
    assert tuple(target.velocity) == (-3.0, 1.0, 2.0)


def test_a_connection_of_ends_next_to_each_other_pushes_as_a_spring_does() -> None:
    """At a distance of 1e-310 m the force per meter would overflow, but the force does not."""
    a, b = Particle(Vector3(1e-310)), Particle()
    connect(ForceRegistry(), a, b, 100.0, 2.0).update_force(a, FRAME)
    # Numbers as small as 1e-310 have 14 digits.
    assert a.force_accumulator.x == pytest.approx(200.0, rel=1e-12)
    assert b.force_accumulator == -a.force_accumulator
