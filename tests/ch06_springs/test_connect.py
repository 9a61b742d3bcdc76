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
from expect import about, blame, expect_close, expect_error, expect_exactly, expect_that, xyz

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


@pytest.mark.exercise("B6.3", asks="Add it to a, and add the exact opposite to b.")
def test_a_connection_acts_on_both_ends(rng: Random) -> None:
    about.read = READ
    here, there, v, w = (components(rng) for _ in range(4))
    numbers = positive_number(rng), positive_number(rng, 0.05, 0.2), positive_number(rng)
    about.call = f"a at {here} with velocity {v}; b at {there} with velocity {w}; "
    about.call += "Connection(a, b, stiffness={}, rest_length={}, damping={})".format(*numbers)
    wanted = tension(here, v, there, w, numbers)
    for end in ("a", "b"):
        a = Particle(Vector3(*here), Vector3(*v), mass=2.0)
        b = Particle(Vector3(*there), Vector3(*w), mass=5.0)
        name = f"{about.call}.update_force({end}, 0.25)"
        about.cause = (
            "Compute the force on a with spring_force, from a's position and velocity relative "
            "to b. The force on a must be the same whichever end is passed to update_force, "
            f"which is {end} here."
        )
        Connection(a, b, *numbers).update_force(a if end == "a" else b, 0.25)
        on_a, on_b = xyz(a.force_accumulator), xyz(b.force_accumulator)
        k, rest, c = numbers
        both = tuple(p + q for p, q in zip(v, w, strict=True))
        slips = {
            "Each end gets only half of the force. Apply the full force to each end.": [
                0.5 * part for part in wanted
            ],
            "You multiplied the force by the duration. Add the force itself, because the step "
            "multiplies it by the duration later.": [0.25 * part for part in wanted],
            "You swapped the stiffness and the rest length. spring_force takes the stiffness "
            "first.": tension(here, v, there, w, (rest, k, c)),
            "Your damping uses only the velocity of a, but the motion of b changes the length too. "
            "Subtract b's velocity from a's.": tension(here, v, there, ZERO, numbers),
            "You halved the stiffness. The whole force of the spring acts on each end, so use "
            "self.stiffness unchanged.": tension(here, v, there, w, (0.5 * k, rest, c)),
            "Your damping has the wrong sign. Subtract b's velocity from a's.": tension(
                here, w, there, v, numbers
            ),
            "You left out the damping. Pass it to spring_force, together with the velocity of a "
            "relative to b.": tension(here, v, there, w, (k, rest, 0.0)),
            "You add the velocities of a and b. Subtract b's velocity from a's.": tension(
                here, both, there, ZERO, numbers
            ),
            "You subtract a's position from b's, so the force on a points in the wrong "
            "direction. Subtract b's position from a's.": tension(there, v, here, w, numbers),
            (
                "You swapped the forces on a and b. Always compute the force on a from a's "
                "position minus b's, no matter which end is passed to update_force."
            ): [-part for part in wanted],
            f"You added no force to a when {end} is passed to update_force. Take both ends from "
            "self.a and self.b, and add a force to each of them in every call.": ZERO,
        }
        blame(on_a, slips)
        # A few roundings of numbers up to 500.
        expect_close(on_a, wanted, call=f"{name}; a.force_accumulator, in N", tolerance=1e-11)
        about.cause = "Your force on b is not the exact opposite of the force on a. Compute the "
        about.cause += "force once, and apply its opposite to b."
        blame(
            on_b,
            {
                "Both ends get the same force, so your spring pushes them in the same direction. "
                "Apply the opposite force to b.": on_a,
                "You added no force to b. One call must act on both ends, so add the opposite "
                "of a's force to b.": ZERO,
            },
        )
        opposite = tuple(-part for part in on_a)
        expect_close(on_b, opposite, call=f"{name}; b.force_accumulator, in N", tolerance=0.0)


@pytest.mark.exercise("B6.3", asks="pushes if it is shorter")
def test_a_compressed_connection_pushes_its_ends_apart(rng: Random) -> None:
    about.read = READ
    k, rest = positive_number(rng), positive_number(rng, 1.0, 5.0)
    d, f = direction(rng), components(rng)
    offset = tuple(0.4 * rest * part for part in d)
    about.call = f"a at {offset}, b at (0, 0, 0); b.add_force(Vector3{f}); a.add_force(Vector3(1, "
    about.call += f"2, 3)); Connection(a, b, stiffness={k}, rest_length={rest}).update_force(a, "
    about.call += "0.5)"
    about.cause = (
        "The spring is shorter than its rest length, so it must push its two ends apart. Its "
        "extension is negative."
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
            "Your extension is abs(length - rest_length), as in the book's listing (E-3), so a "
            "compressed spring pulls. Remove abs to keep the sign.": pulled
        },
    )
    expect_close(got, wanted, then="; a.force_accumulator, in N", tolerance=1e-12)
    wanted = tuple(g - 0.6 * k * rest * part for g, part in zip(f, d, strict=True))
    got = xyz(b.force_accumulator)
    about.cause = (
        "You removed the force that was added to b before. Use add_force, which keeps that force."
    )
    expect_close(got, wanted, then="; b.force_accumulator, in N", tolerance=1e-12)


