"""Claims of chapters 2 to 5: vectors, steps, damping, scaling and forces."""

from __future__ import annotations

import math
import random
import sys
from types import FrameType

from ch02_vectors.vector import Vector3
from ch04_particle_engine.scaling import muzzle_energy, slowed_mass
from ch05_forces.forces import Drag, ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import explicit_euler, semi_implicit_euler
from ch06_springs.springs import AnchoredSpring
from reference.claims.ledger import claim

G = 9.81
DOWN = Vector3(0.0, -G)
FRAME = 1.0 / 60.0


def integrated(particle: Particle, steps: int, h: float = FRAME) -> Particle:
    for _ in range(steps):
        particle.integrate(h)
    return particle


@claim("holds if", "To compare two lengths, you can compare their squares")
def squares_compare() -> list[str]:
    rng = random.Random(1)
    for _ in range(1000):
        a, b = (Vector3(*(rng.uniform(-1e3, 1e3) for _ in range(3))) for _ in "ab")
        longer = math.dist((0, 0, 0), tuple(a)) > math.dist((0, 0, 0), tuple(b))
        assert (a.squared_magnitude() > b.squared_magnitude()) is longer
    assert Vector3(1e200).squared_magnitude() == math.inf
    assert Vector3(1e-200).squared_magnitude() == 0.0
    return []


@claim("fails", "Two vectors are parallel if their vector product is exactly zero")
def parallel_products() -> list[str]:
    rng, products = random.Random(1), []
    for _ in range(1000):
        v = Vector3(*(rng.uniform(-1, 1) for _ in range(3)))
        products.append(v.cross(v * rng.uniform(-10, 10)).magnitude())
    assert max(products) < 1e-14  # ten times the rounding error of products up to 10
    return [f"zero for only {products.count(0.0)} of the 1,000 pairs"]


@claim("holds if", "p + v t + a t²/2 gives the position after any time t")
def constant_acceleration() -> list[str]:
    thrown = 30.0 * 5.0 - G * 5.0**2 / 2.0
    assert math.isclose(
        thrown, (30.0 + 30.0 - G * 5.0) / 2.0 * 5.0
    )  # the mean speed times the time
    exact, swung = math.cos(math.pi), 1.0 - (2.0 * math.pi * 0.5) ** 2 / 2.0
    assert abs(swung - exact) > 2.0
    return [f"at {thrown:.2f} m if", f"be at {exact:.0f} m. The formula puts it at {swung:.2f} m"]


@claim("holds if", "A negative acceleration slows a body down")
def negative_acceleration() -> list[str]:
    ball = Particle(velocity=Vector3(0.0, 5.0), acceleration=DOWN)
    rising, falling = (integrated(ball, steps).velocity.magnitude() for steps in (15, 60))
    assert math.isclose(rising, 5.0 - G * 0.25, rel_tol=1e-12)
    assert math.isclose(falling, G * 1.25 - 5.0, rel_tol=1e-12)
    assert rising < 5.0 < falling
    return [f"rises, at {rising:.1f} m/s", f"falls at {falling:.1f} m/s"]


@claim("holds if", "You can leave out the term a h²/2")
def without_the_term() -> list[str]:
    errors = []
    for seconds in (1, 2):
        stone = integrated(Particle(acceleration=DOWN), 60 * seconds)
        errors.append(stone.position.y + G * seconds**2 / 2.0)
        assert math.isclose(errors[-1], G * seconds * FRAME / 2.0, rel_tol=1e-9)
    return [
        f"is {errors[0] * 100:.1f} cm too high after one second and {errors[1] * 100:.1f} cm",
        f"step is only {G * FRAME**2 / 2.0 * 1000:.1f} mm",
    ]


@claim("holds if", "With damping per second, the speed that is left")
def damping_per_second() -> list[str]:
    left = {}
    for rate in (30, 120):
        coasting = integrated(Particle(velocity=Vector3(1.0), damping=0.9), rate, 1.0 / rate)
        falling = integrated(Particle(acceleration=DOWN, damping=0.9), rate, 1.0 / rate)
        assert math.isclose(coasting.velocity.x, 0.9, rel_tol=1e-12)
        left[rate] = 100.0 * 0.99**rate, -falling.velocity.y, coasting.position.x
    falls = 100.0 * abs(left[30][1] / left[120][1] - 1.0)
    farther = 100.0 * (left[30][2] / left[120][2] - 1.0)
    assert 0.01 < falls < farther < 1.0
    return [
        f"{left[30][0]:.0f} % is left at 30 frames per second and {left[120][0]:.0f} % at 120",
        f"differs by {falls:.1f} % between",
        f"comes {farther:.1f} % farther",
    ]


