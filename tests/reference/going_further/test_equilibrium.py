"""Where worlds rest, against SciPy, closed forms and the balance of forces; and their sleep."""

from __future__ import annotations

import math

import numpy
import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import AnchoredCable, Cable
from ch08_mass_aggregate.bridge import Bridge, links_of
from ch08_mass_aggregate.bridge_plan import make_rows
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from studies.models.equilibrium import equilibrium
from studies.models.hanging_bridge import MASSES, hanging

DOWN = Vector3(0.0, -10.0)


def test_the_bridge_rests_where_scipy_has_it() -> None:
    rows = make_rows()
    for row, mass in zip(rows, MASSES, strict=True):
        for end in row:
            end.mass = mass
    world = ParticleWorld([end for row in rows for end in row], links_of(rows))
    tensions = equilibrium(world)
    for row, place in zip(rows, hanging(), strict=True):
        for end in row:
            assert (end.position.x, end.position.y) == pytest.approx(place, abs=1e-9)
    assert min(tensions[6:]) > 3.0  # all cables pull
    assert max(tensions[:6]) < 0.0  # and the rods across are pushed together


def test_slack_cables_pull_nothing_and_the_energy_is_the_least() -> None:
    """The problem is convex, so balanced forces are the state of least energy."""
    anchors = [(-2.0, 0.0), (2.0, 0.5), (0.0, 0.3)]
    lengths = [[1.6, 3.5, 2.4], [3.9, 1.8, 1.9]]
    masses = [1.0, 4.0]
    knots = [
        Particle(Vector3(x), acceleration=DOWN, mass=m)
        for x, m in zip((-1, 1), masses, strict=True)
    ]
    links = [
        AnchoredCable(knot, Vector3(*anchor), length)
        for knot, row in zip(knots, lengths, strict=True)
        for anchor, length in zip(anchors, row, strict=True)
    ]
    world = ParticleWorld(knots, [*links, Cable(*knots, 1.2)])
    tensions = equilibrium(world)
    places = numpy.array([(knot.position.x, knot.position.y) for knot in knots])
    ends = [(k, anchor) for k in (0, 1) for anchor in anchors]  # of the cables to anchors
    reach = [math.dist(places[k], anchor) for k, anchor in ends] + [math.dist(*places)]
    whole = [length for row in lengths for length in row] + [1.2]
    for pull, length, distance in zip(tensions, whole, reach, strict=True):
        assert pull >= 0.0
        assert distance < length + 1e-9  # a cable is slack or exactly taut, and none is too long
        assert abs(pull * (length - distance)) < 1e-7
    forces = numpy.array([(0.0, -10.0 * mass) for mass in masses])
    for pull, (k, anchor) in zip(tensions, ends, strict=False):
        forces[k] += pull * (numpy.array(anchor) - places[k]) / math.dist(anchor, places[k])
    between = tensions[-1] * (places[1] - places[0]) / math.dist(*places)
    forces += [between, -between]
    # The links hold 50 N in all, so this is a relative error of 2e-9.
    assert forces.ravel().tolist() == pytest.approx([0.0] * 4, abs=1e-7)
    assert 0.0 < sum(pull > 0.0 for pull in tensions) < 7


def test_a_spring_a_force_by_hand_and_the_ground_count() -> None:
    body = Particle(Vector3(0.3, 1.0), Vector3(1.0), DOWN, mass=2.0)
    lying = Particle(Vector3(5.0, 0.2), acceleration=DOWN)
    world = ParticleWorld([body, lying], [GroundPlane([lying])])
    world.registry.add(body, AnchoredSpring(Vector3(0.0, 2.0), 50.0, 1.0))
    body.add_force(Vector3(0.0, -5.0))
    assert equilibrium(world) == []
    assert tuple(body.position) == pytest.approx((0.0, 2.0 - 1.0 - 25.0 / 50.0, 0.0), abs=1e-8)
    assert tuple(body.velocity) == (0.0, 0.0, 0.0)
    assert tuple(body.force_accumulator) == (0.0, -5.0, 0.0)
    assert lying.position.y == pytest.approx(0.0, abs=1e-9)


def test_what_nothing_holds_has_no_equilibrium() -> None:
    with pytest.raises(ArithmeticError, match="check that something holds every particle"):
        equilibrium(ParticleWorld([Particle(acceleration=DOWN)]))


def test_a_bridge_sleeps_until_something_touches_it() -> None:
    bridge = Bridge(x=0.7)
    ends = [end for row in bridge.rows for end in row]
    world = SleepingWorld(ends, [*bridge.links])
    equilibrium(world)
    assert len(world.asleep) == len(ends)
    places = [tuple(end.position) for end in ends]
    for _ in range(40):
        world.step(1.0 / 60.0)
    assert [tuple(end.position) for end in ends] == places
    ends[3].velocity.y = -1.0
    world.step(1.0 / 60.0)
    assert not world.asleep
