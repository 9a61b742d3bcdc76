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


def eigenvalue(step: Integrator, force: ForceGenerator, h: float = FRAME) -> complex:
    """Return the eigenvalue of one step in the upper half plane: its growth and its angle."""
    columns = [after(step, force, 1, h, 1.0, 0.0), after(step, force, 1, h, 0.0, 1.0)]
    return complex(max(numpy.linalg.eigvals(numpy.transpose(columns)), key=lambda q: q.imag))


def energy(stiffness: float, state: tuple[float, float]) -> float:
    x, v = state
    return (stiffness * x * x + v * v) / 2.0


@claim(
    "6.3.1",
    "A soft spring behaves normally, but is slightly stiffer than it should be",
    predict="Simulate a spring of 10 N/m with 1 kg by the book's step, at 60 steps per second. "
    "How large is its energy after a minute? Does it swing too fast or too slowly?",
    verdict="It fails",
    erratum="E-37",
)
def soft_spring() -> str:
    spring = AnchoredSpring(Vector3(), 10.0, 0.0)
    grown = energy(10.0, after(explicit_euler, spring, 3600)) / 5.0
    own = math.sqrt(10.0) * FRAME
    slow, fast = (
        cmath.phase(eigenvalue(step, spring)) / own - 1.0
        for step in (explicit_euler, semi_implicit_euler)
    )
    assert grown > 1.0
    assert slow < 0.0 < fast
    return (
        f"After a minute the energy has grown by a factor of {grown:,.0f}. The spring swings too "
        f"slowly, by {100.0 * -slow:.2f} %. It is semi-implicit Euler that makes a spring "
        f"slightly stiffer: it swings too fast, by {100.0 * fast:.3f} %, and its energy never "
        "drifts."
    )


@claim(
    "6.3.1",
    "A spring that is too stiff for the time step explodes",
    predict="By what factor does one second multiply the amplitude of a spring of 10,000 N/m "
    "with 1 kg and the book's step, at 60 steps per second?",
    verdict="It holds",
)
def stiff_spring() -> str:
    spring = AnchoredSpring(Vector3(), 10_000.0, 0.0)
    growth = abs(eigenvalue(explicit_euler, spring))
    assert math.isclose(growth**2, 1.0 + 10_000.0 * FRAME**2, rel_tol=1e-12)
    below, above = (
        abs(eigenvalue(semi_implicit_euler, AnchoredSpring(Vector3(), k, 0.0)))
        for k in (14_300.0, 14_500.0)
    )
    assert math.isclose(below, 1.0, rel_tol=1e-9)
    assert growth**60 > 1e15
    exponent = math.floor(60.0 * math.log10(growth))
    assert above > 1.0 or exponent > 0
    return (
        f"By about 10 to the power of {exponent}. Semi-implicit Euler is stable up to 14,400 N/m "
        "here, and explodes beyond."
    )


@claim(
    "6.3.1",
    "Several smaller updates in each frame do not help much",
    predict="Divide each frame at 60 Hz into four steps. How much stiffer may a spring then be "
    "with semi-implicit Euler?",
    verdict="It fails",
    erratum="E-38",
)
def substeps() -> str:
    stable = []
    for count in (1, 4):
        limit = 4.0 * (60.0 * count) ** 2
        for factor, holds in ((0.99, True), (1.01, False)):
            spring = AnchoredSpring(Vector3(), factor * limit, 0.0)
            x, _ = after(semi_implicit_euler, spring, 600, FRAME / count)
            assert (abs(x) < 100.0) is holds
        stable.append(limit)
    spring = AnchoredSpring(Vector3(), 100.0, 0.0)
    grown = [
        energy(100.0, after(explicit_euler, spring, 600 * count, FRAME / count)) / 50.0
        for count in (1, 4, 16)
    ]
    assert grown[0] > 1e4 * grown[1]
    return (
        f"{stable[1] / stable[0]:.0f} times as stiff: {stable[1]:,.0f} instead of "
        f"{stable[0]:,.0f} N/m with 1 kg. The book's step gains too. On a spring of 100 N/m, it "
        f"multiplies the energy within 10 s by {grown[0]:.1e} with one step per frame, by "
        f"{grown[1]:.0f} with four, and by {grown[2]:.1f} with 16."
    )


@claim(
    "6.3.2",
    "A faked spring puts the particle where the real spring would put it at the end of the frame",
    predict="A faked spring of 400 N/m moves 1 kg, which starts at rest, with semi-implicit "
    "Euler at 60 steps per second. Is the position right after one step? And after ten?",
    verdict="It holds if you look at the first step only",
)
def faked_spring() -> str:
    spring = FakeStiffSpring(Vector3(), 400.0, 0.0)
    errors = []
    for steps in (1, 10):
        x, _ = after(semi_implicit_euler, spring, steps)
        errors.append(abs(x - math.cos(20.0 * steps * FRAME)))
    assert errors[0] < 1e-12
    assert errors[1] > 0.1
    return (
        f"After one step the position is exact. After ten it is wrong by {errors[1]:.2f} of the "
        "amplitude, because the step leaves a velocity that the real particle would not have at "
        "that position, and the next frame starts with it."
    )