@pytest.mark.exercise("B6.3", asks="it has no direction, so its force is zero")
def test_connected_ends_at_the_same_position_get_no_force(rng: Random) -> None:
    about.read = READ
    place, v = components(rng), components(rng)
    about.call = f"a and b at {place}, a with velocity {v}; c = Connection(a, b, stiffness=100.0, "
    about.call += "rest_length=2.0, damping=3.0); c.update_force(a, 0.5)"
    about.cause = (
        "You divide by the length, which is 0 because both ends are at the same position. Add "
        "no force in this case."
    )
    a, b = Particle(Vector3(*place), Vector3(*v)), Particle(Vector3(*place))
    c = Connection(a, b, 100.0, 2.0, 3.0)
    c.update_force(a, 0.5)
    for name, end in (("a", a), ("b", b)):
        got = xyz(end.force_accumulator)
        expect_close(got, ZERO, then=f"; {name}.force_accumulator, in N")
    about.call += "; a.position.x += 1.0; c.update_force(a, 0.5); a.force_accumulator, in N"
    about.cause = (
        "The ends are now 1 m apart, so the spring acts again. It pushes with 100 N minus 3 N s/m "
        "times the speed at which a moves away from b."
    )
    a.position.x += 1.0
    c.update_force(a, 0.5)
    wanted = (100.0 - 3.0 * v[0], 0.0, 0.0)
    got = xyz(a.force_accumulator)
    # The offset of 1 m is 1e-15 m off at such places.
    expect_close(got, wanted, tolerance=1e-11)
    about.call = "a at (0, 1e-9, 0), b at (0, 0, 0); c = Connection(a, b, stiffness=100.0, "
    about.call += "rest_length=2.0); c.update_force(a, 0.5); a.force_accumulator, in N"
    about.cause = (
        "The ends are 1e-9 m apart, so the spring still has a direction. It must push with 200 N, "
        "so don't treat a short length as 0."
    )
    a, b = Particle(Vector3(0.0, 1e-9, 0.0)), Particle()
    c = Connection(a, b, 100.0, 2.0)
    c.update_force(a, 0.5)
    got = xyz(a.force_accumulator)
    expect_close(got, (0.0, 200.0, 0.0), tolerance=1e-6)
    about.call += "; c.stiffness, c.rest_length, c.damping = 5, 3, 2; a.clear_forces(); "
    about.call += "a.position.y = 2; a.velocity.y = 1; c.update_force(a, 0.5)"
    about.cause = (
        "The check changes the attributes of c before this call, so the force must be 5 (3 - 2) "
        "- 2 * 1. Read the attributes in every call instead of storing a result."
    )
    c.stiffness, c.rest_length, c.damping = 5.0, 3.0, 2.0
    a.clear_forces()
    a.position.y, a.velocity.y = 2.0, 1.0
    c.update_force(a, 0.5)
    got = xyz(a.force_accumulator)
    expect_close(got, (0.0, 3.0, 0.0))


@pytest.mark.exercise("B6.3", asks="registered for a, or for b if a is immovable")
def test_connect_registers_the_spring_once(rng: Random) -> None:
    about.read = CONNECT
    here, there = components(rng), components(rng)
    k, rest = positive_number(rng), positive_number(rng)
    wanted = tension(here, ZERO, there, ZERO, (k, rest, 0.0))
    masses = ((2.0, 3.0), (math.inf, 3.0), (2.0, math.inf))
    for mass_a, mass_b in masses:
        about.call = f"a of {mass_a:g} kg at {here}; b of {mass_b:g} kg at {there}; "
        about.call = about.call.replace("of inf kg", "is immovable,")
        about.call += f"connect(registry, a, b, stiffness={k}, rest_length={rest}); "
        about.call += "registry.update_forces(0.5)"
        unmoved = "You didn't register the spring. Add it to the registry for one of its ends."
        if not mass_a < mass_b < math.inf:
            unmoved = "Your spring has no effect. Either you registered it for an immovable end, "
            unmoved += "which the registry skips, or not at all. Register it for the other end."
        about.cause = (
            "connect must create one Connection with this stiffness and rest length, and "
            "register it once, for an end that can move."
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
                    unmoved: ZERO,
                    "Your spring acts twice, because you registered it for both ends. One call of "
                    "update_force already acts on both ends, so register the spring once.": [
                        2.0 * part for part in force
                    ],
                    "You swapped the stiffness and the rest length. Pass the arguments to "
                    "Connection in the order of its constructor.": [
                        sign * part for part in swapped
                    ],
                }
                blame(got, slips)
                expect_close(got, force, then=f"; {name}.force_accumulator, in N", tolerance=1e-11)


