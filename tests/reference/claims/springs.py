"""Claims of chapter 6: springs, water, and springs too stiff for the step."""

from __future__ import annotations

import cmath
import math

import numpy

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator, ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import Integrator, explicit_euler, semi_implicit_euler
from ch06_springs.penalty import PenaltyGround
from ch06_springs.springs import AnchoredSpring, FakeStiffSpring
from reference.claims.ledger import claim

FRAME = 1.0 / 60.0
DOWN = Vector3(0.0, -9.81)


def after(
    step: Integrator,
    force: ForceGenerator,
    steps: int,
    h: float = FRAME,
    x: float = 1.0,
    v: float = 0.0,
) -> tuple[float, float]:
    """Return the position and velocity of 1 kg on the X axis after some steps."""
    particle, registry = Particle(Vector3(x), Vector3(v)), ForceRegistry()
    registry.add(particle, force)
    for _ in range(steps):
        step([particle], registry.update_forces, h)
    return particle.position.x, particle.velocity.x


def eigenvalue(step: Integrator, force: ForceGenerator) -> complex:
    """Return the eigenvalue of one step in the upper half plane: its growth and its angle."""
    columns = [after(step, force, 1, x=1.0), after(step, force, 1, x=0.0, v=1.0)]
    return complex(max(numpy.linalg.eigvals(numpy.transpose(columns)), key=lambda q: q.imag))


def spring(stiffness: float) -> AnchoredSpring:
    return AnchoredSpring(Vector3(), stiffness, 0.0)


def growth(stiffness: float, steps: int, h: float = FRAME) -> float:
    """Return how many times as much energy a spring has after some of the book's steps."""
    x, v = after(explicit_euler, spring(stiffness), steps, h)
    return x * x + v * v / stiffness


@claim("fails", "A soft spring behaves normally, but is slightly stiffer")
def soft_spring() -> list[str]:
    grown, own = growth(10.0, 3600), math.sqrt(10.0) * FRAME
    slow, fast = (
        100.0 * (cmath.phase(eigenvalue(step, spring(10.0))) / own - 1.0)
        for step in (explicit_euler, semi_implicit_euler)
    )
    assert grown > 1.0
    assert slow < 0.0 < fast
    return [
        f"by a factor of {grown:,.0f}. The",
        f"slowly, by {-slow:.2f} %",
        f"too fast, by {fast:.3f} %",
    ]


@claim("holds", "A spring that is too stiff for the time step explodes")
def stiff_spring() -> list[str]:
    below, above = (abs(eigenvalue(semi_implicit_euler, spring(k))) for k in (14_300.0, 14_500.0))
    assert math.isclose(below, 1.0, rel_tol=1e-9)
    assert above > 1.0
    grown = abs(eigenvalue(explicit_euler, spring(10_000.0)))
    assert math.isclose(grown**2, 1.0 + 10_000.0 * FRAME**2, rel_tol=1e-12)
    return [f"10 to the power of {math.floor(60.0 * math.log10(grown))}"]


@claim("fails", "Several smaller updates in each frame do not help much")
def substeps() -> list[str]:
    one, four = (4.0 * (60.0 * count) ** 2 for count in (1, 4))
    for limit, h in ((one, FRAME), (four, FRAME / 4)):
        for factor, holds in ((0.99, True), (1.01, False)):
            x, _ = after(semi_implicit_euler, spring(factor * limit), 600, h)
            assert (abs(x) < 100.0) is holds
    grown = [growth(100.0, 600 * count, FRAME / count) for count in (1, 4, 16)]
    assert grown[0] > 1e4 * grown[1]
    return [
        f"{four / one:.0f} times as stiff: {four:,.0f} instead of {one:,.0f} N/m",
        f"within 10 s by {grown[0]:.1e} with one step per frame, by {grown[1]:.0f} with four",
        f"by {grown[2]:.1f} with 16",
    ]


@claim("holds if", "A faked spring puts the particle where the real spring would")
def faked_spring() -> list[str]:
    fake, errors = FakeStiffSpring(Vector3(), 400.0, 0.0), []
    for steps in (1, 10):
        x, _ = after(semi_implicit_euler, fake, steps)
        errors.append(abs(x - math.cos(20.0 * steps * FRAME)))
    assert errors[0] < 1e-12
    return [f"wrong by {errors[1]:.2f} of the amplitude"]


@claim("fails", "A faked spring is sometimes stiffer and sometimes looser")
def stiffness_of_a_fake() -> list[str]:
    slower = []
    for stiffness in (1.0, 100.0, 3600.0):
        fake = FakeStiffSpring(Vector3(), stiffness, 0.0)
        angle = math.sqrt(stiffness) * FRAME
        slower.append(angle / cmath.phase(eigenvalue(semi_implicit_euler, fake)))
    assert min(slower) > 1.3
    return [f"it swings {slower[0]:.2f} times too", f"and {slower[2]:.2f} times too"]


@claim("fails", "With damping and an anchor at rest, a faked spring never gains speed")
def damped_fake() -> list[str]:
    fake = FakeStiffSpring(Vector3(), 400.0, 1.0)
    widest, calm = (
        max(abs(after(step, fake, n)[0]) for n in range(280, 301))
        for step in (explicit_euler, semi_implicit_euler)
    )
    assert calm < 1.0 < 10.0 < widest
    return [f"amplitude is {widest:.0f} times", f"fallen to {calm:.2f} of"]


@claim("holds", "A faked spring is wrong when other forces act too")
def fake_and_gravity() -> list[str]:
    real, weight, registry = 9.81 / 1000.0, Particle(), ForceRegistry()
    registry.add(weight, FakeStiffSpring(Vector3(), 1000.0, 20.0))
    registry.add(weight, Gravity(DOWN))
    for _ in range(1200):
        semi_implicit_euler([weight], registry.update_forces, FRAME)
    sag = -weight.position.y
    assert abs(weight.velocity.y) < 1e-9
    assert abs(sag / real - 1.0) > 0.1
    return [f"By {sag * 1000:.1f} mm, which is {sag / real:.2f} times as far"]


@claim("holds if", "The water carries a body in proportion to the depth")
def buoyancy() -> list[str]:
    depth = 0.5  # of a ball of radius 1
    heights = numpy.linspace(-1.0, -1.0 + depth, 200_001)
    cap = numpy.trapezoid(math.pi * (1.0 - heights**2), heights) / (4.0 / 3.0 * math.pi)
    assert math.isclose(cap, depth**2 * (3.0 - depth) / 4.0, rel_tol=1e-8)
    assert cap < 0.2
    return [f"Only {100.0 * cap:.1f} % of"]


@claim("holds", "Collisions by stiff springs are spongy, or they explode")
def penalty_ground() -> list[str]:
    deep, high = [], []
    for stiffness in (500.0, 50_000.0):
        ball, registry = Particle(Vector3(0.0, 1.0), acceleration=DOWN), ForceRegistry()
        registry.add(ball, PenaltyGround(0.0, stiffness))
        heights = []
        for _ in range(180):
            semi_implicit_euler([ball], registry.update_forces, FRAME)
            heights.append(ball.position.y)
        deep.append(-min(heights))
        high.append(max(heights))
    assert deep[0] > 0.1
    assert high[1] > 2.0
    return [f"sinks in by {deep[0] * 100:.0f} cm", f"climbs to {high[1]:.0f} m within 3 s"]
