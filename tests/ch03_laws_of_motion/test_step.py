"""The step, build task B3.4. Nearly every check tests one effect and leaves out the others."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import probes
from ch03_laws_of_motion.particle import Particle
from draw import Triple, vector
from expect import about, expect_close, expect_that, expect_unchanged, xyz

DOC, LAST = "the docstring of integrate; docs/errata.md", "the docstring of last_acceleration"
EULER = "book 3.3.1, Eq. 2.7 and 2.8; docs/errata.md"
FIRST_LAW, DAMPING = "book 3.2: the first law", "book 3.3, Eq. 3.6"
# The rounding errors of a few operations on numbers up to 40.
ROUNDED = 1e-13
ZERO = Triple((0.0, 0.0, 0.0))
POSITION, VELOCITY = "; p.position", "; p.velocity"


def draw_part(rng: Random) -> float:
    """Draw a duration, or a damping, that is large enough for each mistake to show."""
    return round(rng.uniform(0.2, 0.8), 3)


@pytest.mark.exercise("B3.4", asks="the new position depends only on the old velocity", read=EULER)
def test_the_position_moves_with_the_velocity_from_before_the_step(rng: Random) -> None:
    x, v, a = vector(rng), vector(rng), vector(rng)
    for h in (draw_part(rng), 3, 0.001):  # a long step lasts a whole number of seconds, an int
        with calls(
            "A step must move the position to p' = p + v h, where v is the velocity before the "
            "step and h the duration."
        ):
            p = Particle(Vector3(*x), Vector3(*v), Vector3(*a))
            p.integrate(h)
        slips = {
            "You change the velocity before the position, as in semi-implicit Euler. This step is "
            "explicit Euler (E-17), so call drift before kick.": x + (v + a * h) * h,
            "Your position has an extra a h^2 / 2, as after half a drift, a kick and half a drift. "
            "The book leaves out this term. Add only the old velocity times h.":
                x + v * h + a * (h * h / 2.0),
            "You add the whole velocity, which is the displacement in one second.": x + v,
            "You drift twice. Call self.drift(duration) once.": x + v * (2.0 * h),
            "The position did not change. Call self.drift(duration) in integrate.": x,
        }  # fmt: skip
        expect_close(p.position, x + v * h, slips, then=POSITION, tolerance=ROUNDED)


@pytest.mark.exercise(
    "B3.4", asks="the acceleration and the damping that the particle has now", read=EULER
)
def test_the_step_adds_the_acceleration_to_the_velocity(rng: Random) -> None:
    x, v, a, h = vector(rng), vector(rng), vector(rng), draw_part(rng)
    with calls("A step must change the velocity exactly once, to v' = v + a h."):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a))
        p.integrate(h)
    slips = {
        "You add the whole acceleration, as if the step took one second.": v + a,
        "You kick twice. Call self.kick(duration) once.": v + a * (2.0 * h),
        "The velocity did not change. Call self.kick(duration) in integrate.": v,
    }
    expect_close(p.velocity, v + a * h, slips, then=VELOCITY, tolerance=ROUNDED)
    changes = (
        "Your step changes the particle's acceleration. Only read it, because the next step needs "
        "it too."
    )
    expect_unchanged("p.acceleration", p.acceleration, a, cause=changes)
    with calls(
        "The acceleration was replaced between the two steps, and the second step must use the new "
        "one. Read self.acceleration in every step.",
        more=True,
    ):
        p.acceleration = Vector3(*x)
        p.integrate(h)
    expect_close(p.velocity, v + a * h + x * h, then=VELOCITY, tolerance=ROUNDED)


@pytest.mark.exercise("B3.4", asks="The velocity of such a body stays the same", read=FIRST_LAW)
def test_a_slow_and_a_fast_particle_keep_their_velocities(rng: Random) -> None:
    h = draw_part(rng)
    for v in (Triple((1e-9, -2e-5, 3e-3)), Triple((1e3, -2e5, 3e8))):
        with calls(
            "Without damping and acceleration the velocity must stay the same, however small or "
            "large it is. Don't round or limit it."
        ):
            p = Particle(velocity=Vector3(*v))
            p.integrate(h)
        expect_close(p.position, v * h, then=POSITION)
        expect_unchanged("p.velocity", p.velocity, v)


@pytest.mark.exercise(
    "B3.4", asks="The fraction d of the velocity that the particle keeps per second", read=DAMPING
)
def test_damping_is_the_fraction_that_is_kept_per_second(rng: Random) -> None:
    v, drawn = vector(rng), draw_part(rng)
    for damping, durations in (
        (drawn, [1.0]),
        (drawn, [0.25] * 4),
        (drawn, [0.1, 0.2, 0.3, 0.4]),
        (drawn, [0.5]),
        (drawn, [2.0]),
        (0.25, [0.5, 0.5]),  # the duration 0.5 equals the fraction that a step keeps, 0.25^0.5
        (0.99, [0.25] * 4),
        (1.5, [0.25] * 2),  # a damping above 1 is allowed and speeds the particle up
        (2.0, [0.5]),
    ):
        with calls(
            "The damping d is the fraction of the velocity that the particle keeps per second. A "
            "step of h seconds must multiply the velocity by d^h.",
            f"p = Particle(velocity=Vector3{v}, {damping=}); p.integrate(h) for h in {durations}",
        ):
            p = Particle(velocity=Vector3(*v), damping=damping)
            for h in durations:
                p.integrate(h)
        n = len(durations)
        slips = {
            "You multiply the velocity by d in every step, as in Eq. 3.5. The damping d is given "
            "per second, so multiply by d^h.": v * damping**n,
            "You use the factor d^h of the first step in every step, although the durations h "
            "differ. Compute it again in each step.": v * damping ** (n * durations[0]),
            "You don't damp the velocity.": v,
        }
        wanted = v * damping ** sum(durations)
        expect_close(p.velocity, wanted, slips, then=VELOCITY, tolerance=ROUNDED)


@pytest.mark.exercise("B3.4", asks="Apply the acceleration and then the damping", read=DOC)
def test_damping_comes_after_the_acceleration(rng: Random) -> None:
    x, v, a, h, d = vector(rng), vector(rng), vector(rng), draw_part(rng), draw_part(rng)
    with calls(
        "A step must change the velocity to v' = (v + a h) d^h, as in the book's listing. Add a h "
        "first, and then multiply the sum by d^h."
    ):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), damping=d)
        p.integrate(h)
    equation = (
        "You compute v d^h + a h, as in Eq. 3.6. The engine follows the book's listing, which "
        "contradicts that equation (E-16), so compute (v + a h) d^h."
    )
    slips = {equation: v * d**h + a * h}
    expect_close(p.velocity, (v + a * h) * d**h, slips, then=VELOCITY, tolerance=ROUNDED)
    changes = (
        "Your step changes p.acceleration, probably by damping it. Damp only the velocity, because "
        "the next step needs the same acceleration."
    )
    expect_unchanged("p.acceleration", p.acceleration, a, cause=changes)


@pytest.mark.exercise(
    "B3.4", asks="the acceleration and the damping that the particle has now", read=DOC
)
def test_a_new_damping_counts_from_the_next_step_on(rng: Random) -> None:
    v, damping = vector(rng), draw_part(rng)
    with calls(
        "The damping was changed before the second step, which must use the new damping. Compute "
        "d^h from self.damping in every step instead of storing it."
    ):
        p = Particle(velocity=Vector3(*v))
        p.integrate(0.5)
        p.damping = damping
        p.integrate(0.5)
    expect_close(p.velocity, v * math.sqrt(damping), then=VELOCITY)


@pytest.mark.exercise("B3.4", asks="0 stops the particle, and a number above 1", read=DOC)
def test_a_damping_of_0_stops_the_particle(rng: Random) -> None:
    x, v, h = vector(rng), vector(rng), draw_part(rng)
    with calls(
        "A damping of 0 must stop the particle, because 0^h is 0. Python treats 0 as false in an "
        "if statement, so don't use the damping as the condition."
    ):
        p = Particle(Vector3(*x), Vector3(*v), damping=0.0)
        p.integrate(h)
    expect_close(p.velocity, ZERO, then=VELOCITY)
    order = "The position must move with the velocity before the damping. Call drift before kick."
    expect_close(p.position, x + v * h, then=POSITION, tolerance=ROUNDED, cause=order)


@pytest.mark.exercise("B3.4", asks="The result does not depend on the mass", read="book 3.2")
def test_the_mass_does_not_matter_to_a_given_acceleration(rng: Random) -> None:
    v, drawn, mass = vector(rng), vector(rng), round(rng.uniform(2.0, 90.0), 3)
    for a, damping in ((drawn, 1.0), (ZERO, 0.25)):
        with calls(
            "You probably use the mass in the step, but it doesn't matter to a given acceleration "
            "or to the damping. Use only v, a, d and h."
        ):
            p = Particle(None, Vector3(*v), Vector3(*a), mass=mass, damping=damping)
            p.integrate(0.5)
        expect_close(p.velocity, (v + a * 0.5) * math.sqrt(damping), then=VELOCITY)


@pytest.mark.exercise("B3.4", asks="by one step of explicit Euler", read=EULER)
def test_a_fall_of_5_seconds_lags_as_explicit_euler_does() -> None:
    """Only here the wanted fall is a closed form, with the error that Euler must make."""
    with calls(
        "The exact fall is 125 m, but explicit Euler must fall 0.41667 m less, because each step "
        "uses the velocity before it. Check the order of the position and the velocity.",
        "p = Particle(acceleration=Vector3(0, -10, 0)); p.integrate(1/60) 300 times; p.position",
    ):
        got = probes.position_after_fall(10.0, 1.0 / 60.0, 300)
    # -a t^2 / 2 + a t h / 2; 300 roundings of numbers up to 125.
    expect_close(got, (0.0, -125.0 + 10.0 * 5.0 / 60.0 / 2.0, 0.0), tolerance=1e-11)


@pytest.mark.exercise("B3.4", asks="An immovable particle does not change", read=DOC)
def test_a_step_does_not_change_an_immovable_particle(rng: Random) -> None:
    x, v, a, h = vector(rng), vector(rng), vector(rng), draw_part(rng)
    with calls(
        "Your integrate changes a particle with an infinite mass. If the inverse_mass is 0, change "
        "nothing."
    ):
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf, damping=0.5)
        p.integrate(h)
    expect_unchanged("p.position", p.position, x)
    expect_unchanged("p.velocity", p.velocity, v)
    expect_unchanged("p.acceleration", p.acceleration, a)
    with calls(
        "The particle has a finite mass now, so it must move again. Check inverse_mass in every "
        "step.",
        more=True,
    ):
        p.mass = 2.0
        p.integrate(h)
    expect_close(p.position, x + v * h, then=POSITION, tolerance=ROUNDED)


@pytest.mark.exercise("B3.4", asks="in the last time step, in m/s^2 as a new vector", read=LAST)
def test_the_last_acceleration_is_a_copy_of_the_acceleration(rng: Random) -> None:
    a = vector(rng)
    later = (a[1], a[2], a[0])
    with calls("Return the particle's acceleration unchanged as last_acceleration."):
        p = Particle(acceleration=Vector3(*a), mass=4.0, damping=0.5)
        p.integrate(0.5)
        last = p.last_acceleration
    slips = {"You divide the acceleration by the mass, as if it were a force.": a / 4.0}
    expect_close(xyz(last), a, slips)
    with calls(
        "Your last_acceleration returns the particle's own vector, so a change to the result also "
        "changes the particle. Return a copy.",
        f"{about.call}.x = 99.0",
    ):
        last.x = 99.0
    expect_unchanged("p.acceleration", p.acceleration, a)
    with calls(
        "The acceleration was replaced before the last step. Return the one that the last step "
        "used, not that of an earlier step."
    ):
        p.acceleration = Vector3(*later)
        p.integrate(0.5)
        last = p.last_acceleration
    expect_close(xyz(last), later)


@pytest.mark.exercise("B3.4", asks="The new velocity must come from self.kick(duration)", read=DOC)
def test_the_step_kicks_once_after_the_position_has_moved(rng: Random) -> None:
    x, v, h = vector(rng), vector(rng), draw_part(rng)
    once = (
        "Call self.kick(duration) once, with the whole duration of the step, because the particle "
        "of chapter 5 overrides kick to add forces."
    )
    with calls(once, f"p is a particle whose class overrides kick; p.integrate({h})"):
        kicks = probes.kicks_of_a_step(x, v, h)
    cause = once if kicks else f"Your integrate does not call self.kick. {once}"
    got = " and ".join(f"kick({duration})" for duration, _ in kicks) or "none"
    called_once = [duration for duration, _ in kicks] == [h]
    then = "; the calls of kick"
    expect_that(called_once, got, f"kick({h}), once", then=then, cause=cause)
    order = (
        "The position must move before the kick. Call drift first and then kick, so that the "
        "position moves with the old velocity."
    )
    then = "; p.position during kick"
    expect_close(kicks[0][1], x + v * h, then=then, tolerance=ROUNDED, cause=order)
