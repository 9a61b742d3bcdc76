"""Claims of chapters 7 and 8: contacts, rods, the resolver, and structures of rods."""

from __future__ import annotations

import math
from collections.abc import Callable
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
from ch08_mass_aggregate.world import ParticleWorld, mechanical_energy
from reference.claims.ledger import claim

FRAME = 1.0 / 60.0
UP = Vector3(0.0, 1.0)
G = 9.81


@claim("fails", "A collision is perfectly elastic if it conserves momentum")
def elastic() -> list[str]:
    a, b = Particle(velocity=Vector3(3.0)), Particle(velocity=Vector3(-1.0), mass=2.0)
    before = a.kinetic_energy() + b.kinetic_energy()
    Contact(a, b, Vector3(-1.0), 0.5).resolve_velocity()
    momentum, left = a.momentum().x + b.momentum().x, a.kinetic_energy() + b.kinetic_energy()
    assert math.isclose(momentum, 3.0 - 2.0, rel_tol=1e-14)
    assert left < before - 1.0
    return [f"momentum stays {momentum:.0f} N s", f"from {before:.1f} J to {left:.1f} J"]


@claim("holds", "To push two bodies apart, move each in proportion")
def pushed_apart() -> list[str]:
    a, b = Particle(Vector3(0.9)), Particle(Vector3(), mass=9.0)
    light, heavy = Contact(a, b, Vector3(1.0), 0.0, 0.1).resolve_penetration()
    assert math.isclose(light.x - heavy.x, 0.1, rel_tol=1e-12)
    assert abs(light.x + 9.0 * heavy.x) < 1e-15
    return [f"moves by {light.x * 100:.0f} cm and the heavy one by {-heavy.x * 100:.0f} cm"]


@claim("holds if", "A body comes to rest if its contact does not bounce")
def resting() -> list[str]:
    hops = []
    for restitution, rule in ((0.5, FRAME), (0.9, FRAME), (0.5, 0.0), (0.9, 0.0)):
        ball = Particle(Vector3(0.0, 1e-6), acceleration=UP * -G)
        ground, heights = GroundPlane([ball], restitution=restitution), []
        for _ in range(120):
            ball.integrate(FRAME)
            for contact in ground.contacts():
                contact.resolve_velocity(rule)
                contact.resolve_penetration()
            heights.append(1000.0 * ball.position.y)
        hops.append(max(heights))
    assert hops[0] < hops[2]
    assert hops[1] < 0.1 * hops[3]
    return [
        f"hop by up to {hops[0]:.1f} and {hops[1]:.1f} mm within",
        f"without it by {hops[2]:.1f} and {hops[3]:.0f} mm",
    ]


@claim("holds if", "Twice as many iterations as there are contacts are enough")
def iterations() -> list[str]:
    sinks = []
    for count, visits in ((3, None), (10, None), (10, 50 * 10)):
        spheres = [Particle(UP * (i + 0.5), acceleration=UP * -10.0) for i in range(count)]
        generators = [GroundPlane(spheres, radius=0.5), ParticlePairs(spheres, 0.5)]
        resolver, deepest = ContactResolver(visits), 0.0
        for _ in range(120):
            semi_implicit_euler(spheres, lambda _: None, FRAME)
            resolver.resolve_contacts([c for g in generators for c in g.contacts()], FRAME)
            deepest = max(deepest, *(c.penetration for g in generators for c in g.contacts()))
        sinks.append(100.0 * deepest)
    few, many, patient = sinks
    assert max(few, patient) < 5.0 < 20.0 < many
    return [f"sink by {few:.1f} %, but ten by {many:.0f} %", f"the ten sink by {patient:.0f} %"]


