"""The measured numbers of the reference pages are correct for the scenes that they describe."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from itertools import pairwise

import pytest

from autograder.manifest import ROOT
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.going_further.adaptive import adaptive
from ch06_springs.integrators import (
    Integrator,
    explicit_euler,
    leapfrog,
    runge_kutta_4,
    semi_implicit_euler,
)
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.contacts import ContactResolver
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.going_further.sequential_impulses import SequentialImpulses
from ch07_constraints.links import Rod, TwoSidedRod
from lessons.lesson import agrees
from plots.ch07_constraints.bounces import without_rule
from plots.ch07_constraints.rods import energy, stretch
from plots.ch07_constraints.stacks import sinking
from scenes.chain import Chain, Link
from scenes.resolving import Resolve, no_forces
from studies.accuracy.measured.chains import double_pendulum
from studies.accuracy.measured.nets import swinging
from studies.models.rod_tensions import RodTensions

NUMBER = r"(\d+(?:\.\d+)?(?:e-\d+)?)"
FRAME = 1 / 60
BY_RULE = ContactResolver().resolve_contacts


def heights(
    step: Integrator,
    gravity: float,
    start: float,
    restitution: float,
    seconds: float,
    resolve: Resolve = BY_RULE,
) -> list[float]:
    """Drop a ball without a radius, and return its height after each step of 1/60 s."""
    ball = Particle(Vector3(0, start), acceleration=Vector3(0, -gravity))
    ground, path = GroundPlane([ball], restitution=restitution), []
    for _ in range(round(seconds / FRAME)):
        step([ball], no_forces, FRAME)
        resolve(ground.contacts(), FRAME)
        path.append(ball.position.y)
    return path


def hop(restitution: float, resolve: Resolve = BY_RULE) -> float:
    """Return the largest height in mm of a ball at rest, with the book's step."""
    return 1000 * max(heights(explicit_euler, 9.81, 1e-6, restitution, 2, resolve))


def climb(gravity: float, seconds: float = 20) -> float:
    """Return how high a ball bounces with the book's step, dropped from 2 m with restitution 1."""
    return max(heights(explicit_euler, gravity, 2, 1, seconds))


def moves_until(gravity: float) -> float:
    """Return when a ball, dropped from 2 m with restitution 1, last moves by over 1 micrometer."""
    path = heights(semi_implicit_euler, gravity, 2, 1, 20)
    moves = [i for i in range(1, len(path)) if abs(path[i] - path[i - 1]) > 1e-6]
    return (moves[-1] + 1) * FRAME


def sinks(count: int, iterations: int | None) -> float:
    """Return how deep the spheres of a stack overlap within 2 s, in percent of a diameter."""
    return 100 * max(sinking(count, iterations)[1].values)


def wrong_by(count: int, link: Link, substeps: int = 1) -> float:
    """Return the largest error in mm of the rods of a hanging chain within 2 s."""
    _, worst = stretch(Chain([1.0] * count, 0.1), link, 120, substeps=substeps)
    return 1000 * max(worst.values)


def loses(step: Integrator | None, rate: int) -> float:
    """Return the energy that a pendulum loses in 10 s, in percent."""
    energies = energy(step, rate).values
    return 100 * (1 - energies[-1] / energies[0])


def misses(model: str) -> float:
    """Return the largest error in m of a bob of a double pendulum, with one step per frame."""
    scene = double_pendulum()
    [found] = [one for one in scene.models if one.name == model]
    errors = []
    for i, place in enumerate(found.run(1).places):
        truth = scene.truth((i + 1) * FRAME)
        errors += [math.dist(place[j : j + 2], truth[j : j + 2]) for j in (0, 2)]
    return max(errors)


def errors_of_a_stiff_spring() -> tuple[float, float]:
    """Return the largest errors in a second in %, with 16 evaluations of the force per frame."""

    def error(integrator: Integrator, steps: int) -> float:
        ball, registry, worst = Particle(Vector3(1.0)), ForceRegistry(), 0.0
        registry.add(ball, AnchoredSpring(Vector3(), 1e4, 0.0))
        for i in range(1, 60 * steps + 1):
            integrator([ball], registry.update_forces, FRAME / steps)
            worst = max(worst, abs(ball.position.x - math.cos(100.0 * i * FRAME / steps)))
        return 100.0 * worst

    return error(leapfrog, 16), error(runge_kutta_4, 4)


def evaluations() -> float:
    """Return how often `adaptive` evaluates a spring of 10^6 N/m on 1 kg per 1/60 s, on average."""
    ball, registry, step = Particle(Vector3(0.1)), ForceRegistry(), adaptive(0.1)
    registry.add(ball, AnchoredSpring(Vector3(), 1e6, 0))
    for _ in range(10):
        step([ball], registry.update_forces, FRAME)
    return step.evaluations / 10


def errors_of_nets() -> tuple[float, ...]:
    """Return the errors of `DirectNet`, of `SmoothNet`, and of its steps of twelve frames."""
    scene = swinging()
    return tuple(scene.error(model.run(1)) for model in scene.models[:3])