@pytest.mark.exercise("B6.3", asks="acts on both, and return the spring")
def test_connect_returns_the_spring(rng: Random) -> None:
    about.read = CONNECT
    here, there = components(rng), components(rng)
    k, rest, c = positive_number(rng), positive_number(rng, 0.05, 0.2), positive_number(rng)
    about.call = f"a at {here}, b at {there}; s = connect(registry, a, b, stiffness={k}, "
    about.call += f"rest_length={rest}, damping={c})"
    a, b, registry = Particle(Vector3(*here)), Particle(Vector3(*there)), ForceRegistry()
    s = connect(registry, a, b, k, rest, c)
    about.cause = "Return the Connection that connect registers, and nothing else."
    nothing = "connect returned nothing. Return the Connection that it registers."
    expect_that(s is not None, "nothing (None)", "a Connection", cause=nothing)
    got = (s.stiffness, s.rest_length, s.damping)
    about.cause = (
        "The spring that you return has the wrong values. Pass the stiffness, the rest length "
        "and the damping to Connection."
    )
    undamped = "You left out the damping. Pass it to Connection too."
    blame(got, [((k, rest, 0.0), undamped)])
    expect_close(got, (k, rest, c), then="; s.stiffness, s.rest_length and s.damping")
    about.cause = "connect must return a Connection with a and b as its ends. Create a single "
    about.cause += "Connection for both ends, register it, and return it."
    got = (*xyz(s.a.position), *xyz(s.b.position))
    blame(got, [((*there, *here), "You swapped a and b. Pass them to Connection in this order.")])
    expect_close(got, (*here, *there), then="; the positions of s.a and s.b", tolerance=0.0)
    about.call += f"; s.stiffness = {2 * k:.6g}; registry.update_forces(0.5)"
    about.cause = (
        "The check changed the stiffness of the returned spring s, but the force did not change. "
        "Register the same Connection that you return, and read its stiffness in every call of "
        "update_force."
    )
    s.stiffness = 2.0 * k
    registry.update_forces(0.5)
    wanted = tension(here, ZERO, there, ZERO, (2.0 * k, rest, c))
    got = xyz(a.force_accumulator)
    expect_close(got, wanted, then="; a.force_accumulator, in N", tolerance=1e-11)
    about.call += "; a.clear_forces(); b.clear_forces(); registry.remove(a, s); "
    about.call += "registry.update_forces(0.5)"
    about.cause = (
        "One call of registry.remove(a, s) must remove the spring completely. Register it only "
        "once, and if a can move, register it for a."
    )
    a.clear_forces()
    b.clear_forces()
    registry.remove(a, s)
    registry.update_forces(0.5)
    for name, end in (("a", a), ("b", b)):
        got = xyz(end.force_accumulator)
        expect_close(got, ZERO, then=f"; {name}.force_accumulator, in N")


@pytest.mark.exercise("B6.3", asks="the total momentum of both particles stays constant")
def test_a_network_of_springs_keeps_its_momentum(rng: Random) -> None:
    about.read = "book 3.2.3, and the docstring of Connection.update_force"
    bodies = [(components(rng), components(rng), positive_number(rng, 1.0)) for _ in range(8)]
    about.call = "8 particles, each joined to all others by connect(registry, a, b, "
    about.call += "stiffness=2.0, rest_length=3.0, damping=0.5); 200 steps of "
    about.call += "registry.update_forces(h) and p.integrate(h); the total momentum in kg m/s"
    about.cause = (
        "The total momentum must stay constant, because each spring gives one end what the other "
        "end loses. Check that its two forces are equal and opposite."
    )
    ends, away = network(bodies, 2.0, 3.0, 0.5, 1.0 / 240.0, 200)
    before = [math.fsum(mass * v[i] for _, v, mass in bodies) for i in range(3)]
    # Each of 200 frames rounds 8 velocities, and 56 forces, at some 1e-15 of what they are.
    expect_close(ends, before, tolerance=1e-10)
    about.call += "; the springs moved the first particle by more than 1 mm"
    about.cause = (
        "The particles move as if there were no springs. Check that each spring is registered and "
        "adds its forces."
    )
    expect_exactly(away > 1e-3, True)


