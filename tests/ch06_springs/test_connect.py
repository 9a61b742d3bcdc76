"""One spring for both ends, build task B6.3."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch06_springs.probes import network, pair_swinging
from ch06_springs.springs import Connection, connect
from draw import components, direction, positive_number
from expect import about, blame, expect_close, expect_error, expect_exactly, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "the docstring of Connection.update_force"
CONNECT = "the docstring of connect"


def tension(
    a: tuple[float, ...],
    v: tuple[float, ...],
    b: tuple[float, ...],
    w: tuple[float, ...],
    numbers: tuple[float, float, float],
) -> tuple[float, ...]:
    """Return the force of a spring on its end a."""
    k, rest, c = numbers
    offset = [p - q for p, q in zip(a, b, strict=True)]
    length = math.hypot(*offset)
    rate = sum(o * (p - q) for o, p, q in zip(offset, v, w, strict=True)) / length
    return tuple(-(k * (length - rest) + c * rate) / length * o for o in offset)


@pytest.mark.exercise("B6.3")
def test_a_connection_serves_both_ends(rng: Random) -> None:
    about.read = READ
    here, there, v, w = (components(rng) for _ in range(4))
    numbers = positive_number(rng), positive_number(rng, 0.05, 0.2), positive_number(rng)
    about.call = f"a at {here}, velocity {v}; b at {there}, velocity {w}; "
    about.call += "Connection(a, b, {}, {}, {})".format(*numbers)
    wanted = tension(here, v, there, w, numbers)
    for end in ("a", "b"):
        a = Particle(Vector3(*here), Vector3(*v), mass=2.0)
        b = Particle(Vector3(*there), Vector3(*w), mass=5.0)
        name = f"{about.call}.update_force({end}, 0.5)"
        about.cause = (
            "The force on a is spring_force for a's position and velocity relative to b, whichever "
            f"end the registry passes (here {end})."
        )
        Connection(a, b, *numbers).update_force(a if end == "a" else b, 0.5)
        on_a, on_b = xyz(a.force_accumulator), xyz(b.force_accumulator)
        k, rest, _ = numbers
        both = tuple(p + q for p, q in zip(v, w, strict=True))
        slips = {
            "The force is half of what it should be. Don't split it between the ends: each gets "
            "the whole spring_force, in opposite directions.": [0.5 * part for part in wanted],
            "Your force ignores the damping. Add the term -c l', which acts along the "
            "spring.": tension(here, v, there, w, (k, rest, 0.0)),
            "Your force uses the sum of the two velocities. The rate at which the length changes "
            "depends on their difference, so subtract "
            "b's velocity from a's.": tension(here, both, there, ZERO, numbers),
            "Your offset is b's position minus a's, so the spring pulls when it should push. Use "
            "a's position minus b's.": tension(there, v, here, w, numbers),
            (
                "This is the force on b. The force on a is the same whichever end is passed to "
                "update_force, so always use a's position minus b's."
            ): [-part for part in wanted],
            "The force on a is still zero. Call a.add_force with the spring force.": ZERO,
        }
        blame(on_a, slips)
        # A few roundings of numbers up to 500.
        expect_close(on_a, wanted, call=f"{name}; a.force_accumulator", tolerance=1e-11)
        about.cause = (
            "Every force has an equal and opposite reaction. Apply exactly the opposite of a's "
            "force to b, so that momentum is conserved."
        )
        blame(
            on_b,
            {
                "Both ends get the same force, so the spring would push the whole pair along. "
                "Apply the opposite of a's force to b.": on_a,
                "The force on b is still zero. Call b.add_force with the opposite of the force on "
                "a.": ZERO,
            },
        )
        opposite = tuple(-part for part in on_a)
        expect_close(on_b, opposite, call=f"{name}; b.force_accumulator", tolerance=0.0)


@pytest.mark.exercise("B6.3")
def test_a_compressed_connection_pushes_its_ends_apart(rng: Random) -> None:
    about.read = READ
    k, rest = positive_number(rng), positive_number(rng, 1.0, 5.0)
    d, f = direction(rng), components(rng)
    offset = tuple(0.4 * rest * part for part in d)
    about.call = f"a at {offset}, b at (0, 0, 0); b.add_force(Vector3{f}); a.add_force(Vector3(1, "
    about.call += f"2, 3)); Connection(a, b, {k}, {rest}).update_force(a, 0.5)"
    about.cause = (
        "This connection is shorter than its rest length, so it should push its two ends apart."
    )
    a, b = Particle(Vector3(*offset)), Particle()
    b.add_force(Vector3(*f))
    a.add_force(Vector3(1.0, 2.0, 3.0))
    Connection(a, b, k, rest).update_force(a, 0.5)
    wanted = tuple(g + 0.6 * k * rest * part for g, part in zip((1, 2, 3), d, strict=True))
    got = xyz(a.force_accumulator)
    pulled = [g - 0.6 * k * rest * part for g, part in zip((1, 2, 3), d, strict=True)]
    blame(
        got,
        {
            "Your extension is abs(l - l0), as in the book's listing (E-3), so a compressed spring "
            "pulls instead of pushing. Remove abs to keep the sign.": pulled
        },
    )
    expect_close(got, wanted, then="; a.force_accumulator", tolerance=1e-12)
    wanted = tuple(g - 0.6 * k * rest * part for g, part in zip(f, d, strict=True))
    got = xyz(b.force_accumulator)
    about.cause = (
        "The force on b is wrong. If you lost the forces that were already on b, call add_force, "
        "which adds to them."
    )
    expect_close(got, wanted, then="; b.force_accumulator", tolerance=1e-12)


@pytest.mark.exercise("B6.3")
def test_connected_ends_at_one_place_feel_nothing(rng: Random) -> None:
    about.read = READ
    place, v = components(rng), components(rng)
    about.call = f"a and b at {place}, a with velocity {v}; c = Connection(a, b, 100.0, 2.0, 3.0); "
    about.call += "c.update_force(a, 0.5)"
    about.cause = (
        "Both ends are at the same position, so the spring has no direction and exerts no force. "
        "Make sure that your code doesn't divide 0 by 0."
    )
    a, b = Particle(Vector3(*place), Vector3(*v)), Particle(Vector3(*place))
    c = Connection(a, b, 100.0, 2.0, 3.0)
    c.update_force(a, 0.5)
    for name, end in (("a", a), ("b", b)):
        got = xyz(end.force_accumulator)
        expect_close(got, ZERO, then=f"; {name}.force_accumulator")
    about.call += "; a.position.x += 1.0; c.update_force(a, 0.5); a.force_accumulator"
    about.cause = (
        "The ends are now 1 m apart, so the spring acts again. It pushes with 100 N, less a "
        "damping force of 3 N s/m times the speed."
    )
    a.position.x += 1.0
    c.update_force(a, 0.5)
    wanted = (100.0 - 3.0 * v[0], 0.0, 0.0)
    got = xyz(a.force_accumulator)
    # The offset of 1 m is 1e-15 m off at such places.
    expect_close(got, wanted, tolerance=1e-11)
    about.call = "a at (0, 1e-9, 0), b at (0, 0, 0); c = Connection(a, b, 100.0, 2.0); "
    about.call += "c.update_force(a, 0.5); a.force_accumulator"
    about.cause = (
        "The ends are close together but not at the same position, so the spring still has a "
        "direction. It pushes with almost k l0."
    )
    a, b = Particle(Vector3(0.0, 1e-9, 0.0)), Particle()
    c = Connection(a, b, 100.0, 2.0)
    c.update_force(a, 0.5)
    got = xyz(a.force_accumulator)
    expect_close(got, (0.0, 200.0, 0.0), tolerance=1e-6)
    about.call += "; c.stiffness, c.rest_length, c.damping = 5, 3, 2; a.clear_forces(); "
    about.call += "a.position.y = 2; "
    about.call += "a.velocity.y = 1; c.update_force(a, 0.5)"
    about.cause = (
        "The check has changed the spring's attributes since the last call, so the force is now 5 "
        "(3 - 2) - 2 * 1. Read the attributes on every call instead of caching anything computed "
        "from them."
    )
    c.stiffness, c.rest_length, c.damping = 5.0, 3.0, 2.0
    a.clear_forces()
    a.position.y, a.velocity.y = 2.0, 1.0
    c.update_force(a, 0.5)
    got = xyz(a.force_accumulator)
    expect_close(got, (0.0, 3.0, 0.0))


@pytest.mark.exercise("B6.3")
def test_connect_lets_the_registry_ask_once(rng: Random) -> None:
    about.read = CONNECT
    here, there = components(rng), components(rng)
    k, rest = positive_number(rng), positive_number(rng)
    wanted = tension(here, ZERO, there, ZERO, (k, rest, 0.0))
    masses = ((2.0, 3.0), (math.inf, 3.0), (2.0, math.inf))
    for mass_a, mass_b in masses:
        about.call = f"a of {mass_a} kg at {here}, b of {mass_b} kg at {there}; connect(registry, "
        about.call += f"a, b, {k}, {rest}); registry.update_forces(0.5)"
        about.cause = (
            "Create one Connection with this stiffness and rest length, and register it once, for "
            "an end that can move."
        )
        a, b = Particle(Vector3(*here), mass=mass_a), Particle(Vector3(*there), mass=mass_b)
        registry = ForceRegistry()
        connect(registry, a, b, k, rest)
        registry.update_forces(0.5)
        for name, end, mass, sign in (("a", a, mass_a, 1.0), ("b", b, mass_b, -1.0)):
            if mass < math.inf:
                force = tuple(sign * part for part in wanted)
                got = xyz(end.force_accumulator)
                swapped = tension(here, ZERO, there, ZERO, (rest, k, 0.0))
                slips = {
                    (
                        "The spring exerts no force at all. The registry skips immovable "
                        "particles, so check that you register the spring for an end that can move."
                    ): ZERO,
                    (
                        "The force is twice as large as it should be, probably because you "
                        "registered the spring for both ends. Once is enough, because a single "
                        "call already acts on both ends."
                    ): [2.0 * part for part in force],
                    "The stiffness and the rest length are swapped. Pass the arguments in the "
                    "order that Connection's constructor expects.": [
                        sign * part for part in swapped
                    ],
                }
                blame(got, slips)
                expect_close(got, force, then=f"; {name}.force_accumulator", tolerance=1e-11)


@pytest.mark.exercise("B6.3")
def test_connect_returns_the_spring(rng: Random) -> None:
    about.read = CONNECT
    here, there = components(rng), components(rng)
    k, rest, c = positive_number(rng), positive_number(rng, 0.05, 0.2), positive_number(rng)
    about.call = f"a at {here}, b at {there}; s = connect(registry, a, b, {k}, {rest}, {c})"
    about.cause = (
        "The caller may want to change or remove the spring later, so return the Connection that "
        "you register."
    )
    a, b, registry = Particle(Vector3(*here)), Particle(Vector3(*there)), ForceRegistry()
    s = connect(registry, a, b, k, rest, c)
    expect_exactly(s is not None, True, then=": does a spring come back")
    got = (s.stiffness, s.rest_length, s.damping)
    expect_close(got, (k, rest, c), then="; (s.stiffness, s.rest_length, s.damping)")
    got = (*xyz(s.a.position), *xyz(s.b.position))
    expect_close(got, (*here, *there), then="; the positions of s.a and s.b", tolerance=0.0)
    about.call += f"; s.stiffness = {2 * k}; registry.update_forces(0.5)"
    about.cause = (
        "The check changed the returned spring, but nothing happened. Register the same Connection "
        "that you return, and read its stiffness on every call of update_force."
    )
    s.stiffness = 2.0 * k
    registry.update_forces(0.5)
    wanted = tension(here, ZERO, there, ZERO, (2.0 * k, rest, c))
    got = xyz(a.force_accumulator)
    expect_close(got, wanted, then="; a.force_accumulator", tolerance=1e-11)
    about.call += "; a.clear_forces(); b.clear_forces(); registry.remove(a, s); "
    about.call += "registry.update_forces(0.5)"
    about.cause = (
        "A single call of remove should take the spring away. Register it only once: for a if a "
        "can move."
    )
    a.clear_forces()
    b.clear_forces()
    registry.remove(a, s)
    registry.update_forces(0.5)
    for name, end in (("a", a), ("b", b)):
        got = xyz(end.force_accumulator)
        expect_close(got, ZERO, then=f"; {name}.force_accumulator")


@pytest.mark.exercise("B6.3")
def test_a_network_of_springs_keeps_its_momentum(rng: Random) -> None:
    about.read = "book 3.2, and the docstring of Connection.update_force"
    bodies = [(components(rng), components(rng), positive_number(rng, 1.0)) for _ in range(8)]
    about.call = "8 particles, each connected to each by connect(registry, a, b, 2.0, 3.0, 0.5); "
    about.call += "200 frames of registry.update_forces(h), p.integrate(h): the sum of all m v"
    about.cause = (
        "One end always gains exactly the momentum that the other loses, so the total should stay "
        "constant. Check that the two forces are equal and opposite."
    )
    ends, away = network(bodies, 2.0, 3.0, 0.5, 1.0 / 240.0, 200)
    before = [math.fsum(mass * v[i] for _, v, mass in bodies) for i in range(3)]
    # Each of 200 frames rounds 8 velocities, and 56 forces, at some 1e-15 of what they are.
    expect_close(ends, before, tolerance=1e-10)
    about.call += "; the first one is more than 1 mm away from where it would be without springs"
    about.cause = (
        "Momentum is conserved, but the particles move as if there were no springs. Check that "
        "each spring is registered and adds its forces."
    )
    expect_exactly(away > 1e-3, True)


@pytest.mark.exercise("B6.3")
def test_two_bodies_swing_about_each_other_with_the_reduced_mass() -> None:
    about.read = "book 6.3.2, Eq. 6.3, with the reduced mass m1 m2 / (m1 + m2)"
    about.call = "1 kg and 3 kg, connect(registry, a, b, 5.0, 1.0), stretched to 1.5 m; frames of "
    about.call += "1/2000 s of registry.update_forces(h), p.integrate(h): the period"
    about.cause = (
        "Both ends move, so the frequency is given by w^2 = k / mu, where mu = 3/4 kg is the "
        "reduced mass. The period is 2.43346721 s."
    )
    period = pair_swinging(1.0, 3.0, 5.0, 1.0, 1.5, 1.0 / 2000.0, 10_000)
    # Explicit Euler's own error in the period is w^2 h^2 / 3, some 5e-7 of it.
    expect_close(period, 2.43346721, tolerance=1e-4)


@pytest.mark.exercise("B6.3")
def test_two_immovable_ends_may_be_connected() -> None:
    about.read = CONNECT
    a, b, registry = Particle(), Particle(Vector3(1.0, 0.0, 0.0)), ForceRegistry()
    about.call = "connect(registry, a, b, 3.0, 0.0), both of infinite mass; "
    about.call += "registry.update_forces(0.5)"
    about.cause = (
        "A spring between two immovable particles does nothing, but it isn't an error either, so "
        "connect should accept it."
    )
    still = Particle(mass=math.inf), Particle(mass=math.inf)
    connect(registry, *still, 3.0, 0.0)
    registry.update_forces(0.5)
    about.call += "; the same with b 1 m from a, both of 1 kg; b.force_accumulator"
    connect(registry, a, b, 3.0, 0.0)
    registry.update_forces(0.5)
    got = xyz(b.force_accumulator)
    about.cause = (
        "These two particles can move, so connect should register the spring, and the registry "
        "should apply its force."
    )
    expect_close(got, (-3.0, 0.0, 0.0))


@pytest.mark.exercise("B6.3")
@pytest.mark.robust
def test_connect_refuses_what_means_nothing() -> None:
    about.read = CONNECT
    about.cause = (
        "Create the Connection before you register it, because its constructor checks the "
        "arguments."
    )
    a, b, registry = Particle(), Particle(Vector3(1.0, 0.0, 0.0)), ForceRegistry()
    for bad in ((-1.0, 1.0, 0.0), (1.0, -1.0, 0.0), (1.0, 1.0, -1.0), (math.nan, 1.0, 0.0)):
        about.call = "connect(registry, a, b, {}, {}, {})".format(*bad)
        expect_error(
            lambda bad=bad: connect(registry, a, b, *bad),
            ValueError,
            allowed=lambda: connect(ForceRegistry(), a, b, 1.0, 1.0, 0.0),
        )
    about.call = "connect(registry, a, b, ...) raised an error; registry.update_forces(0.5)"
    about.cause = (
        "A call that raises an error should leave the registry as it was. Create the spring first, "
        "and register it only if that succeeds."
    )
    registry.update_forces(0.5)
    got = xyz(b.force_accumulator)
    expect_close(got, ZERO, then="; b.force_accumulator")
    about.call = "a at (1e10, 0, 0), velocity (1e10, 0, 0); b at minus that, with minus that "
    about.call += "velocity; "
    about.cause = (
        "The force is too large for a float. add_force rejects such a force, so always go through "
        "add_force to change the forces."
    )
    near = Particle(), Particle(Vector3(1.0, 0.0, 0.0))
    for stiffness, damping in ((1e308, 0.0), (0.0, 1e308)):
        far = Particle(Vector3(1e10, 0.0, 0.0), Vector3(1e10, 0.0, 0.0))
        away = Particle(Vector3(-1e10, 0.0, 0.0), Vector3(-1e10, 0.0, 0.0))
        spring = Connection(far, away, stiffness, 1.0, damping)
        expect_error(
            lambda spring=spring, far=far: spring.update_force(far, 0.5),
            ValueError,
            then=f"Connection(a, b, {stiffness}, 1.0, {damping}).update_force(a, 0.5)",
            allowed=lambda: Connection(*near, 1.0, 1.0).update_force(near[0], 0.5),
            read=READ,
        )
