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
    runge_kutta_4,
    semi_implicit_euler,
)
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.going_further.sequential_impulses import SequentialImpulses
from ch07_constraints.links import Rod, TwoSidedRod
from lessons.lesson import agrees
from plots.ch07_constraints.bounces import without_rule
from plots.ch07_constraints.rods import energy, stretch
from plots.ch07_constraints.stacks import sinking
from scenes.chain import Chain, Link
from scenes.clock import track
from scenes.resolving import Resolve, no_forces
from studies.accuracy.measured.chains import double_pendulum
from studies.accuracy.measured.nets import swinging
from studies.models.rod_tensions import RodTensions

NUMBER = r"(\d+(?:\.\d+)?)"
FRAME = 1 / 60


def heights(
    step: Integrator,
    gravity: float,
    start: float,
    restitution: float,
    seconds: float,
    resolve: Resolve | None = None,
) -> list[float]:
    """Drop a ball without a radius, and return its height after each step of 1/60 s."""
    ball = Particle(Vector3(0, start), acceleration=Vector3(0, -gravity))
    ground = GroundPlane([ball], restitution=restitution)

    def by_rule(contacts: list[Contact], duration: float) -> None:
        if contacts:
            ContactResolver().resolve_contacts(contacts, duration)

    def move(duration: float) -> None:
        step([ball], no_forces, duration)
        (resolve or by_rule)(ground.contacts(), duration)

    return track(move, lambda: ball.position.y, round(seconds / FRAME)).values[1:]


def hop(restitution: float, resolve: Resolve | None = None) -> float:
    """Return the largest height in mm of a ball at rest, with the book's step."""
    return 1000 * max(heights(explicit_euler, 9.81, 1e-6, restitution, 2, resolve))


def climb(gravity: float) -> float:
    return max(heights(explicit_euler, gravity, 2, 1, 20))


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


def evaluations() -> float:
    """Return how often `adaptive` evaluates a spring of 10^6 N/m on 1 kg per 1/60 s, on average."""
    ball, registry, step = Particle(Vector3(0.1)), ForceRegistry(), adaptive(0.1)
    registry.add(ball, AnchoredSpring(Vector3(), 1e6, 0))
    for _ in range(10):
        step([ball], registry.update_forces, FRAME)
    return step.evaluations / 10


def kept_by_runge_kutta(steps: int) -> float:
    """Return the energy that is left after 10,000 oscillations, from the eigenvalues of a step."""
    z = 2j * math.pi / steps
    factor = abs(1 + z + z**2 / 2 + z**3 / 6 + z**4 / 24)
    return factor ** (2 * 10_000 * steps)


CLAIMS: list[tuple[str, str, list[Callable[[], float]]]] = [
    (
        "ch07_constraints",
        "- # mm by `DirectChain`; - # micrometers by `RodTensions` and Runge-Kutta 4; "
        "- # micrometers by `AngleChain`",
        [
            lambda: 1e3 * misses("direct chain"),
            lambda: 1e6 * misses("rods as forces, Runge-Kutta 4"),
            lambda: 1e6 * misses("by its angles, Runge-Kutta 4"),
        ],
    ),
    (
        "ch07_constraints",
        "hops by up to # mm at restitution 0.5 and by # mm at 0.9. Without the rule, the hops "
        "reach # mm and # cm within two seconds. All of this is for 60 steps per second and 9.81",
        [
            lambda: hop(0.5),
            lambda: hop(0.9),
            lambda: hop(0.5, without_rule),
            lambda: hop(0.9, without_rule) / 10,
        ],
    ),
    (
        "ch07_constraints",
        "9.81 m/s^2, the ball climbs to # m in two bounces and then repeats the same bounce. With "
        "10 m/s^2 it climbs to # m within 20 s.",
        [lambda: climb(9.81), lambda: climb(10)],
    ),
    (
        "ch07_constraints",
        "lies still after # s with 9.81 m/s^2, and after # s with 10 m/s^2.",
        [lambda: moves_until(9.81), lambda: moves_until(10)],
    ),
    (
        "ch07_constraints",
        "sink into each other by # % of a diameter. In a stack of ten they sink by # %. With 50 "
        "iterations per contact, these ten sink by # %.",
        [lambda: sinks(3, None), lambda: sinks(10, None), lambda: sinks(10, 50)],
    ),
    (
        "ch07_constraints",
        "| 3 rods | # mm | # mm | | 10 rods | # mm | # mm | | 10 rods, 16 substeps | # mm | # mm |",
        [
            lambda: wrong_by(3, Rod),
            lambda: wrong_by(3, TwoSidedRod),
            lambda: wrong_by(10, Rod),
            lambda: wrong_by(10, TwoSidedRod),
            lambda: wrong_by(10, Rod, 16),
            lambda: wrong_by(10, TwoSidedRod, 16),
        ],
    ),
    (
        "ch07_constraints",
        "it loses # % in 10 s with the book's step and # % with semi-implicit Euler. With 960 "
        "steps per second, these losses are # % and # %.",
        [
            lambda: loses(explicit_euler, 60),
            lambda: loses(semi_implicit_euler, 60),
            lambda: loses(explicit_euler, 960),
            lambda: loses(semi_implicit_euler, 960),
        ],
    ),
    (
        "ch07_constraints",
        "At 60 steps per second, the pendulum above loses # % of its energy in 10 s.",
        [lambda: loses(None, 60)],
    ),
]