PAGES = [page.read_text(encoding="utf-8") for page in ROOT.glob("chapters/ch*/reference.md")]
SAID = " ".join(" ".join(PAGES).split())
CLAIMS: dict[str, Callable[[], tuple[float, ...]]] = {
    "- # mm by `DirectChain`; - # micrometers by `RodTensions` and Runge-Kutta 4; "
    "- # micrometers by `AngleChain`": lambda: (
        1e3 * misses("direct chain"),
        1e6 * misses("rods as forces, Runge-Kutta 4"),
        1e6 * misses("by its angles, Runge-Kutta 4"),
    ),
    "hops by up to # mm at restitution 0.5 and by # mm at 0.9. Without the rule, the hops reach "
    "# mm and # cm within two seconds. All of this is for 60 steps per second and 9.81": lambda: (
        *(hop(0.5), hop(0.9)),
        *(hop(0.5, without_rule), hop(0.9, without_rule) / 10),
    ),
    "9.81 m/s^2, the ball climbs to # m in two bounces and then repeats the same bounce. With "
    "10 m/s^2 it climbs to # m within 20 s.": lambda: (climb(9.81), climb(10)),
    "lies still after # s with 9.81 m/s^2, and after # s with 10 m/s^2.": lambda: (
        *(moves_until(9.81), moves_until(10)),
    ),
    "sink into each other by # % of a diameter. In a stack of ten they sink by # %. With 50 "
    "iterations per contact, these ten sink by # %.": lambda: (
        *(sinks(3, None), sinks(10, None), sinks(10, 50)),
    ),
    "| 3 rods | # mm | # mm | | 10 rods | # mm | # mm |": lambda: tuple(
        wrong_by(count, link) for count in (3, 10) for link in (Rod, TwoSidedRod)
    ),
    "| 10 rods, 16 substeps | # mm | # mm |": lambda: tuple(
        wrong_by(10, link, 16) for link in (Rod, TwoSidedRod)
    ),
    "it loses # % in 10 s with the book's step and # % with semi-implicit Euler. With 960 steps "
    "per second, these losses are # % and # %.": lambda: tuple(
        loses(step, rate) for rate in (60, 960) for step in (explicit_euler, semi_implicit_euler)
    ),
    "At 60 steps per second, the pendulum above loses # % of its energy in 10 s.": lambda: (
        loses(None, 60),
    ),
    "- # by `DirectNet`, with one step in each 60 Hz frame; - # by `SmoothNet`, in about twice the "
    "time; - # by `SmoothNet` with one step in twelve frames": errors_of_nets,
    "is # % of the amplitude with leapfrog and # % with Runge-Kutta": errors_of_a_stiff_spring,
    "takes about # evaluations": lambda: (round(evaluations(), -1),),
}


@pytest.mark.parametrize("claim", CLAIMS, ids=range(len(CLAIMS)))
def test_a_reference_page_states_what_its_scene_does(claim: str) -> None:
    found = re.search(re.escape(claim).replace(r"\#", NUMBER), SAID)
    assert found, claim
    computed = CLAIMS[claim]()
    assert all(map(agrees, found.groups(), computed)), computed


@pytest.mark.parametrize(("steps", "kept"), [(38, 0.9), (60, 0.99)])
def test_the_loss_of_runge_kutta_depends_on_the_step(steps: int, kept: float) -> None:
    """The energy after 10,000 oscillations follows from the eigenvalues of a step."""
    text = "a tenth of it is gone with 38 steps in each oscillation, and a hundredth with 60"
    assert text in SAID
    z = 2j * math.pi / steps
    eigenvalue = 1 + z + z**2 / 2 + z**3 / 6 + z**4 / 24
    assert abs(eigenvalue) ** (2 * 10_000 * steps) == pytest.approx(kept, abs=0.003)


def worst_of_double_pendulum(correction: float) -> tuple[float, float]:
    """Return the largest error of a fast pendulum's rods in m, and after how many s it fails."""
    bobs = [Particle(Vector3(x), acceleration=Vector3(0, -9.81)) for x in (0.5, 1.0)]
    rods, worst = RodTensions(bobs, Vector3(), correction), 0.0
    for i in range(3600):
        try:
            runge_kutta_4(bobs, rods.update_forces, FRAME)
        except ValueError:  # a force is not finite
            return worst, i * FRAME
        ends = bobs[0].position, bobs[1].position - bobs[0].position
        worst = max(worst, *(abs(one.magnitude() - 0.5) for one in ends))
    return worst, 60.0


def test_a_correction_keeps_a_fast_double_pendulum_together() -> None:
    """For starts within 0.1 degrees it takes 19.8 to 23.5 s, and 0.19 to 0.20 mm."""
    assert "after 20 to 24 s." in SAID
    assert 19 < worst_of_double_pendulum(0.0)[1] < 25
    assert "the rods are accurate to 0.2 mm for a minute" in SAID
    assert worst_of_double_pendulum(5.0) == (pytest.approx(0.0002, abs=0.00003), 60.0)


@pytest.mark.parametrize("length", [0.1, 1.0])
def test_sequential_impulses_stretch_a_rope_with_a_heavy_weight(length: float) -> None:
    text = "twice as long as it should be, and after 20 s it is still a fifth too long"
    assert text in SAID
    joints = [Particle(Vector3(0, -length * i), acceleration=Vector3(0, -10)) for i in range(6)]
    joints[0].mass, joints[-1].mass = math.inf, 100
    rope = SequentialImpulses(joints, [TwoSidedRod(*pair, length) for pair in pairwise(joints)])
    excess = []
    for _ in range(1200):
        rope.step(FRAME)
        excess.append(math.dist([*joints[0].position], [*joints[-1].position]) - 5 * length)
    assert excess[30] == pytest.approx(0.5, rel=0.05)
    assert excess[-1] == pytest.approx(0.1, rel=0.05)
