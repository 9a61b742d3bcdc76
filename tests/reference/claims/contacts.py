"""Claims of chapters 7 and 8: contacts, rods, the resolver, and structures of rods."""

from __future__ import annotations

import math
from itertools import combinations, pairwise

import numpy

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.links import Rod, TwoSidedRod
from ch07_constraints.time_division import TooManyImpacts, time_division_step
from ch08_mass_aggregate.cube import CORNERS
from ch08_mass_aggregate.world import ParticleWorld
from reference.claims.ledger import claim

FRAME = 1.0 / 60.0
UP = Vector3(0.0, 1.0)
G = 9.81


@claim(
    "7.1.2",
    "A collision is perfectly elastic if it conserves momentum",
    predict="A ball of 1 kg at 3 m/s meets a ball of 2 kg at -1 m/s, with a restitution of 0.5. "
    "Does the total momentum change? Does the total kinetic energy?",
    verdict="It fails",
    erratum="E-7",
)
def elastic() -> str:
    a, b = Particle(velocity=Vector3(3.0)), Particle(velocity=Vector3(-1.0), mass=2.0)
    energy = a.kinetic_energy() + b.kinetic_energy()
    Contact(a, b, Vector3(-1.0), 0.5).resolve_velocity()
    momentum = a.momentum().x + b.momentum().x
    left = a.kinetic_energy() + b.kinetic_energy()
    assert math.isclose(momentum, 1.0, rel_tol=1e-14)
    assert left < energy - 1.0
    return (
        f"The momentum stays {momentum:.0f} N s, as in every collision. The kinetic energy falls "
        f"from {energy:.1f} J to {left:.1f} J. A collision is elastic if it conserves kinetic "
        "energy."
    )


@claim(
    "7.2.2",
    "To push two bodies apart, move each in proportion to its inverse mass",
    predict="A ball of 1 kg and a ball of 9 kg overlap by 10 cm. How far does each of them "
    "move? What happens to their center of mass?",
    verdict="It holds",
)
def pushed_apart() -> str:
    a, b = Particle(Vector3(0.9)), Particle(Vector3(), mass=9.0)
    light, heavy = Contact(a, b, Vector3(1.0), 0.0, 0.1).resolve_penetration()
    assert math.isclose(light.x - heavy.x, 0.1, rel_tol=1e-12)
    assert abs(light.x + 9.0 * heavy.x) < 1e-15
    return (
        f"The light ball moves by {light.x * 100:.0f} cm and the heavy one by "
        f"{-heavy.x * 100:.0f} cm, so their center of mass stays where it is. With equal moves, "
        "every overlap would shift it, although no force from outside acts."
    )


@claim(
    "7.2.3",
    "A body comes to rest if its contact does not bounce with the velocity that gravity has "
    "just added",
    predict="Balls with a restitution of 0.5 and 0.9 start 1 micrometer above the ground, at 60 "
    "steps of the book's integrator per second. How high do they hop with this rule, and how "
    "high without?",
    verdict="It holds if gravity is the particle's own acceleration, or the rule counts all forces",
    erratum="E-26",
)
def resting() -> str:
    hops = [_hop(c, rule=rule) for c in (0.5, 0.9) for rule in (True, False)]
    assert hops[0] < hops[1]
    assert hops[2] < 0.1 * hops[3]
    return (
        f"With the rule they hop by up to {hops[0] * 1000:.1f} and {hops[2] * 1000:.1f} mm within "
        f"two seconds, and without it by {hops[1] * 1000:.1f} and {hops[3] * 1000:.0f} mm. With "
        "semi-implicit Euler and the rule, they lie still."
    )


def _hop(restitution: float, *, rule: bool) -> float:
    ball = Particle(Vector3(0.0, 1e-6), acceleration=UP * -G)
    ground, highest = GroundPlane([ball], restitution=restitution), 0.0
    for _ in range(120):
        ball.integrate(FRAME)
        for contact in ground.contacts():
            contact.resolve_velocity(FRAME if rule else 0.0)
            contact.resolve_penetration()
        highest = max(highest, ball.position.y)
    return highest


