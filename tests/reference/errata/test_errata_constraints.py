"""The errata of chapter 7: the printed form fails, and the correct form next to it does not."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch06_springs.integrators import explicit_euler, semi_implicit_euler
from ch07_constraints.contacts import Contact, ContactResolver
from ch07_constraints.exercises import restitution_of_drop
from ch07_constraints.links import Rod, TwoSidedRod

FRAME = 1.0 / 60.0
UP = Vector3(0.0, 1.0, 0.0)


def test_e7_momentum_is_kept_at_any_restitution_and_energy_at_1_alone() -> None:
    for c, lost in ((0.0, 16.0 / 3.0), (0.5, 4.0), (1.0, 0.0)):
        a, b = Particle(velocity=Vector3(3.0)), Particle(velocity=Vector3(-1.0), mass=2.0)
        Contact(a, b, Vector3(-1.0), c).resolve_velocity()
        # A few roundings of some m/s and some J.
        assert a.momentum().x + b.momentum().x == pytest.approx(1.0, abs=4e-15)
        assert 5.5 - a.kinetic_energy() - b.kinetic_energy() == pytest.approx(lost, abs=2e-14)


def test_e8_the_printed_resolver_moves_a_contact_out_again_and_again() -> None:
    """A contact of 0.1 m ends 0.1 m up, if its depth is not updated."""
    for printed, end in ((True, 0.1), (False, 0.0)):
        ball = Particle(Vector3(0.0, -0.1))
        contact = Contact(ball, None, UP, 0.0, 0.1)
        if printed:
            for _ in range(2):  # worst separating velocity first, both parts at once
                contact.resolve_velocity(FRAME)
                ball.position.add_scaled(contact.normal, contact.penetration)
        else:
            ContactResolver().resolve_contacts([contact], FRAME)
        assert ball.position.y == pytest.approx(end, abs=1e-17)


def chain_error(kind: type[Rod], links: int, iterations: int) -> tuple[float, int]:
    """Return the largest error in 5 s of a rod of 10 cm in a hanging chain, and the iterations."""
    bobs = [Particle(UP * (-0.1 * i), acceleration=UP * -10.0) for i in range(1, links + 1)]
    rods = [kind(a, b, 0.1) for a, b in pairwise([Particle(mass=math.inf), *bobs])]
    resolver, worst, used = ContactResolver(iterations), 0.0, 0
    for _ in range(300):
        semi_implicit_euler(bobs, lambda _: None, FRAME)
        resolver.resolve_contacts([contact for rod in rods for contact in rod.contacts()], FRAME)
        used += resolver.iterations_used
        lengths = [(rod.b.position - rod.a.position).magnitude() for rod in rods]
        worst = max(worst, *(abs(length - 0.1) for length in lengths))
    return worst, used


def test_e9_two_contacts_hold_a_chain_better_than_the_one_of_the_listing() -> None:
    """The same number of iterations per phase makes the cost about equal."""
    assert chain_error(Rod, 3, 20)[0] == pytest.approx(12e-3, abs=5e-4)
    assert chain_error(TwoSidedRod, 3, 20) == (pytest.approx(0.5e-3, abs=5e-6), 300 * 2 * 20)
    # With five times the iterations, only the rods with two contacts get better.
    error, used = chain_error(Rod, 3, 100)
    assert error == pytest.approx(10e-3, abs=5e-4)
    assert used == pytest.approx(300 * 2 * 100, rel=0.02)  # so one contact is not cheaper
    assert chain_error(TwoSidedRod, 3, 100)[0] == pytest.approx(0.2e-6, abs=5e-8)
    # A single rod does not show the difference: its error is that of rounding.
    assert max(chain_error(kind, 1, 20)[0] for kind in (Rod, TwoSidedRod)) < 1e-16


def test_e10_without_the_root_a_ball_bounces_too_low() -> None:
    """Dropped from 1 m, a ball with c = 0.25 rises 6.25 cm, and a ball with c = 0.5 25 cm."""
    heights = []
    for c in (0.25 / 1.0, restitution_of_drop(1.0, 0.25)):
        ball = Particle(velocity=UP * -math.sqrt(20.0))
        Contact(ball, None, UP, c).resolve_velocity()
        heights.append(ball.velocity.y**2 / 20.0)
    assert heights == pytest.approx([0.0625, 0.25], rel=1e-15)  # two roundings


def test_e24_an_impulse_changes_velocities_by_its_share_of_the_mass() -> None:
    """If 4 N s is printed as a change in velocity, both get 4 m/s, which creates momentum."""
    a, b = Particle(velocity=Vector3(3.0), mass=2.0), Particle(velocity=Vector3(-3.0), mass=1.0)
    Contact(a, b, Vector3(-1.0), 0.0).resolve_velocity()
    impulse = 2.0 / 3.0 * 6.0  # reduced mass times closing speed
    # The tolerance allows for roundings of thirds.
    assert (a.velocity.x, b.velocity.x) == pytest.approx((3.0 - impulse / 2.0, -3.0 + impulse))
    assert a.momentum().x + b.momentum().x == pytest.approx(3.0, abs=1e-14)
    printed = 2.0 * (3.0 - impulse) + (-3.0 + impulse)
    assert printed == -1.0


def test_e25_without_the_minus_a_ball_moves_on_into_the_ground() -> None:
    ball = Particle(velocity=Vector3(0.0, -4.0))
    contact = Contact(ball, None, UP, 0.5)
    without_minus = 0.5 * contact.separating_velocity()
    assert without_minus == -2.0  # the contact is still closing
    assert contact.velocity_after() == 2.0


def highest(*, printed: bool, built_in: bool) -> float:
    """Return the largest height in the last 5 s of 10 s on the ground, with the book's step."""
    ball = Particle(Vector3(0.0, 1e-5), acceleration=UP * (-10.0 if built_in else 0.0))
    registry, top = ForceRegistry(), 0.0
    if not built_in:
        registry.add(ball, Gravity(UP * -10.0))
    for frame in range(600):
        explicit_euler([ball], registry.update_forces, FRAME)
        if ball.position.y <= 0.0:
            contact = Contact(ball, None, UP, 0.9, -ball.position.y)
            if printed:
                closing = contact.separating_velocity()
                if closing < 0.0:
                    bounce, built_up = -0.9 * closing, ball.acceleration.y * FRAME
                    if built_up < 0.0:
                        bounce = max(0.0, bounce + 0.9 * built_up)
                    ball.velocity.y = bounce
                contact.resolve_penetration()
            else:
                contact.resolve(FRAME)
        if frame >= 300:
            top = max(top, ball.position.y)
    return top


def test_e26_the_printed_rule_for_rest_shakes_what_a_generator_pulls_down() -> None:
    """After 5 s it is 2.6 mm with built-in gravity and 198 mm with a generator's gravity."""
    assert highest(printed=True, built_in=True) == pytest.approx(2.6e-3, abs=5e-5)
    assert highest(printed=True, built_in=False) == pytest.approx(0.198, abs=5e-4)
    for built_in in (True, False):  # with all of the acceleration, both are the same
        assert highest(printed=False, built_in=built_in) == pytest.approx(2.6e-3, abs=5e-5)
