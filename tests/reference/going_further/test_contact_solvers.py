"""The other contact solvers against closed forms, SciPy and pymunk: forces, impacts, energy."""

from __future__ import annotations

import math
import random
from itertools import pairwise
from typing import Any

import numpy
import pymunk
import pytest
from scipy.optimize import nnls  # type: ignore[import-untyped]

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact
from ch07_constraints.detectors import GroundPlane, ParticlePairs
from ch07_constraints.going_further.sequential_impulses import SequentialImpulses
from ch07_constraints.going_further.small_steps import SmallSteps
from ch07_constraints.links import AnchoredCable, AnchoredRod, TwoSidedRod
from ch08_mass_aggregate.world import mechanical_energy
from plots.ch07_constraints.stacks import falling_pile

DOWN = Vector3(0.0, -10.0)
H = 1.0 / 60.0  # s
SOLVERS = [SequentialImpulses, SmallSteps]


def stack(count: int) -> tuple[list[Particle], list[Any]]:
    """Return spheres of 1 kg to count kg, from the bottom to the top, that just touch."""
    spheres = [
        Particle(Vector3(0.0, i + 0.5), acceleration=DOWN, mass=i + 1.0) for i in range(count)
    ]
    return spheres, [GroundPlane(spheres, radius=0.5), ParticlePairs(spheres, 0.5)]


def test_a_stack_at_rest_gains_no_energy_and_each_contact_carries_what_is_above_it() -> None:
    spheres, generators = stack(6)
    solver, start = SequentialImpulses(spheres, generators), mechanical_energy(spheres)
    for _ in range(300):
        solver.step(H)
        assert mechanical_energy(spheres) <= start
    # In N s per step: the ground carries 21 kg, the first pair 20 kg, the next one 18 kg, ...
    carried = [impulse.magnitude() / (10.0 * H) for impulse in solver.impulses.values()]
    assert sorted(carried) == pytest.approx([6.0, 11.0, 15.0, 18.0, 20.0, 21.0], rel=1e-6)
    assert sum(sphere.kinetic_energy() for sphere in spheres) < 1e-12


@pytest.mark.parametrize("compliance", [1e-3, 1e-9, 0.0])
def test_a_soft_cable_stretches_by_m_g_over_k(compliance: float) -> None:
    weight = Particle(Vector3(0.0, -2.0), acceleration=DOWN, mass=3.0)
    solver = SmallSteps([weight], [AnchoredCable(weight, Vector3(), 2.0)], compliance)
    for _ in range(600):
        solver.step(H)
    assert -2.0 - weight.position.y == pytest.approx(3.0 * 10.0 * compliance, abs=1e-12)


@pytest.mark.parametrize("kind", SOLVERS)
def test_an_impact_conserves_momentum_and_returns_the_restitution_as_in_pymunk(kind: Any) -> None:
    """1 kg with 3 m/s hits 2 kg with -1 m/s at c = 0.5: they leave with -1 and 1 m/s."""
    a, b = Particle(Vector3(-1.0), Vector3(3.0)), Particle(Vector3(1.0), Vector3(-1.0), mass=2.0)
    solver = kind([a, b], [ParticlePairs([a, b], 0.25, 0.5)])
    space = pymunk.Space()
    for particle in (a, b):
        body = pymunk.Body(particle.mass, math.inf)
        body.position, body.velocity = (particle.position.x, 0.0), (particle.velocity.x, 0.0)
        shape = pymunk.Circle(body, 0.25)
        shape.elasticity = math.sqrt(0.5)
        space.add(body, shape)
    for _ in range(60):
        solver.step(H)
        space.step(H)
        assert a.momentum().x + b.momentum().x == pytest.approx(1.0, abs=1e-12)
    assert (a.velocity.x, b.velocity.x) == pytest.approx((-1.0, 1.0), abs=1e-12)
    theirs = [body.velocity.x for body in space.bodies]
    assert theirs == pytest.approx([-1.0, 1.0], abs=1e-9)