@claim(
    "6.3.2",
    "A faked spring is sometimes stiffer and sometimes looser than the real one",
    predict="Is a faked spring stiffer or looser if the steps are short?",
    verdict="It fails",
    erratum="E-42",
)
def stiffness_of_a_fake() -> str:
    slower = []
    for stiffness in (1.0, 100.0, 3600.0):
        fake = FakeStiffSpring(Vector3(), stiffness, 0.0)
        angle = math.sqrt(stiffness) * FRAME
        slower.append(angle / cmath.phase(eigenvalue(semi_implicit_euler, fake)))
        assert slower[-1] > 1.3
    return (
        f"Always looser. With 1 kg at 60 steps per second, it swings {slower[0]:.2f} times too "
        f"slowly at 1 N/m and {slower[2]:.2f} times too slowly at 3,600 N/m. A factor of 1.41 is "
        "the root of 2, so the faked spring is half as stiff as it should be."
    )


@claim(
    "6.3.2",
    "With damping and an anchor at rest, a faked spring never gains speed",
    predict="Fake a spring of 400 N/m with 1 kg and a damping of 1 N s/m, and use the book's "
    "step at 60 steps per second. Does it come to rest within 5 s?",
    verdict="It fails",
    erratum="E-22",
)
def damped_fake() -> str:
    fake = FakeStiffSpring(Vector3(), 400.0, 1.0)
    widest = max(abs(after(explicit_euler, fake, n)[0]) for n in range(280, 301))
    calm = max(abs(after(semi_implicit_euler, fake, n)[0]) for n in range(280, 301))
    assert widest > 10.0
    assert calm < 1.0
    return (
        f"No, after 5 s its amplitude is {widest:.0f} times as large as at the start. With "
        f"semi-implicit Euler it has fallen to {calm:.2f} of the start."
    )


@claim(
    "6.3.2",
    "A faked spring is wrong when other forces act too",
    predict="A weight of 1 kg hangs at rest from a faked spring of 1,000 N/m with a damping of "
    "20 N s/m, at 60 steps per second. A real spring would stretch by 9.8 mm. How far does this "
    "one?",
    verdict="It holds",
)
def fake_and_gravity() -> str:
    real = 9.81 / 1000.0
    weight, registry = Particle(), ForceRegistry()
    registry.add(weight, FakeStiffSpring(Vector3(), 1000.0, 20.0))
    registry.add(weight, Gravity(DOWN))
    for _ in range(1200):
        semi_implicit_euler([weight], registry.update_forces, FRAME)
    sag = -weight.position.y
    assert abs(weight.velocity.y) < 1e-9
    assert abs(sag / real - 1.0) > 0.1
    return (
        f"By {sag * 1000:.1f} mm, which is {sag / real:.2f} times as far. The faked force takes "
        "the particle to a goal that was computed as if nothing else pulled."
    )


@claim(
    "6.2.4",
    "The water carries a body in proportion to the depth to which it is submerged",
    predict="A ball is submerged to a quarter of its diameter. Is a quarter of its volume under "
    "water?",
    verdict="It holds if the body is a box that floats level",
)
def buoyancy() -> str:
    depth = 0.5  # of a ball of radius 1
    heights = numpy.linspace(-1.0, -1.0 + depth, 200_001)
    cap = numpy.trapezoid(math.pi * (1.0 - heights**2), heights) / (4.0 / 3.0 * math.pi)
    closed = depth**2 * (3.0 - depth) / 4.0
    assert math.isclose(cap, closed, rel_tol=1e-8)
    assert cap < 0.2
    return (
        f"Only {100.0 * cap:.1f} % of the volume of the ball, because it is narrow at the bottom."
    )


@claim(
    "6.3",
    "Collisions by stiff springs are spongy, or they explode",
    predict="Drop 1 kg from 1 m onto ground that pushes like a spring, with semi-implicit Euler "
    "at 60 steps per second. How deep does it sink on ground of 500 N/m? How high does it climb "
    "from ground of 50,000 N/m?",
    verdict="It holds",
)
def penalty_ground() -> str:
    deep, high = [], []
    for stiffness in (500.0, 50_000.0):
        ball, registry = Particle(Vector3(0.0, 1.0), acceleration=DOWN), ForceRegistry()
        registry.add(ball, PenaltyGround(0.0, stiffness))
        heights = []
        for _ in range(180):
            semi_implicit_euler([ball], registry.update_forces, FRAME)
            heights.append(ball.position.y)
        first = next(i for i, y in enumerate(heights) if y < 0.0)
        deep.append(-min(heights))
        high.append(max(heights[first:]))
    assert deep[0] > 0.1
    assert high[1] > 2.0
    return (
        f"On ground of 500 N/m it sinks in by {deep[0] * 100:.0f} cm. From ground of 50,000 N/m "
        f"it climbs to {high[1]:.0f} m within 3 s, although a real ball would not climb above 1 m."
    )
