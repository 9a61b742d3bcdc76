"""The step, build task B3.4. Nearly every check tests one effect and leaves out the others."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import probes
from ch03_laws_of_motion.particle import Particle
from draw import Components, components
from expect import about, blame, expect_close, expect_that, expect_unchanged, xyz


def draw_frame(rng: Random) -> float:
    """Draw the duration of a step that is long enough for each mistake to show."""
    return round(rng.uniform(0.2, 0.8), 3)


def a_particle(
    position: Components, velocity: Components, acceleration: Components, damping: float = 1.0
) -> tuple[str, Particle]:
    """Return the code that makes a particle, and the particle."""
    words = f"x, v, a = Vector3{position}, Vector3{velocity}, Vector3{acceleration}; "
    words += "p = Particle(x, v, a"
    vectors = (Vector3(*position), Vector3(*velocity), Vector3(*acceleration))
    words += f", damping={damping})" if damping != 1.0 else ")"
    return words, Particle(*vectors, damping=damping)


@pytest.mark.exercise("B3.4", asks="the new position depends only on the old velocity")
def test_the_position_moves_with_the_velocity_from_before_the_step(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    about.read = "book 3.3.1, Eq. 2.7; errata.md"
    for h in (draw_frame(rng), 3, 0.001):  # a long step lasts a whole number of seconds, an int
        words, p = a_particle(x, v, a)
        about.call = f"{words}; p.integrate({h}); p.position"
        about.cause = (
            "A step must move the position to p' = p + v h, where v is the velocity before the "
            "step and h the duration."
        )
        p.integrate(h)
        wanted = tuple(x[i] + v[i] * h for i in range(3))
        mistakes = [
            (
                tuple(x[i] + (v[i] + a[i] * h) * h for i in range(3)),
                "You change the velocity before the position, as in semi-implicit Euler. This step "
                "is explicit Euler (E-17), so call drift before kick.",
            ),
            (
                tuple(x[i] + v[i] * h + a[i] * h * h / 2.0 for i in range(3)),
                "Your position has an extra a h^2 / 2, as after half a drift, a kick and half a "
                "drift. The book leaves out this term. Add only the old velocity times h.",
            ),
            (
                tuple(x[i] + v[i] for i in range(3)),
                "You add the whole velocity, which is the displacement in one second. Multiply it "
                "by the duration h first.",
            ),
            (
                tuple(x[i] + 2.0 * v[i] * h for i in range(3)),
                "You drift twice. Call self.drift(duration) once.",
            ),
            (x, "The position did not change. Call self.drift(duration) in integrate."),
        ]
        blame(xyz(p.position), mistakes)
        # The rounding errors of numbers up to 40.
        expect_close(xyz(p.position), wanted, tolerance=1e-13)


@pytest.mark.exercise("B3.4", asks="the acceleration and the damping that the particle has now")
def test_the_step_adds_the_acceleration_to_the_velocity(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_frame(rng)
    words, p = a_particle(x, v, a)
    about.call = f"{words}; p.integrate({h}); p.velocity"
    about.cause = "A step must change the velocity exactly once, to v' = v + a h."
    about.read = "book 3.3.1, Eq. 2.8"
    p.integrate(h)
    wanted = tuple(v[i] + a[i] * h for i in range(3))
    mistakes = [
        (
            tuple(v[i] + a[i] for i in range(3)),
            "You add the whole acceleration, as if the step took one second. Multiply it by the "
            "duration h first.",
        ),
        (
            tuple(v[i] + 2.0 * a[i] * h for i in range(3)),
            "You kick twice. Call self.kick(duration) once.",
        ),
        (v, "The velocity did not change. Call self.kick(duration) in integrate."),
    ]
    blame(xyz(p.velocity), mistakes)
    expect_close(xyz(p.velocity), wanted, tolerance=1e-13)
    about.cause = (
        "Your step changes the particle's acceleration. Only read it, because the next step needs "
        "it too."
    )
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)
    p.acceleration = Vector3(*x)
    about.call = (
        f"{words}; p.integrate({h}); p.acceleration = Vector3{x}; p.integrate({h}); p.velocity"
    )
    about.cause = (
        "The acceleration was replaced between the two steps, and the second step must use the new "
        "one. Read self.acceleration in every step."
    )
    p.integrate(h)
    wanted = tuple(v[i] + a[i] * h + x[i] * h for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=1e-13)


@pytest.mark.exercise("B3.4", asks="The velocity of such a body stays the same")
def test_a_slow_and_a_fast_particle_keep_their_velocities(rng: Random) -> None:
    h = draw_frame(rng)
    about.cause = (
        "Without damping and acceleration the velocity must stay the same, however small or large "
        "it is. Don't round or limit it."
    )
    about.read = "book 3.2: the first law"
    for v in ((1e-9, -2e-5, 3e-3), (1e3, -2e5, 3e8)):
        about.call = f"p = Particle(velocity=Vector3{v}); p.integrate({h})"
        p = Particle(velocity=Vector3(*v))
        p.integrate(h)
        wanted = tuple(v[i] * h for i in range(3))
        expect_close(xyz(p.position), wanted, then="; p.position")
        expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise(
    "B3.4", asks="The fraction d of the velocity that the particle keeps per second"
)
def test_damping_is_the_fraction_that_is_kept_per_second(rng: Random) -> None:
    v, drawn = components(rng), round(rng.uniform(0.2, 0.8), 3)
    about.read = "book 3.3, Eq. 3.6"
    for damping, frames in (
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
        about.call = f"p = Particle(velocity=Vector3{v}, {damping=}); p.integrate(h) for each h in "
        about.cause = (
            "The damping d is the fraction of the velocity that the particle keeps per second. A "
            "step of h seconds must multiply the velocity by d^h."
        )
        kept = damping ** sum(frames)
        got = probes.velocity_after(v, damping, frames)
        each, first = damping ** len(frames), damping ** (len(frames) * frames[0])
        mistakes = [
            (
                tuple(n * each for n in v),
                "You multiply the velocity by d in every step, as in Eq. 3.5. The damping d is "
                "given per second, so multiply by d^h.",
            ),
            (
                tuple(n * first for n in v),
                "You use the factor d^h of the first step in every step, although the durations h "
                "differ. Compute it again in each step.",
            ),
            (v, "You don't damp the velocity. Multiply it by d^h in every step of duration h."),
        ]
        blame(got, mistakes)
        wanted = (v[0] * kept, v[1] * kept, v[2] * kept)
        # The rounding errors of a few operations on numbers up to 10.
        expect_close(got, wanted, then=f"{frames}; p.velocity", tolerance=1e-13)


@pytest.mark.exercise("B3.4", asks="Apply the acceleration and then the damping")
def test_damping_comes_after_the_acceleration(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_frame(rng)
    damping = round(rng.uniform(0.2, 0.8), 3)
    words, p = a_particle(x, v, a, damping)
    about.call = f"{words}; p.integrate({h}); p.velocity"
    about.cause = (
        "A step must change the velocity to v' = (v + a h) d^h, as in the book's listing. Add a h "
        "first, and then multiply the sum by d^h."
    )
    about.read = "the docstring of integrate, errata.md"
    p.integrate(h)
    wanted = tuple((v[i] + a[i] * h) * damping**h for i in range(3))
    equation = (
        "You compute v d^h + a h, as in Eq. 3.6. The engine follows the book's listing, which "
        "contradicts that equation (E-16), so compute (v + a h) d^h."
    )
    mistakes = [(tuple(v[i] * damping**h + a[i] * h for i in range(3)), equation)]
    blame(xyz(p.velocity), mistakes)
    expect_close(xyz(p.velocity), wanted, tolerance=1e-13)
    about.cause = (
        "Your step changes p.acceleration, probably by damping it. Damp only the velocity, because "
        "the next step needs the same acceleration."
    )
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)


@pytest.mark.exercise("B3.4", asks="the acceleration and the damping that the particle has now")
def test_a_new_damping_counts_from_the_next_step_on(rng: Random) -> None:
    v, damping = components(rng), round(rng.uniform(0.2, 0.8), 3)
    about.call = (
        f"p = Particle(velocity=Vector3{v}); p.integrate(0.5); p.damping = {damping}; "
        "p.integrate(0.5); p.velocity"
    )
    about.cause = (
        "The damping was changed before the second step, which must use the new damping. Compute "
        "d^h from self.damping in every step instead of storing it."
    )
    about.read = "the docstring of integrate"
    p = Particle(velocity=Vector3(*v))
    p.integrate(0.5)
    p.damping = damping
    p.integrate(0.5)
    kept = math.sqrt(damping)
    wanted = (v[0] * kept, v[1] * kept, v[2] * kept)
    expect_close(xyz(p.velocity), wanted)


@pytest.mark.exercise("B3.4", asks="0 stops the particle, and a number above 1")
def test_a_damping_of_0_stops_the_particle(rng: Random) -> None:
    x, v, h = components(rng), components(rng), draw_frame(rng)
    words, p = a_particle(x, v, (0.0, 0.0, 0.0), 0.0)
    about.call = f"{words}; p.integrate({h})"
    about.cause = (
        "A damping of 0 must stop the particle, because 0^h is 0. Python treats 0 as false in an "
        "if statement, so don't use the damping as the condition."
    )
    about.read = "the docstring of integrate"
    p.integrate(h)
    expect_close(xyz(p.velocity), (0.0, 0.0, 0.0), then="; p.velocity")
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    about.cause = (
        "The position must move with the velocity before the damping. Call drift before kick."
    )
    expect_close(xyz(p.position), wanted, then="; p.position", tolerance=1e-13)


@pytest.mark.exercise("B3.4", asks="The result does not depend on the mass")
def test_the_mass_does_not_matter_to_a_given_acceleration(rng: Random) -> None:
    v, a, mass = components(rng), components(rng), round(rng.uniform(2.0, 90.0), 3)
    about.cause = (
        "You probably use the mass in the step, but it doesn't matter to a given acceleration or "
        "to the damping. Use only v, a, d and h."
    )
    about.read = "book 3.2"
    for acceleration, damping in ((a, 1.0), ((0.0, 0.0, 0.0), 0.25)):
        about.call = (
            f"p = Particle(velocity=Vector3{v}, acceleration=Vector3{acceleration}, mass={mass}, "
            f"damping={damping!r}); p.integrate(0.5); p.velocity"
        )
        vectors = {"velocity": Vector3(*v), "acceleration": Vector3(*acceleration)}
        p = Particle(**vectors, mass=mass, damping=damping)
        p.integrate(0.5)
        kept = math.sqrt(damping)
        wanted = tuple((v[i] + acceleration[i] * 0.5) * kept for i in range(3))
        expect_close(xyz(p.velocity), wanted)


@pytest.mark.exercise("B3.4", asks="by one step of explicit Euler")
def test_a_fall_of_5_seconds_lags_as_explicit_euler_does() -> None:
    about.call = (
        "p = Particle(acceleration=Vector3(0, -10, 0)); p.integrate(1/60) 300 times; p.position"
    )
    about.cause = (
        "The exact fall is 125 m, but explicit Euler must fall 0.41667 m less, because each step "
        "uses the velocity before it. Check the order of the position and the velocity."
    )
    about.read = "book 3.3.1, Eq. 2.7 and 2.8"
    got = probes.position_after_fall(10.0, 1.0 / 60.0, 300)
    # -a t^2 / 2 + a t h / 2; 300 roundings of numbers up to 125.
    wanted = (0.0, -125.0 + 10.0 * 5.0 / 60.0 / 2.0, 0.0)
    expect_close(got, wanted, tolerance=1e-11)


@pytest.mark.exercise("B3.4", asks="An immovable particle does not change")
def test_a_step_does_not_change_an_immovable_particle(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_frame(rng)
    about.call = (
        f"x, v, a = Vector3{x}, Vector3{v}, Vector3{a}; p = Particle(x, v, a, mass=math.inf); "
        f"p.integrate({h})"
    )
    about.cause = (
        "Your integrate changes a particle with an infinite mass. If the inverse_mass is 0, change "
        "nothing."
    )
    about.read = "the docstring of integrate"
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf, damping=0.5)
    p.integrate(h)
    expect_unchanged("p.position", xyz(p.position), x)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)
    p.mass = 2.0
    about.call = f"{about.call}; p.mass = 2.0; p.integrate({h}); p.position"
    about.cause = (
        "The particle has a finite mass now, so it must move again. Check inverse_mass in every "
        "step."
    )
    p.integrate(h)
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    expect_close(xyz(p.position), wanted, tolerance=1e-13)


@pytest.mark.exercise("B3.4", asks="in the last time step, in m/s^2 as a new vector")
def test_the_last_acceleration_is_a_copy_of_the_acceleration(rng: Random) -> None:
    a = components(rng)
    about.call = (
        f"p = Particle(acceleration=Vector3{a}, mass=4.0, damping=0.5); p.integrate(0.5); "
        "p.last_acceleration"
    )
    about.cause = "Return the particle's acceleration unchanged as last_acceleration."
    divided = "You divide the acceleration by the mass, as if it were a force. Return it unchanged."
    about.read = "the docstring of last_acceleration"
    p = Particle(acceleration=Vector3(*a), mass=4.0, damping=0.5)
    p.integrate(0.5)
    last = p.last_acceleration
    blame(xyz(last), [(tuple(n / 4.0 for n in a), divided)])
    expect_close(xyz(last), a)
    last.x = 99.0
    about.call = f"{about.call}.x = 99.0"
    about.cause = (
        "Your last_acceleration returns the particle's own vector, so a change to the result also "
        "changes the particle. Return a copy."
    )
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)
    about.cause = (
        "The acceleration was replaced before the last step. Return the one that the last step "
        "used, not that of an earlier step."
    )
    p.acceleration = Vector3(a[1], a[2], a[0])
    p.integrate(0.5)
    about.call = (
        f"p.acceleration = Vector3{(a[1], a[2], a[0])}; p.integrate(0.5); p.last_acceleration"
    )
    got = xyz(p.last_acceleration)
    expect_close(got, (a[1], a[2], a[0]))


@pytest.mark.exercise("B3.4", asks="The new velocity must come from self.kick(duration)")
def test_the_step_kicks_once_after_the_position_has_moved(rng: Random) -> None:
    x, v, h = components(rng), components(rng), draw_frame(rng)
    about.call = f"p is a particle whose class overrides kick; p.integrate({h})"
    about.read = "the docstring of integrate"
    kicks = probes.kicks_of_a_step(x, v, h)
    about.cause = "Your integrate does not call self.kick. Call self.kick(duration) once, because "
    about.cause += "the particle of chapter 5 overrides kick to add forces."
    if kicks:
        about.cause = "Your integrate must call self.kick(duration) exactly once, with the whole "
        about.cause += "duration of the step."
    got = " and ".join(f"kick({duration})" for duration, _ in kicks) or "none"
    expect_that([k[0] for k in kicks] == [h], got, f"kick({h}), once", then="; the calls of kick")
    about.cause = (
        "The position must move before the kick. Call drift first and then kick, so that the "
        "position moves with the old velocity."
    )
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    expect_close(kicks[0][1], wanted, then="; p.position during kick", tolerance=1e-13)
