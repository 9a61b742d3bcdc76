"""Claims of chapters 2 to 5: vectors, steps, damping, scaling and forces."""

from __future__ import annotations

import math
import random
import sys
from types import FrameType

from scipy.integrate import quad, solve_ivp

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


@claim(
    "2.1.2",
    "To compare two lengths, you can compare their squares",
    predict="Is there any pair of lengths for which comparing the squares gives the wrong answer?",
    verdict="It holds if the squares are neither too large nor too small for a float",
)
def squares_compare() -> str:
    rng = random.Random(1)
    for _ in range(1000):
        a, b = (Vector3(*(rng.uniform(-1e3, 1e3) for _ in range(3))) for _ in "ab")
        longer = math.dist((0, 0, 0), tuple(a)) > math.dist((0, 0, 0), tuple(b))
        assert (a.squared_magnitude() > b.squared_magnitude()) is longer
    large, small = Vector3(2e200), Vector3(1e-200)
    assert large.squared_magnitude() == Vector3(1e200).squared_magnitude() == math.inf
    assert small.squared_magnitude() == Vector3().squared_magnitude() == 0.0
    return (
        "The squares gave the right answer for all of 1,000 random pairs. They fail only far "
        "outside of any game: the square of 1e200 is too large for a float, and the square of "
        "1e-200 is rounded to 0."
    )


@claim(
    "2.1.9",
    "Two vectors are parallel if their vector product is exactly zero",
    predict="Take 1,000 random vectors, and multiply each of them by a random number. For how "
    "many of these pairs is the vector product exactly zero?",
    verdict="It fails",
    erratum="E-46",
)
def parallel_products() -> str:
    rng = random.Random(1)
    exact, largest = 0, 0.0
    for _ in range(1000):
        v = Vector3(*(rng.uniform(-1, 1) for _ in range(3)))
        product = v.cross(v * rng.uniform(-10, 10)).magnitude()
        exact += product == 0.0
        largest = max(largest, product)
    assert exact < 500
    assert largest < 1e-14  # ten times the rounding error of products up to 10
    return (
        f"It is exactly zero for only {exact} of the 1,000 pairs. The others are parallel except "
        "for a rounding error. Compare the length of the product with a small fraction of the "
        "product of both lengths."
    )


@claim(
    "2.2.2",
    "p + v t + a t²/2 gives the position after any time t",
    predict="Use a single step of 5 s for a stone that is thrown, and a single step of 0.5 s "
    "for a weight on a spring that swings back and forth in 1 s. Which result is wrong?",
    verdict="It holds if the acceleration is constant",
)
def constant_acceleration() -> str:
    path, _ = quad(lambda t: 30.0 - G * t, 0.0, 5.0)
    thrown = 30.0 * 5.0 - G * 5.0**2 / 2.0
    assert math.isclose(path, thrown, rel_tol=1e-13)
    omega = 2.0 * math.pi
    exact = math.cos(omega * 0.5)
    swung = 1.0 - omega**2 * 0.5**2 / 2.0
    assert abs(swung - exact) > 2.0
    return (
        f"The stone is exactly where it should be, at {thrown:.2f} m if it starts at 30 m/s. The "
        f"weight starts at 1 m, at rest, and should be at {exact:.0f} m. The formula puts it at "
        f"{swung:.2f} m, because the acceleration of a spring changes with the position."
    )


@claim(
    "2.2.1",
    "A negative acceleration slows a body down",
    predict="A ball is thrown upward at 5 m/s. Gravity gives it an acceleration of -9.81 m/s² "
    "all the time, if +Y points up. Is it slower after 0.25 s than at the start? And after 1.25 s?",
    verdict="It holds if the velocity is positive",
)
def negative_acceleration() -> str:
    ball = Particle(velocity=Vector3(0.0, 5.0), acceleration=DOWN)
    speeds = []
    for _ in range(2):
        for _ in range(15 if not speeds else 60):
            ball.integrate(FRAME)
        speeds.append(ball.velocity.magnitude())
    assert math.isclose(speeds[0], 5.0 - G * 0.25, rel_tol=1e-12)
    assert math.isclose(speeds[1], G * 1.25 - 5.0, rel_tol=1e-12)
    assert speeds[0] < 5.0 < speeds[1]
    return (
        f"After 0.25 s it still rises, at {speeds[0]:.1f} m/s. After 1.25 s it falls at "
        f"{speeds[1]:.1f} m/s, which is faster than at the start. A body slows down if its "
        "velocity and its acceleration point in opposite directions."
    )


