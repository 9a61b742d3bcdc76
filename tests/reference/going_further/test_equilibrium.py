"""Where worlds rest: against closed forms and SciPy's least potential energy; and their sleep."""

from __future__ import annotations

import math

import numpy
import pytest
from scipy.optimize import minimize

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch06_springs.springs import AnchoredSpring
from ch07_constraints.detectors import GroundPlane
from ch07_constraints.links import AnchoredCable, Cable
from ch08_mass_aggregate.bridge import Bridge, links_of
from ch08_mass_aggregate.bridge_plan import make_rows
from ch08_mass_aggregate.equilibrium import equilibrium
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld
from studies.accuracy.scenes.bridge import MASSES, hanging

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


def test_slack_cables_and_the_least_energy_are_those_of_scipy() -> None:
    """Two knots on three cables each, of which some are too long to be taut."""
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

    def spare(flat: numpy.ndarray) -> list[float]:
        places = flat.reshape(2, 2)
        found = [
            length**2 - math.dist(place, anchor) ** 2
            for place, row in zip(places, lengths, strict=True)
            for anchor, length in zip(anchors, row, strict=True)
        ]
        return [*found, 1.2**2 - math.dist(*places) ** 2]

    best = minimize(
        lambda flat: 10.0 * (masses[0] * flat[1] + masses[1] * flat[3]),
        [-1.0, -0.5, 1.0, -0.5],
        method="SLSQP",
        constraints={"type": "ineq", "fun": spare},
        options={"ftol": 1e-12, "maxiter": 500},
    )
    assert best.success
    found = [part for knot in knots for part in (knot.position.x, knot.position.y)]
    assert found == pytest.approx(best.x, abs=1e-5)  # SLSQP's differences are no better
    assert 0.0 < sum(pull > 0.0 for pull in tensions) < 7
    # A cable is slack or exactly taut, and none is too long.
    for pull, left in zip(tensions, spare(numpy.array(found)), strict=True):
        assert left > -1e-9
        assert abs(pull * left) < 1e-7


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


def test_the_ball_on_the_bridge_rests_on_its_row() -> None:
    bridge = Bridge(x=0.7)
    equilibrium(bridge.world)
    left, right = (end.position for end in bridge.rows[3])
    assert left.y == pytest.approx(right.y, abs=1e-9)
    before = [[*p.position] for p in bridge.world.particles]
    for _ in range(60):
        bridge.step(1.0 / 60.0)
    moved = [math.dist(p.position, q) for p, q in zip(bridge.world.particles, before, strict=True)]
    assert max(moved) < 0.02  # the resolver lets the bridge give by a few millimeters


def test_what_nothing_holds_has_no_equilibrium() -> None:
    with pytest.raises(ArithmeticError, match="check that something holds every particle"):
        equilibrium(ParticleWorld([Particle(acceleration=DOWN)]))


def test_a_bridge_sleeps_until_something_touches_it() -> None:
    bridge = Bridge(x=0.7)
    ends = [end for row in bridge.rows for end in row]
    world = SleepingWorld(ends, links_of_at(bridge))
    equilibrium(world)
    assert len(world.asleep) == len(ends)
    places = [tuple(end.position) for end in ends]
    for _ in range(40):
        world.step(1.0 / 60.0)
    assert [tuple(end.position) for end in ends] == places
    ends[3].velocity.y = -1.0
    world.step(1.0 / 60.0)
    assert not world.asleep


def links_of_at(bridge: Bridge) -> list:  # type: ignore[type-arg]
    return [*bridge.links]