@pytest.mark.parametrize(("chapter", "claim", "values"), CLAIMS, ids=range(len(CLAIMS)))
def test_a_reference_page_states_what_its_scene_does(
    chapter: str, claim: str, values: list[Callable[[], float]]
) -> None:
    page = (ROOT / "chapters" / chapter / "reference.md").read_text(encoding="utf-8")
    pattern = re.escape(claim).replace(r"\#", NUMBER)
    found = re.search(pattern, " ".join(page.split()))
    assert found, claim
    computed = [value() for value in values]
    assert all(map(agrees, found.groups(), computed)), computed


def test_a_stiff_spring_is_expensive_for_adaptive() -> None:
    page = (ROOT / "chapters/ch06_springs/reference.md").read_text(encoding="utf-8")
    assert "takes about 130 evaluations" in " ".join(page.split())
    assert evaluations() == pytest.approx(130, abs=10)


def test_the_loss_of_runge_kutta_depends_on_the_step() -> None:
    page = (ROOT / "chapters/ch06_springs/reference.md").read_text(encoding="utf-8")
    said = "a tenth of it is gone with 38 steps in each oscillation, and a hundredth with 60"
    assert said in " ".join(page.split())
    assert kept_by_runge_kutta(38) == pytest.approx(0.9, abs=0.003)
    assert kept_by_runge_kutta(60) == pytest.approx(0.99, abs=0.003)


def test_a_correction_keeps_a_fast_double_pendulum_together() -> None:
    text = " ".join(
        (ROOT / "chapters/ch07_constraints/reference.md").read_text(encoding="utf-8").split()
    )
    assert "after 20 to 24 s." in text
    assert "the rods are accurate to 0.2 mm for a minute" in text
    worst, end = {}, {}
    for correction in (0.0, 5.0):
        bobs = [Particle(Vector3(x), acceleration=Vector3(0, -9.81)) for x in (0.5, 1.0)]
        rods, worst[correction], end[correction] = (
            RodTensions(bobs, Vector3(), correction),
            0.0,
            60.0,
        )
        for i in range(3600):
            try:
                runge_kutta_4(bobs, rods.update_forces, FRAME)
            except ValueError:  # a force is not finite
                end[correction] = i * FRAME
                break
            ends = bobs[0].position, bobs[1].position - bobs[0].position
            wrong = max(abs(one.magnitude() - 0.5) for one in ends)
            worst[correction] = max(worst[correction], wrong)
    # With starts that differ by 1e-12 to 0.1 degrees, it takes 19.8 to 23.5 s, and 0.19 to 0.20 mm.
    assert 19 < end[0.0] < 25
    assert end[5.0] == 60
    assert worst[5.0] == pytest.approx(0.0002, abs=0.00003)


@pytest.mark.parametrize("length", [0.1, 1.0])
def test_sequential_impulses_stretch_a_rope_with_a_heavy_weight(length: float) -> None:
    text = " ".join(
        (ROOT / "chapters/ch07_constraints/reference.md").read_text(encoding="utf-8").split()
    )
    assert "twice as long as it should be, and after 20 s it is still a fifth too long" in text
    joints = [Particle(Vector3(0, -length * i), acceleration=Vector3(0, -10)) for i in range(6)]
    joints[0].mass, joints[-1].mass = math.inf, 100
    rope = SequentialImpulses(joints, [TwoSidedRod(*pair, length) for pair in pairwise(joints)])
    excess = []
    for _ in range(1200):
        rope.step(FRAME)
        excess.append(math.dist([*joints[0].position], [*joints[-1].position]) - 5 * length)
    assert excess[30] == pytest.approx(0.5, rel=0.05)
    assert excess[-1] == pytest.approx(0.1, rel=0.05)


def test_the_errors_of_the_nets() -> None:
    text = " ".join(
        (ROOT / "chapters/ch07_constraints/reference.md").read_text(encoding="utf-8").split()
    )
    said = "- 4e-5 by `DirectNet`, with one step in each 60 Hz frame; - 6e-9 by `SmoothNet`"
    assert said in text
    assert "- 1.9e-4 by `SmoothNet` with one step in twelve frames" in text
    scene = swinging()
    direct, smooth, long_steps = (scene.error(model.run(1)) for model in scene.models[:3])
    assert direct == pytest.approx(4e-5, rel=0.1)
    assert smooth == pytest.approx(6e-9, rel=0.1)
    assert long_steps == pytest.approx(1.9e-4, rel=0.02)