@claim("holds", "Resolve the contact that closes fastest first")
def worst_first() -> list[str]:
    def impulses(closing_of: Callable[[list[Contact]], list[Contact]]) -> int:
        balls = [Particle(velocity=UP * -5.0) for _ in range(10)]
        contacts = [Contact(b, a, UP) for a, b in reversed(list(pairwise(balls)))]
        contacts.append(Contact(balls[0], None, UP))
        count = 0
        while closing := [c for c in contacts if c.separating_velocity() < -1e-3]:
            for contact in closing_of(closing):
                if contact.separating_velocity() < -1e-3:
                    contact.resolve_velocity()
                    count += 1
        return count

    worst = impulses(lambda closing: [min(closing, key=Contact.separating_velocity)])
    in_order = impulses(lambda closing: closing)
    assert worst < in_order
    return [
        f"{worst:,} impulses with the worst contact first, and {in_order:,} from",
        f"saves {100.0 * (1.0 - worst / in_order):.0f} % of",
    ]


@claim("holds", "Time steps that stop at each impact are accurate")
def time_division() -> list[str]:
    highest = []
    for divided in (True, False):
        ball = Particle(UP * 2.0, acceleration=UP * -G)
        ground, energies = GroundPlane([ball], restitution=1.0), []
        world = ParticleWorld([ball], [ground])
        for _ in range(1200):
            if divided:
                time_division_step([ball], ground, FRAME)
            else:
                world.step(FRAME)
            energies.append(mechanical_energy([ball]))
        highest.append(max(energies[1080:]) / G)
    assert math.isclose(highest[0], 2.0, rel_tol=1e-9)
    assert highest[1] < 0.01
    ball, stopped = Particle(UP * 2.0, acceleration=UP * -G), 0.0
    ground = GroundPlane([ball], restitution=0.5)
    try:
        while stopped < 10.0:
            time_division_step([ball], ground, FRAME)
            stopped += FRAME
    except TooManyImpacts as endless:
        stopped += endless.time
    last = math.sqrt(2.0 * 2.0 / G) * (1.0 + 0.5) / (1.0 - 0.5)
    assert abs(stopped - last) < 1e-6
    return [f"climbs to {highest[0]:.2f} m after 20 s", f"to rest after {last:.2f} s"]


@claim("holds", "A rod that makes both of its contacts in every frame")
def two_contacts() -> list[str]:
    errors = []
    for kind in (Rod, TwoSidedRod):
        bobs = [Particle(UP * (-0.1 * i), acceleration=UP * -10.0) for i in (1, 2, 3)]
        rods = [kind(a, b, 0.1) for a, b in pairwise([Particle(mass=math.inf), *bobs])]
        resolver, worst = ContactResolver(20), 0.0
        for _ in range(300):
            semi_implicit_euler(bobs, lambda _: None, FRAME)
            resolver.resolve_contacts([c for rod in rods for c in rod.contacts()], FRAME)
            lengths = [(rod.b.position - rod.a.position).magnitude() for rod in rods]
            worst = max(worst, *(abs(length - 0.1) for length in lengths))
        errors.append(1000.0 * worst)
    one, both = errors
    assert both < 0.2 * one
    return [f"By up to {one:.0f} mm with one contact and {both:.1f} mm with both"]


@claim("holds if", "A cube of eight particles needs 18 rods to be rigid")
def cube() -> list[str]:
    pairs = list(combinations(range(8), 2))
    edges = [(i, j) for i, j in pairs if (i ^ j) in (1, 2, 4)]
    choices = list(combinations([(i, j) for i, j in pairs if (i ^ j) in (3, 5, 6)], 6))
    rigid = [six for six in choices if _rank([*edges, *six]) == 18]
    assert 0 < len(rigid) < len(choices)
    for six in rigid:  # in different faces: each is perpendicular to an axis at a coordinate
        assert len({(axis := 7 & ~(i ^ j), i & axis) for i, j in six}) == 6
    return [f"Of the {len(choices)} choices of six diagonals, only {len(rigid)} make"]


def _rank(rods: list[tuple[int, int]]) -> int:
    """Return how many independent motions of the corners the rods prevent."""
    rows = numpy.zeros((len(rods), 24))
    for row, (i, j) in zip(rows, rods, strict=True):
        along = numpy.subtract(CORNERS[i], CORNERS[j])
        row[3 * i : 3 * i + 3], row[3 * j : 3 * j + 3] = along, -along
    return int(numpy.linalg.matrix_rank(rows))