def test_many_visits_find_the_impulses_that_scipy_finds() -> None:
    """Frictionless contacts without bounce: the closest velocities at which nothing closes."""
    draw = random.Random(37)
    spheres, contacts = falling_pile()
    for sphere in spheres:
        sphere.mass = draw.uniform(0.5, 2.0)
        sphere.velocity.x = draw.uniform(-1.0, 1.0)
    index = {sphere: i for i, sphere in enumerate(spheres)}
    rows = numpy.zeros((len(contacts), len(spheres), 3))
    for row, contact in zip(rows, contacts, strict=True):
        row[index[contact.particle]] += [*contact.normal]
        if contact.other is not None:
            row[index[contact.other]] -= [*contact.normal]
    roots = numpy.sqrt(numpy.array([[sphere.mass] * 3 for sphere in spheres]))
    before = numpy.array([[*sphere.velocity] for sphere in spheres])
    matrix = (rows / roots).reshape(len(contacts), -1).T
    impulses, _ = nnls(matrix, -(roots * before).ravel())
    wanted = before + (matrix @ impulses).reshape(before.shape) / roots

    class Given:
        def contacts(self) -> list[Contact]:
            return contacts

    SequentialImpulses(spheres, [Given()], 400).step(1e-9)
    found = numpy.array([[*sphere.velocity] for sphere in spheres])
    assert numpy.abs(found - wanted).max() < 1e-9
    assert numpy.abs(found - before).max() > 0.5


@pytest.mark.parametrize("kind", SOLVERS)
def test_a_pendulum_has_its_period(kind: Any) -> None:
    """Released horizontally, 4 sqrt(l / g) K(1 / 2) = 2.34523957 s for 1 m and 10 m/s^2."""
    errors = []
    for steps in (500, 1000):  # per second
        bob = Particle(Vector3(1.0), acceleration=DOWN)
        nail = Particle(mass=math.inf)
        link: Any = AnchoredRod(bob, Vector3(), 1.0)
        if kind is SequentialImpulses:
            link = TwoSidedRod(nail, bob, 1.0)
        solver, time, crossings = kind([nail, bob], [link]), 0.0, []
        while len(crossings) < 3:
            before = bob.position.x
            solver.step(1.0 / steps)
            time += 1.0 / steps
            if before * bob.position.x < 0.0:
                share = bob.position.x / (bob.position.x - before)
                crossings.append(time - share / steps)
        errors.append(abs(crossings[2] - crossings[0] - 2.34523957))
    assert errors[1] < 0.01 * 2.34523957
    assert errors[0] / errors[1] == pytest.approx(2.0, rel=0.1)  # order 1


def test_a_rope_with_a_weight_comes_to_rest_at_its_length() -> None:
    """The impulses are remembered, so four visits per step end at the weight below each rod."""
    joints = [Particle(Vector3(0.0, -0.1 * i), acceleration=DOWN) for i in range(6)]
    joints[0].mass, joints[-1].mass = math.inf, 3.0
    solver = SequentialImpulses(joints, [TwoSidedRod(a, b, 0.1) for a, b in pairwise(joints)])
    for _ in range(600):
        solver.step(H)
    assert joints[-1].position.y == pytest.approx(-0.5, abs=1e-6)
    pulls = [impulse.magnitude() / (10.0 * H) for impulse in solver.impulses.values()]
    assert pulls == pytest.approx([7.0, 6.0, 5.0, 4.0, 3.0], rel=1e-6)


def test_a_row_of_balls_bounces_as_one_block() -> None:
    """The lesson's warning: v + 2 u = 1 and u - v = 1, so v = -1/3 and u = 2/3 m/s."""
    balls = [Particle(Vector3(0.5 * i), Vector3(float(i == 0))) for i in range(3)]
    SequentialImpulses(balls, [ParticlePairs(balls, 0.25, 1.0)], 100).step(H)
    speeds = [ball.velocity.x for ball in balls]
    assert speeds == pytest.approx([-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0], abs=1e-9)
