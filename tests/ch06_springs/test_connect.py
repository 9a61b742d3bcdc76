"""One spring for both ends, build task B6.3."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.probes import network, pair_swinging
from ch06_springs.springs import Connection, connect
from draw import Triple, positive_number, unit_vector, vector
from expect import expect_close, expect_error, expect_exactly, expect_that, xyz

ZERO = (0.0, 0.0, 0.0)
SWING = "book 6.3.2, Eq. 6.3, with the reduced mass m1 m2 / (m1 + m2)"
READ = "the docstring of Connection.update_force"
CONNECT = "the docstring of connect"


def hooke(offset: Triple, velocity: Triple, k: float, rest: float, c: float = 0.0) -> Triple:
    """Return the force of a spring on its end a. Both vectors are relative to its end b."""
    d = offset / abs(offset)
    return -(k * (abs(offset) - rest) + c * (velocity @ d)) * d


@pytest.mark.exercise("B6.3", asks="Add it to a, and add the exact opposite to b.", read=READ)
def test_a_connection_acts_on_both_ends(rng: Random) -> None:
    here, there, v, w = vector(rng), vector(rng), vector(rng), vector(rng)
    k, rest, c = positive_number(rng), positive_number(rng, 0.05, 0.2), positive_number(rng)
    wanted = hooke(here - there, v - w, k, rest, c)
    for end in ("a", "b"):
        cause = (
            "The force on a is spring_force(offset, velocity, stiffness, rest_length, damping), "
        )
        cause += "with a's position minus b's, and a's velocity minus b's. Add its opposite to b."
        with calls(cause):
            a = Particle(Vector3(*here), Vector3(*v), mass=2.0)
            b = Particle(Vector3(*there), Vector3(*w), mass=5.0)
            s = Connection(a, b, stiffness=k, rest_length=rest, damping=c)
        with calls(cause, f"s.update_force({end}, 0.25)", more=True):
            s.update_force(a if end == "a" else b, 0.25)
        on_a = a.force_accumulator
        slips = {
            "Each end gets only half of the force.": 0.5 * wanted,
            "You multiplied the force by the duration.": 0.25 * wanted,
            "You swapped the stiffness and the rest length.":
                hooke(here - there, v - w, rest, k, c),
            "Your damping uses only the velocity of a, but the motion of b changes the length too. "
            "Subtract b's velocity from a's.": hooke(here - there, v, k, rest, c),
            "You halved the stiffness.": hooke(here - there, v - w, 0.5 * k, rest, c),
            "Your damping has the wrong sign.": hooke(here - there, w - v, k, rest, c),
            "You left out the damping.": hooke(here - there, v - w, k, rest),
            "You add the velocities of a and b.": hooke(here - there, v + w, k, rest, c),
            "You subtract a's position from b's, so the force on a points in the wrong direction.":
                hooke(there - here, v - w, k, rest, c),
            "You swapped the forces on a and b.": -wanted,
            f"You added no force to a when {end} is passed to update_force. Take both ends from "
            "self.a and self.b, and add a force to each of them in every call.": ZERO,
        }  # fmt: skip
        then = "; {}.force_accumulator"
        # A few roundings of numbers up to 500.
        expect_close(on_a, wanted, slips, then=then.format("a"), unit="N", tolerance=1e-11)
        on_a = Triple(xyz(on_a))
        slips = {
            "Both ends get the same force, so your spring pushes them in the same direction.": on_a,
            "You added no force to b.": ZERO,
        }
        cause = "The force on b must be the exact opposite of a's. Compute it once for both ends."
        on_b = b.force_accumulator
        expect_close(on_b, -on_a, slips, then=then.format("b"), unit="N", cause=cause, tolerance=0)


@pytest.mark.exercise("B6.3", asks="pushes if it is shorter", read=READ)
def test_a_compressed_connection_pushes_its_ends_apart(rng: Random) -> None:
    k, rest = positive_number(rng), positive_number(rng, 1.0, 5.0)
    d, f, g = unit_vector(rng), vector(rng), vector(rng)
    with calls("The spring is shorter than its rest length, so it must push both ends apart."):
        a, b = Particle(Vector3(*(0.4 * rest * d))), Particle()
        a.add_force(Vector3(*f))
        b.add_force(Vector3(*g))
        Connection(a, b, stiffness=k, rest_length=rest).update_force(a, 0.5)
    push = 0.6 * k * rest * d
    slips = {
        "Your extension is abs(length - rest_length), as in the book's listing (E-3), so a "
        "compressed spring pulls. Remove abs to keep the sign.": f - push
    }
    got, then = a.force_accumulator, "; {}.force_accumulator"
    expect_close(got, f + push, slips, then=then.format("a"), unit="N", tolerance=1e-12)
    cause = "You removed the force that was added to b before. Use add_force, which keeps it."
    got = b.force_accumulator
    expect_close(got, g - push, then=then.format("b"), unit="N", cause=cause, tolerance=1e-12)


@pytest.mark.exercise("B6.3", asks="it has no direction, so its force is zero", read=READ)
def test_connected_ends_at_the_same_position_get_no_force(rng: Random) -> None:
    place, v = vector(rng), vector(rng)
    with calls("Both ends are at the same position, so the length is 0. Add no force then."):
        a, b = Particle(Vector3(*place), Vector3(*v)), Particle(Vector3(*place))
        s = Connection(a, b, stiffness=100.0, rest_length=2.0, damping=3.0)
        s.update_force(a, 0.5)
    for name, end in (("a", a), ("b", b)):
        expect_close(end.force_accumulator, ZERO, then=f"; {name}.force_accumulator", unit="N")
    with calls("The ends are 1 m apart now, so the spring and its damping act.", more=True):
        a.position.x += 1.0
        s.update_force(a, 0.5)
        got = a.force_accumulator
    # The offset of 1 m is 1e-15 m off at such positions.
    expect_close(got, (100.0 - 3.0 * v[0], 0.0, 0.0), tolerance=1e-11, unit="N")
    with calls("The ends are 1e-9 m apart, which is not 0, so the spring must push with 200 N."):
        a, b = Particle(Vector3(0.0, 1e-9, 0.0)), Particle()
        s = Connection(a, b, stiffness=100.0, rest_length=2.0)
        s.update_force(a, 0.5)
        got = a.force_accumulator
    expect_close(got, (0.0, 200.0, 0.0), tolerance=1e-6, unit="N")
    with calls("The force is now 5 (3 - 2) - 2. Read the attributes in every call.", more=True):
        s.stiffness, s.rest_length, s.damping = 5.0, 3.0, 2.0
        a.clear_forces()
        a.position.y, a.velocity.y = 2.0, 1.0
        s.update_force(a, 0.5)
        got = a.force_accumulator
    expect_close(got, (0.0, 3.0, 0.0), unit="N")


@pytest.mark.exercise("B6.3", asks="registered for a, or for b if a is immovable", read=CONNECT)
def test_connect_registers_the_spring_once(rng: Random) -> None:
    here, there, k, rest = vector(rng), vector(rng), positive_number(rng), positive_number(rng)
    for mass_a, mass_b in ((2.0, 3.0), (math.inf, 3.0), (2.0, math.inf)):
        with calls("Register one Connection with these numbers once, for an end that can move."):
            a = Particle(Vector3(*here), mass=mass_a)
            b = Particle(Vector3(*there), mass=mass_b)
            registry = ForceRegistry()
            connect(registry, a, b, stiffness=k, rest_length=rest)
            registry.update_forces(0.5)
        unmoved = "You didn't register the spring. Add it to the registry for one of its ends."
        if math.inf in (mass_a, mass_b):
            unmoved = "Your spring has no effect. Either you registered it for an immovable end, "
            unmoved += "which the registry skips, or not at all. Register it for the other end."
        for name, end, mass, offset in (
            ("a", a, mass_a, here - there),
            ("b", b, mass_b, there - here),
        ):
            force = hooke(offset, offset, k, rest)
            slips = {
                unmoved: ZERO,
                "Your spring acts twice, because you registered it for both ends.": 2.0 * force,
                "You swapped the stiffness and the rest length. Pass the stiffness first.":
                    hooke(offset, offset, rest, k),
            }  # fmt: skip
            if mass < math.inf:
                then, got = f"; {name}.force_accumulator", end.force_accumulator
                expect_close(got, force, slips, then=then, unit="N", tolerance=1e-11)


@pytest.mark.exercise("B6.3", asks="acts on both, and return the spring", read=CONNECT)
def test_connect_returns_the_spring(rng: Random) -> None:
    here, there = vector(rng), vector(rng)
    k, rest, c = positive_number(rng), positive_number(rng, 0.05, 0.2), positive_number(rng)
    with calls("Create one Connection with the ends a and b, register it, and return it."):
        a, b, registry = Particle(Vector3(*here)), Particle(Vector3(*there)), ForceRegistry()
        s = connect(registry, a, b, stiffness=k, rest_length=rest, damping=c)
    nothing = "connect returned nothing. Return the Connection that it registers."
    expect_that(s is not None, "nothing (None)", "a Connection", cause=nothing)
    got, slips = (
        (s.stiffness, s.rest_length, s.damping),
        {"You left out the damping.": (k, rest, 0)},
    )
    cause = "Pass the stiffness, the rest length and the damping to Connection."
    expect_close(got, (k, rest, c), slips, then="; the three numbers of s", cause=cause)
    slips = {"You swapped a and b. Pass them to Connection in this order.": (*there, *here)}
    got, then = (*xyz(s.a.position), *xyz(s.b.position)), "; the positions of s.a and s.b"
    expect_close(got, (*here, *there), slips, then=then, tolerance=0.0)
    with calls("Register the spring that you return, and read its stiffness each time.", more=True):
        s.stiffness = 2.0 * k
        registry.update_forces(0.5)
        got = a.force_accumulator
    wanted = hooke(here - there, here - there, 2.0 * k, rest)
    expect_close(got, wanted, unit="N", tolerance=1e-11)
    with calls("Register the spring only once, and for a, so that this removes it.", more=True):
        a.clear_forces()
        b.clear_forces()
        registry.remove(a, s)
        registry.update_forces(0.5)
    for name, end in (("a", a), ("b", b)):
        expect_close(end.force_accumulator, ZERO, then=f"; {name}.force_accumulator", unit="N")


@pytest.mark.exercise(
    "B6.3",
    asks="the total momentum of both particles stays constant",
    read="book 3.2.3, and the docstring of Connection.update_force",
)
def test_a_network_of_springs_keeps_its_momentum(rng: Random) -> None:
    bodies = [(vector(rng), vector(rng), positive_number(rng, 1.0)) for _ in range(8)]
    with calls(
        "Each spring must give one end what the other one loses, so its forces are opposite.",
        "8 particles, each joined to all others by connect(registry, a, b, stiffness=2.0, "
        "rest_length=3.0, damping=0.5); 200 steps of registry.update_forces(h) and p.integrate(h)",
    ):
        ends, away = network(bodies, (2.0, 3.0, 0.5))
    before = [math.fsum(mass * v[i] for _, v, mass in bodies) for i in range(3)]
    # Each of 200 frames rounds 8 velocities, and 56 forces, at some 1e-15 of what they are.
    expect_close(ends, before, then="; the total momentum", unit="kg m/s", tolerance=1e-10)
    cause = "The particles move as if there were no springs. Check that each is registered."
    moved = "; the springs moved the first particle by more than 1 mm"
    expect_exactly(away > 1e-3, True, then=moved, cause=cause)


@pytest.mark.exercise("B6.3", asks="pulls on both ends with opposite forces", read=SWING)
def test_two_bodies_swing_about_each_other_with_the_reduced_mass() -> None:
    """Only here both ends move for a whole period, whose length has a closed form."""
    with calls(
        "The period is 2 pi sqrt(mu / k), with mu = m1 m2 / (m1 + m2), here 0.75 kg.",
        "a of 1 kg and b of 3 kg with connect(registry, a, b, stiffness=5.0, rest_length=1.0), "
        "stretched to 1.5 m and released; steps of 1/2000 s; the period of the oscillation",
    ):
        period = pair_swinging((1.0, 3.0), 5.0, 1.0)
    # Explicit Euler's own error in the period is w^2 h^2 / 3, some 5e-7 of it.
    expect_close(period, 2.43346721, tolerance=1e-4, unit="s")


@pytest.mark.exercise("B6.3", asks="between two immovable ends has no effect", read=CONNECT)
def test_two_immovable_ends_may_be_connected() -> None:
    with calls("A spring between two immovable ends has no effect, but connect must accept it."):
        a, b, registry = Particle(mass=math.inf), Particle(mass=math.inf), ForceRegistry()
        connect(registry, a, b, stiffness=3.0, rest_length=0.0)
        registry.update_forces(0.5)
    with calls("Both ends can move, so register the spring for one of them.", more=True):
        a, b = Particle(), Particle(Vector3(1.0, 0.0, 0.0))
        connect(registry, a, b, stiffness=3.0, rest_length=0.0)
        registry.update_forces(0.5)
        got = b.force_accumulator
    expect_close(got, (-3.0, 0.0, 0.0), unit="N")


@pytest.mark.exercise("B6.3", asks="pass the error on and register nothing", read=CONNECT)
@pytest.mark.robust
def test_connect_rejects_invalid_numbers() -> None:
    a, b, registry = Particle(), Particle(Vector3(1.0, 0.0, 0.0)), ForceRegistry()
    for name, bad in (
        ("stiffness", (-1.0, 1.0, 0.0)),
        ("rest length", (1.0, -1.0, 0.0)),
        ("damping", (1.0, 1.0, -1.0)),
        ("stiffness", (math.nan, 1.0, 0.0)),
    ):
        expect_error(
            lambda bad=bad: connect(registry, a, b, *bad),
            ValueError,
            allowed=lambda: connect(ForceRegistry(), a, b, 1.0, 1.0, 0.0),
            call="connect(registry, a, b, stiffness={}, rest_length={}, damping={})".format(*bad),
            cause=f"Your connect accepts a negative {name}. Pass it unchanged to Connection, whose "
            "constructor raises the ValueError.",
        )
    with calls(
        "A call that raises an error must register nothing. Create the spring first.",
        "connect(registry, a, b, ...) with an argument that is not valid; "
        "registry.update_forces(0.5)",
    ):
        registry.update_forces(0.5)
    expect_close(b.force_accumulator, ZERO, then="; b.force_accumulator", unit="N")
    near = Particle(), Particle(Vector3(1.0, 0.0, 0.0))
    for stiffness, damping in ((1e308, 0.0), (0.0, 1e308)):
        with calls("This force is too large for a float. Use add_force, which raises the error."):
            a = Particle(Vector3(1e10, 0.0, 0.0), Vector3(1e10, 0.0, 0.0))
            b = Particle(Vector3(-1e10, 0.0, 0.0), Vector3(-1e10, 0.0, 0.0))
            s = Connection(a, b, stiffness, 1.0, damping)
        expect_error(
            lambda s=s, a=a: s.update_force(a, 0.5),
            ValueError,
            then="; s.update_force(a, 0.5)",
            allowed=lambda: Connection(*near, 1.0, 1.0).update_force(near[0], 0.5),
            read=READ,
        )