@claim(
    "3.3.1",
    "You can leave out the term a h²/2, because it is tiny in a short step",
    predict="A stone falls for one second in steps of 1/60 s, without the term. By how much is "
    "its position wrong? Is it wrong by twice as much after two seconds, or by four times as much?",
    verdict="It holds if an error of a T h/2 after the time T does not matter",
)
def without_the_term() -> str:
    errors = []
    for seconds in (1, 2):
        stone = Particle(acceleration=DOWN)
        for _ in range(60 * seconds):
            stone.integrate(FRAME)
        errors.append(stone.position.y + G * seconds**2 / 2.0)
        assert math.isclose(errors[-1], G * seconds * FRAME / 2.0, rel_tol=1e-9)
    return (
        f"With g = 9.81 m/s², the stone is {errors[0] * 100:.1f} cm too high after one second and "
        f"{errors[1] * 100:.1f} cm after two. The term of a single step is only "
        f"{G * FRAME**2 / 2.0 * 1000:.1f} mm, but the terms of all steps add up to a T h/2."
    )


@claim(
    "3.3.1",
    "With damping per second, the speed that is left no longer depends on the frame rate",
    predict="One particle keeps 99 % of its velocity in each frame, another one 99 % in each "
    "second. How much is left of both after one second, at 30 and at 120 frames per second?",
    verdict="It holds if nothing else accelerates the particle",
)
def damping_per_second() -> str:
    left = {}
    for rate in (30, 120):
        coasting, falling = (
            Particle(velocity=v, acceleration=a, damping=0.9)
            for v, a in ((Vector3(1.0), Vector3()), (Vector3(), DOWN))
        )
        for _ in range(rate):
            coasting.integrate(1.0 / rate)
            falling.integrate(1.0 / rate)
        assert math.isclose(coasting.velocity.x, 0.9, rel_tol=1e-12)
        left[rate] = 0.99**rate, -falling.velocity.y, coasting.position.x
    falls = abs(left[30][1] / left[120][1] - 1.0)
    farther = left[30][2] / left[120][2] - 1.0
    assert 1e-4 < falls < farther < 0.01
    return (
        f"With damping per frame, {100.0 * left[30][0]:.0f} % is left at 30 frames per second and "
        f"{100.0 * left[120][0]:.0f} % at 120. With damping per second, 99 % is left at both. But "
        "if it has a damping of 0.9 and falls, its speed after one second still differs by "
        f"{100.0 * falls:.1f} % between these rates, because each step adds the acceleration "
        f"before it damps. And if it coasts, it comes {100.0 * farther:.1f} % farther at 30 "
        "frames per second, because each step still moves with the velocity from its start."
    )


@claim(
    "3.2",
    "A damping slightly below 1 removes the energy that the time steps add",
    predict="Hang 1 kg on a spring, and use the book's step with a damping of 0.999 at 60 steps "
    "per second. Up to which stiffness does the damping win: 0.06, 6, or 600 N/m?",
    verdict="It holds if no spring is stiffer than m (1 / dʰ - 1) / h², and bodies are fast enough",
)
def damping_against_energy() -> str:
    limit = (0.999**-FRAME - 1.0) / FRAME**2
    reaches = []
    for stiffness in (0.5 * limit, 2.0 * limit):
        ball, registry = Particle(Vector3(1.0), damping=0.999), ForceRegistry()
        registry.add(ball, AnchoredSpring(Vector3(), stiffness, 0.0))
        energy = [stiffness / 2.0]
        for _ in range(60_000):
            explicit_euler([ball], registry.update_forces, FRAME)
        energy.append(ball.kinetic_energy() + stiffness * ball.position.x**2 / 2.0)
        reaches.append(energy[1] / energy[0])
    thrown = Particle(velocity=Vector3(0.0, 20.0), acceleration=DOWN, damping=0.999)
    for _ in range(240):
        thrown.integrate(FRAME)
    gained = thrown.kinetic_energy() + G * thrown.position.y
    assert reaches[0] < 1.0 < reaches[1]
    assert gained > 200.0
    return (
        f"Only up to {limit:.2f} N/m. A spring of half this stiffness keeps "
        f"{100.0 * reaches[0]:.0f} % of its energy over 1,000 s, but with twice the stiffness the "
        f"energy grows by a factor of {reaches[1]:.1f}. Under constant gravity, the damping "
        "limits the speed of a falling body. But it is too weak at first: thrown upward at 20 "
        f"m/s, a ball has {gained:.1f} J per kg after 4 s instead of 200 J."
    )


@claim(
    "3.2.4",
    "A game can treat gravity as a constant acceleration",
    predict="How high above the ground is gravity weaker by 1 %?",
    verdict="It holds if nothing flies higher or farther than some kilometers",
)
def constant_gravity() -> str:
    radius = 6371.0  # km, the mean radius of the Earth
    height = radius * (1.0 / math.sqrt(0.99) - 1.0)
    orbit = (radius / (radius + 400.0)) ** 2
    assert height > 30.0
    return (
        f"At {height:.0f} km. In a game about planets and satellites, you need 1/r² instead. But "
        f"even in an orbit 400 km high, gravity still has {100.0 * orbit:.0f} % of its strength "
        "at the ground. Along the ground, its direction changes by 1° every 111 km."
    )