@claim("holds if", "A damping slightly below 1 removes the energy")
def damping_against_energy() -> list[str]:
    limit = (0.999**-FRAME - 1.0) / FRAME**2
    left = []
    for stiffness in (0.5 * limit, 2.0 * limit):
        ball, registry = Particle(Vector3(1.0), damping=0.999), ForceRegistry()
        registry.add(ball, AnchoredSpring(Vector3(), stiffness, 0.0))
        for _ in range(60_000):
            explicit_euler([ball], registry.update_forces, FRAME)
        left.append(2.0 * ball.kinetic_energy() / stiffness + ball.position.x**2)
    thrown = Particle(velocity=Vector3(0.0, 20.0), acceleration=DOWN, damping=0.999)
    gained = integrated(thrown, 240).kinetic_energy() + G * thrown.position.y
    assert left[0] < 1.0 < left[1]
    assert gained > 200.0
    return [
        f"to {limit:.2f} N/m. A",
        f"keeps {100.0 * left[0]:.0f} % of its",
        f"by a factor of {left[1]:.1f}. Under",
        f"has {gained:.1f} J per kg",
    ]


@claim("holds if", "A game can treat gravity as a constant acceleration")
def constant_gravity() -> list[str]:
    radius = 6371.0  # km, the mean radius of the Earth
    height = radius * (1.0 / math.sqrt(0.99) - 1.0)
    assert height > 30.0
    orbit = (radius / (radius + 400.0)) ** 2
    return [f"At {height:.0f} km", f"has {100.0 * orbit:.0f} % of"]


@claim("holds if", "A slow bullet hits as hard as a fast one")
def slow_bullets() -> list[str]:
    mass = slowed_mass(0.005, 20.0)
    assert math.isclose(muzzle_energy(mass, 25.0), muzzle_energy(0.005, 500.0), rel_tol=1e-12)
    fast, slow = 0.005 * 500.0 / 10.005, mass * 25.0 / (10.0 + mass)
    assert slow > 10.0 * fast
    return [
        f"have {muzzle_energy(mass, 25.0):.0f} J",
        f"at {slow:.1f} m/s instead of {fast:.2f} m/s",
    ]


@claim("fails", "A bullet that is slowed by a factor s follows the old path")
def slow_gravity() -> list[str]:
    real, printed, right = (
        g * (100.0 / speed) ** 2 / 2.0
        for g, speed in ((10.0, 500.0), (10.0 / 20.0, 25.0), (10.0 / 20.0**2, 25.0))
    )
    assert math.isclose(real, right, rel_tol=1e-12)
    assert printed > 10.0 * real
    return [f"by {real:.1f} m. With", f"by {printed:.0f} m, and", f"by 20² by {right:.1f} m"]


@claim("holds", "Gravity should stay in the particle")
def built_in_gravity() -> list[str]:
    calls, ends = [], []
    for acceleration in (DOWN, None):
        registry = ForceRegistry()
        particles = [Particle(acceleration=acceleration, mass=3.0) for _ in range(100)]
        for particle in particles if acceleration is None else []:
            registry.add(particle, Gravity(DOWN))
        calls.append(0)

        def seen(_: FrameType, event: str, __: object) -> None:
            calls[-1] += event == "call"

        sys.setprofile(seen)
        try:
            semi_implicit_euler(particles, registry.update_forces, FRAME)
        finally:
            sys.setprofile(None)
        for _ in range(59):
            semi_implicit_euler(particles, registry.update_forces, FRAME)
        ends.append(particles[0].position.y)
    assert calls[1] > calls[0]
    assert math.isclose(*ends, rel_tol=1e-12)
    return [f"call {calls[1] / calls[0]:.1f} times as"]


@claim("holds if", "The damping of the particle can stand in for drag")
def damping_for_drag() -> list[str]:
    wrong = []
    for drag in (Drag(0.2, 0.0), Drag(0.0, 0.02)):
        body, registry, speeds = Particle(velocity=Vector3(20.0)), ForceRegistry(), [20.0]
        registry.add(body, drag)
        for _ in range(10_000):
            semi_implicit_euler([body], registry.update_forces, 1e-3)
            speeds.append(body.velocity.x)
        wrong.append(20.0 * (speeds[1000] / 20.0) ** 10 / speeds[-1] - 1.0)
    assert abs(wrong[0]) < 1e-6
    assert wrong[1] < -0.5
    return [f"too slow by {-100.0 * wrong[1]:.0f} % after"]