@claim(
    "7.3.1",
    "Twice as many iterations as there are contacts are enough",
    predict="Stack 3 spheres, and then 10, and simulate 2 s. By how much of a diameter do they "
    "sink into each other?",
    verdict="It holds if no contact depends on many others",
)
def iterations() -> str:
    few, many = _stack(3, None), _stack(10, None)
    patient = _stack(10, 50 * 10)
    assert few < 0.05
    assert many > 0.2
    assert patient < 0.05
    return (
        f"Three spheres sink by {100.0 * few:.1f} %, but ten by {100.0 * many:.0f} %, because "
        "each push on one sphere changes the contacts next to it. With 50 iterations per "
        f"contact, the ten sink by {100.0 * patient:.0f} %. This is at 60 steps per second and 10 "
        "m/s²."
    )


def _stack(count: int, iterations: int | None) -> float:
    spheres = [Particle(UP * (i + 0.5), acceleration=UP * -10.0) for i in range(count)]
    generators = [GroundPlane(spheres, radius=0.5), ParticlePairs(spheres, 0.5)]
    resolver, deepest = ContactResolver(iterations), 0.0
    for _ in range(120):
        semi_implicit_euler(spheres, lambda _: None, FRAME)
        resolver.resolve_contacts([c for g in generators for c in g.contacts()], FRAME)
        deepest = max(deepest, *(c.penetration for g in generators for c in g.contacts()))
    return deepest


@claim(
    "7.3.1",
    "Resolve the contact that closes fastest first, because the order matters",
    predict="Ten touching balls hit the ground in a column at 5 m/s, and no contact bounces. "
    "How many impulses does it take until no contact closes faster than 1 mm/s, worst first or "
    "from the top down?",
    verdict="It holds",
)
def worst_first() -> str:
    counts = [_impulses(worst=worst) for worst in (True, False)]
    assert counts[0] < counts[1]
    return (
        f"{counts[0]:,} impulses with the worst contact first, and {counts[1]:,} from the top "
        f"down. Worst first saves {100.0 * (1.0 - counts[0] / counts[1]):.0f} % of the work, but "
        "neither order makes a column of ten cheap."
    )


def _impulses(*, worst: bool) -> int:
    balls = [Particle(velocity=UP * -5.0) for _ in range(10)]
    contacts = [Contact(b, a, UP) for a, b in reversed(list(pairwise(balls)))]
    contacts.append(Contact(balls[0], None, UP))
    count = 0
    while closing := [c for c in contacts if c.separating_velocity() < -1e-3]:
        for contact in [min(closing, key=Contact.separating_velocity)] if worst else closing:
            if contact.separating_velocity() < -1e-3:
                contact.resolve_velocity()
                count += 1
    return count


@claim(
    "7.3.2",
    "Time steps that stop at each impact are accurate, but they can take endlessly long",
    predict="A ball falls from 2 m and bounces with a restitution of 1. How high does it climb "
    "after 20 s, with and without stopping at the impacts? What happens if its restitution is 0.5?",
    verdict="It holds",
)
def time_division() -> str:
    highest = []
    for divided in (True, False):
        ball = Particle(UP * 2.0, acceleration=UP * -G)
        ground, heights = GroundPlane([ball], restitution=1.0), []
        world = ParticleWorld([ball], [ground])
        for step in range(1200):
            if divided:
                time_division_step([ball], ground, FRAME)
            else:
                world.step(FRAME)
            if step >= 1080:
                energy = ball.position.y * G + ball.velocity.squared_magnitude() / 2.0
                heights.append(energy / G)
        highest.append(max(heights))
    assert math.isclose(highest[0], 2.0, rel_tol=1e-9)
    assert highest[1] < 0.01
    ball = Particle(UP * 2.0, acceleration=UP * -G)
    ground, stopped = GroundPlane([ball], restitution=0.5), 0.0
    try:
        for step in range(600):
            stopped = step * FRAME
            time_division_step([ball], ground, FRAME)
        raise AssertionError("it never stops")
    except TooManyImpacts as endless:
        stopped += endless.time
    last = math.sqrt(2.0 * 2.0 / G) * (1.0 + 0.5) / (1.0 - 0.5)
    assert abs(stopped - last) < 1e-6
    return (
        f"With stops at the impacts it still climbs to {highest[0]:.2f} m after 20 s. With steps "
        "of 1/60 s of semi-implicit Euler, it has come to rest by then. With a restitution of "
        f"0.5, the ball makes infinitely many bounces before it comes to rest after {last:.2f} s. "
        "There the step gives up with an error."
    )