@claim(
    "4.1.1",
    "A slow bullet hits as hard as a fast one if its mass makes up for its speed",
    predict="A bullet of 5 g at 500 m/s becomes one of 2 kg at 25 m/s, with the same energy. It "
    "gets stuck in a block of 10 kg. Is the block as fast afterward as with the real bullet?",
    verdict="It holds if only the energy counts",
)
def slow_bullets() -> str:
    mass = slowed_mass(0.005, 20.0)
    assert math.isclose(muzzle_energy(mass, 25.0), muzzle_energy(0.005, 500.0), rel_tol=1e-12)
    fast, slow = 0.005 * 500.0 / 10.005, mass * 25.0 / (10.0 + mass)
    assert slow > 10.0 * fast
    return (
        f"Both bullets have {muzzle_energy(mass, 25.0):.0f} J. But the slow one has 20 times the "
        f"momentum, so it throws the block at {slow:.1f} m/s instead of {fast:.2f} m/s. No mass "
        "keeps both energy and momentum."
    )


@claim(
    "4.1.1",
    "A bullet that is slowed by a factor s follows the old path if gravity is divided by s",
    predict="A target is 100 m away, and the bullet is slowed from 500 to 25 m/s. How far does "
    "it drop on its way, with 10 m/s² / 20?",
    verdict="It fails",
    erratum="E-2",
)
def slow_gravity() -> str:
    real, printed, right = (
        g * (100.0 / speed) ** 2 / 2.0
        for g, speed in ((10.0, 500.0), (10.0 / 20.0, 25.0), (10.0 / 20.0**2, 25.0))
    )
    assert math.isclose(real, right, rel_tol=1e-12)
    assert printed > 10.0 * real
    return (
        f"The real bullet drops by {real:.1f} m. With gravity divided by 20 the slow one drops by "
        f"{printed:.0f} m, and with gravity divided by 20² by {right:.1f} m."
    )


@claim(
    "5.3",
    "Gravity should stay in the particle, because a force generator for it costs more",
    predict="How many of our functions does one step of 100 falling particles call with the "
    "acceleration of the particle, and how many with a force generator?",
    verdict="It holds",
)
def built_in_gravity() -> str:
    calls = []
    for built_in in (True, False):
        registry = ForceRegistry()
        particles = [Particle(acceleration=DOWN if built_in else None) for _ in range(100)]
        if not built_in:
            gravity = Gravity(DOWN)
            for particle in particles:
                registry.add(particle, gravity)
        calls.append(_calls(lambda p=particles, r=registry: _step(p, r)))
    assert calls[1] > calls[0]
    states = []
    for built_in in (True, False):
        ball, registry = (
            Particle(acceleration=DOWN if built_in else None, mass=3.0),
            ForceRegistry(),
        )
        if not built_in:
            registry.add(ball, Gravity(DOWN))
        for _ in range(60):
            _step([ball], registry)
        states.append(ball.position.y)
    assert math.isclose(states[0], states[1], rel_tol=1e-12)
    return (
        f"The generator makes a step call {calls[1] / calls[0]:.1f} times as many functions, and "
        "the particles move in the same way."
    )


def _step(particles: list[Particle], registry: ForceRegistry) -> None:
    semi_implicit_euler(particles, registry.update_forces, FRAME)


def _calls(work: object) -> int:
    """Count the Python functions that ``work`` calls."""
    count = 0

    def seen(_: FrameType, event: str, __: object) -> None:
        nonlocal count
        count += event == "call"

    sys.setprofile(seen)
    try:
        work()  # type: ignore[operator]
    finally:
        sys.setprofile(None)
    return count


@claim(
    "5.2.4",
    "The damping of the particle can stand in for drag",
    predict="A body of 1 kg flies at 20 m/s without gravity. Choose a damping that gives the "
    "right speed after one second of drag. Is the speed also right after ten seconds?",
    verdict="It holds if the drag is proportional to the speed, and the air is at rest",
)
def damping_for_drag() -> str:
    wrong = {}
    for k1, k2 in ((0.2, 0.0), (0.0, 0.02)):
        speeds = solve_ivp(
            lambda _, v, k1=k1, k2=k2: -k1 * v - k2 * v * v,
            (0.0, 10.0),
            [20.0],
            t_eval=[1.0, 10.0],
            rtol=1e-10,
            atol=1e-12,
        ).y[0]
        damping = speeds[0] / 20.0
        wrong[k2] = 20.0 * damping**10 / speeds[1] - 1.0
        body, registry = Particle(velocity=Vector3(20.0)), ForceRegistry()
        registry.add(body, Drag(k1, k2))
        for _ in range(10_000):
            semi_implicit_euler([body], registry.update_forces, 1e-3)
        assert math.isclose(body.velocity.x, speeds[1], rel_tol=1e-3)  # a step of 1 ms, order 1
    assert abs(wrong[0.0]) < 1e-6
    assert wrong[0.02] < -0.5
    return (
        "If the drag is k1 v with k1 = 0.2 N s/m, the same damping is right at all times. If it "
        "is k2 v² with k2 = 0.02 N s²/m², the damped body is too slow by "
        f"{100.0 * -wrong[0.02]:.0f} % after ten seconds, because such drag falls to a quarter "
        "when the speed halves, and damping only to a half."
    )