@pytest.mark.exercise("B6.3", asks="pulls on both ends with opposite forces")
def test_two_bodies_swing_about_each_other_with_the_reduced_mass() -> None:
    about.read = "book 6.3.2, Eq. 6.3, with the reduced mass m1 m2 / (m1 + m2)"
    about.call = "a of 1 kg and b of 3 kg with connect(registry, a, b, stiffness=5.0, "
    about.call += "rest_length=1.0), stretched to 1.5 m and released; steps of 1/2000 s; the "
    about.call += "period of the oscillation in s"
    about.cause = (
        "Both ends move, so the mass that counts is the reduced mass mu = m1 m2 / (m1 + m2), "
        "which is 0.75 kg. The period is 2 pi sqrt(mu / k)."
    )
    period = pair_swinging(1.0, 3.0, 5.0, 1.0, 1.5, 1.0 / 2000.0, 10_000)
    # Explicit Euler's own error in the period is w^2 h^2 / 3, some 5e-7 of it.
    expect_close(period, 2.43346721, tolerance=1e-4)


@pytest.mark.exercise("B6.3", asks="between two immovable ends has no effect")
def test_two_immovable_ends_may_be_connected() -> None:
    about.read = CONNECT
    a, b, registry = Particle(), Particle(Vector3(1.0, 0.0, 0.0)), ForceRegistry()
    about.call = "connect(registry, a, b, stiffness=3.0, rest_length=0.0) with two immovable "
    about.call += "particles; registry.update_forces(0.5)"
    about.cause = (
        "A spring between two immovable particles has no effect, but it is not an error either, "
        "so connect must accept it."
    )
    still = Particle(mass=math.inf), Particle(mass=math.inf)
    connect(registry, *still, 3.0, 0.0)
    registry.update_forces(0.5)
    about.call += "; the same with two particles of 1 kg that are 1 m apart; b.force_accumulator, "
    about.call += "in N"
    connect(registry, a, b, 3.0, 0.0)
    registry.update_forces(0.5)
    got = xyz(b.force_accumulator)
    about.cause = (
        "Both particles can move. connect must therefore register the spring, and the registry "
        "must apply its force."
    )
    expect_close(got, (-3.0, 0.0, 0.0))


@pytest.mark.exercise("B6.3", asks="pass the error on and register nothing")
@pytest.mark.robust
def test_connect_rejects_invalid_numbers() -> None:
    about.read = CONNECT
    a, b, registry = Particle(), Particle(Vector3(1.0, 0.0, 0.0)), ForceRegistry()
    for name, bad in (
        ("stiffness", (-1.0, 1.0, 0.0)),
        ("rest length", (1.0, -1.0, 0.0)),
        ("damping", (1.0, 1.0, -1.0)),
        ("stiffness", (math.nan, 1.0, 0.0)),
    ):
        about.cause = f"Your connect accepts a negative {name}. Pass it unchanged to Connection, "
        about.cause += "whose constructor raises the ValueError."
        about.call = "connect(registry, a, b, stiffness={}, rest_length={}, damping={})".format(
            *bad
        )
        expect_error(
            lambda bad=bad: connect(registry, a, b, *bad),
            ValueError,
            allowed=lambda: connect(ForceRegistry(), a, b, 1.0, 1.0, 0.0),
        )
    about.call = "connect(registry, a, b, ...) with an argument that is not valid; "
    about.call += "registry.update_forces(0.5)"
    about.cause = (
        "A call of connect that raises an error must leave the registry unchanged. Create the "
        "spring first, and register it only if that succeeds."
    )
    registry.update_forces(0.5)
    got = xyz(b.force_accumulator)
    expect_close(got, ZERO, then="; b.force_accumulator, in N")
    about.call = "a at (1e10, 0, 0) with velocity (1e10, 0, 0); b at (-1e10, 0, 0) with velocity "
    about.call += "(-1e10, 0, 0); "
    about.cause = (
        "The force is too large for a float, so add_force raises an error. Always use add_force "
        "to change the forces."
    )
    near = Particle(), Particle(Vector3(1.0, 0.0, 0.0))
    for stiffness, damping in ((1e308, 0.0), (0.0, 1e308)):
        far = Particle(Vector3(1e10, 0.0, 0.0), Vector3(1e10, 0.0, 0.0))
        away = Particle(Vector3(-1e10, 0.0, 0.0), Vector3(-1e10, 0.0, 0.0))
        spring = Connection(far, away, stiffness, 1.0, damping)
        expect_error(
            lambda spring=spring, far=far: spring.update_force(far, 0.5),
            ValueError,
            then=f"Connection(a, b, stiffness={stiffness}, rest_length=1.0, "
            f"damping={damping}).update_force(a, 0.5)",
            allowed=lambda: Connection(*near, 1.0, 1.0).update_force(near[0], 0.5),
            read=READ,
        )