@claim(
    "7.4.2",
    "A rod that makes both of its contacts in every frame is more stable",
    predict="Let a chain of three rods of 10 cm hang for 5 s, with 20 iterations in each phase. "
    "How far is a rod from its length, with the one contact that is broken and with both?",
    verdict="It holds",
    erratum="E-9",
)
def two_contacts() -> str:
    one, both = _chain(Rod), _chain(TwoSidedRod)
    assert both < 0.2 * one
    return (
        f"By up to {one * 1000:.0f} mm with one contact and {both * 1000:.1f} mm with both, at 60 "
        "steps per second and 10 m/s². The second contact costs iterations, as the book says."
    )


def _chain(kind: type[Rod]) -> float:
    bobs = [Particle(UP * (-0.1 * i), acceleration=UP * -10.0) for i in (1, 2, 3)]
    rods = [kind(a, b, 0.1) for a, b in pairwise([Particle(mass=math.inf), *bobs])]
    resolver, worst = ContactResolver(20), 0.0
    for _ in range(300):
        semi_implicit_euler(bobs, lambda _: None, FRAME)
        resolver.resolve_contacts([contact for rod in rods for contact in rod.contacts()], FRAME)
        worst = max(worst, *(abs((r.b.position - r.a.position).magnitude() - 0.1) for r in rods))
    return worst


@claim(
    "8.4",
    "A cube of eight particles needs 18 rods to be rigid",
    predict="A cube with its 12 edges and any 6 of its 12 face diagonals has 18 rods. Is it "
    "always rigid?",
    verdict="It holds if the rods are in the right places",
)
def cube() -> str:
    edges = [(i, j) for i, j in combinations(range(8), 2) if (i ^ j) in (1, 2, 4)]
    diagonals = [(i, j) for i, j in combinations(range(8), 2) if (i ^ j) in (3, 5, 6)]
    choices = list(combinations(diagonals, 6))
    rigid = [six for six in choices if _rank([*edges, *six]) == 18]
    faces = [{_face(*diagonal) for diagonal in six} for six in rigid]
    assert all(len(each) == 6 for each in faces)
    assert 0 < len(rigid) < len(choices)
    return (
        f"No. Of the {len(choices)} choices of six diagonals, only {len(rigid)} make the cube "
        "rigid. These are the ones with a diagonal in each of the six faces. A second diagonal "
        "in a face adds nothing, and the face without one can still fold."
    )


def _face(i: int, j: int) -> tuple[int, int]:
    """Return the axis that a diagonal is perpendicular to, and the coordinate of its face on it."""
    axis = 7 & ~(i ^ j)
    return axis, i & axis


def _rank(rods: list[tuple[int, int]]) -> int:
    """Return how many independent motions of the corners the rods prevent."""
    rows = numpy.zeros((len(rods), 24))
    for row, (i, j) in zip(rows, rods, strict=True):
        along = numpy.subtract(CORNERS[i], CORNERS[j])
        row[3 * i : 3 * i + 3], row[3 * j : 3 * j + 3] = along, -along
    return int(numpy.linalg.matrix_rank(rows))
