"""The step, build task B3.4. Each check but one leaves out what another is about."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import probes
from ch03_laws_of_motion.particle import Particle
from draw import Components, components
from expect import (
    about,
    blame,
    expect_close,
    expect_error,
    expect_exactly,
    expect_unchanged,
    xyz,
)


def draw_frame(rng: Random) -> float:
    """Draw the duration of a frame, long enough for each mistake to show."""
    return round(rng.uniform(0.2, 0.8), 3)


def a_particle(
    position: Components, velocity: Components, acceleration: Components, damping: float = 1.0
) -> tuple[str, Particle]:
    """Return a particle and the words that make it."""
    words = f"p = Particle(Vector3{position}, Vector3{velocity}, Vector3{acceleration}"
    vectors = (Vector3(*position), Vector3(*velocity), Vector3(*acceleration))
    words += f", damping={damping})" if damping != 1.0 else ")"
    return words, Particle(*vectors, damping=damping)


@pytest.mark.exercise("B3.4")
def test_the_position_moves_with_the_velocity_from_before_the_step(rng: Random) -> None:
    x, v, a = components(rng), components(rng), components(rng)
    about.read = "book 3.3.2, Eq. 2.7; errata.md"
    for h in (draw_frame(rng), 3, 0.001):  # a long frame is a whole number of seconds: an int
        words, p = a_particle(x, v, a)
        about.call = f"{words}; p.integrate({h}); p.position"
        about.cause = "p' = p + v h, with the velocity from before the step"
        p.integrate(h)
        wanted = tuple(x[i] + v[i] * h for i in range(3))
        mistakes = [
            (
                tuple(x[i] + (v[i] + a[i] * h) * h for i in range(3)),
                "the velocity was changed first, which is semi-implicit Euler: a better method, "
                "but not the book's, which moves the position with the old velocity (E-17)",
            ),
            (
                tuple(x[i] + v[i] * h + a[i] * h * h / 2.0 for i in range(3)),
                "a h^2 / 2 was added: the step leaves it out on purpose",
            ),
            (
                tuple(x[i] + v[i] for i in range(3)),
                "the velocity was added once a frame: it is per second, so p + v h",
            ),
            (x, "the position does not move: p' = p + v h"),
        ]
        blame(xyz(p.position), mistakes)
        # Rounding of numbers up to 40.
        expect_close(xyz(p.position), wanted, tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_the_velocity_gains_what_the_acceleration_gives(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_frame(rng)
    words, p = a_particle(x, v, a)
    about.call = f"{words}; p.integrate({h}); p.velocity"
    about.cause = "v' = v + a h, once a step; a damping of 1 changes nothing"
    about.read = "book 3.3.2, Eq. 2.8"
    p.integrate(h)
    wanted = tuple(v[i] + a[i] * h for i in range(3))
    mistakes = [
        (
            tuple(v[i] + a[i] for i in range(3)),
            "the acceleration was added once a frame: it is per second, so v + a h",
        ),
        (v, "the acceleration was left out: v' = v + a h"),
    ]
    blame(xyz(p.velocity), mistakes)
    expect_close(xyz(p.velocity), wanted, tolerance=1e-13)
    about.cause = "the acceleration is only read: the next step needs it as it was given"
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)
    p.acceleration = Vector3(*x)
    about.call = f"{words}; p.integrate({h}); p.acceleration = Vector3{x}; p.integrate({h}); "
    about.call += "p.velocity"
    about.cause = "a new acceleration counts from the next step on"
    p.integrate(h)
    wanted = tuple(v[i] + a[i] * h + x[i] * h for i in range(3))
    expect_close(xyz(p.velocity), wanted, tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_a_slow_and_a_fast_particle_keep_their_velocities(rng: Random) -> None:
    h = draw_frame(rng)
    about.cause = "without damping and acceleration no step changes a velocity, however small or "
    about.cause += "large"
    about.read = "book 3.2: the first law"
    for v in ((1e-9, -2e-5, 3e-3), (1e3, -2e5, 3e8)):
        about.call = f"p = Particle(velocity=Vector3{v}); p.integrate({h})"
        p = Particle(velocity=Vector3(*v))
        p.integrate(h)
        wanted = tuple(v[i] * h for i in range(3))
        expect_close(xyz(p.position), wanted, then="; p.position")
        expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise("B3.4")
def test_damping_is_the_share_that_is_kept_in_a_second(rng: Random) -> None:
    v, drawn = components(rng), round(rng.uniform(0.2, 0.8), 3)
    about.read = "book 3.3, Eq. 3.6"
    for damping, frames in (
        (drawn, [1.0]),
        (drawn, [0.25] * 4),
        (drawn, [0.1, 0.2, 0.3, 0.4]),
        (drawn, [0.5]),
        (drawn, [2.0]),
        (0.25, [0.5, 0.5]),  # a frame as long as the share that is kept in it: 0.25^0.5
        (0.99, [0.25] * 4),
        (1.5, [0.25] * 2),  # above 1 a particle gains speed; nothing forbids it
        (2.0, [0.5]),
    ):
        about.call = f"p = Particle(velocity=Vector3{v}, {damping=}); p.integrate(h) for each h in "
        about.cause = "a frame of h seconds keeps d^h: damping ** duration"
        kept = damping ** sum(frames)
        got = probes.velocity_after(v, damping, frames)
        each, first = damping ** len(frames), damping ** (len(frames) * frames[0])
        mistakes = [
            (
                tuple(n * each for n in v),
                "d was taken in every frame, however long it is, as in Eq. 3.5: take d^h",
            ),
            (
                tuple(n * first for n in v),
                "d^h of the first frame was taken in all of them: the frames differ",
            ),
            (v, "nothing was damped: a frame of h seconds keeps d^h"),
        ]
        blame(got, mistakes)
        wanted = (v[0] * kept, v[1] * kept, v[2] * kept)
        # A few roundings of numbers up to 10.
        expect_close(got, wanted, then=f"{frames}; p.velocity", tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_damping_comes_after_the_acceleration(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_frame(rng)
    damping = round(rng.uniform(0.2, 0.8), 3)
    words, p = a_particle(x, v, a, damping)
    about.call = f"{words}; p.integrate({h}); p.velocity"
    about.cause = "v' = (v + a h) d^h, as in the book's listing: what the acceleration adds is "
    about.cause += "damped too"
    about.read = "the docstring of integrate, errata.md"
    p.integrate(h)
    wanted = tuple((v[i] + a[i] * h) * damping**h for i in range(3))
    equation = (
        "that is Eq. 3.6, v d^h + a h, which the book's listing contradicts (E-16): the engine "
        "keeps to the listing, (v + a h) d^h"
    )
    mistakes = [(tuple(v[i] * damping**h + a[i] * h for i in range(3)), equation)]
    blame(xyz(p.velocity), mistakes)
    expect_close(xyz(p.velocity), wanted, tolerance=1e-13)
    about.cause = "the velocity is damped, the acceleration is not"
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)


@pytest.mark.exercise("B3.4")
def test_a_new_damping_counts_from_the_next_step_on(rng: Random) -> None:
    v, damping = components(rng), round(rng.uniform(0.2, 0.8), 3)
    about.call = f"p = Particle(velocity=Vector3{v}); p.integrate(0.5); p.damping = {damping}; "
    about.call += "p.integrate(0.5); p.velocity"
    about.cause = "d^h belongs to the damping of now: what is kept from an earlier step is out of "
    about.cause += "date"
    about.read = "the docstring of integrate"
    p = Particle(velocity=Vector3(*v))
    p.integrate(0.5)
    p.damping = damping
    p.integrate(0.5)
    kept = math.sqrt(damping)
    wanted = (v[0] * kept, v[1] * kept, v[2] * kept)
    expect_close(xyz(p.velocity), wanted)


@pytest.mark.exercise("B3.4")
def test_a_damping_of_0_stops_the_particle(rng: Random) -> None:
    x, v, h = components(rng), components(rng), draw_frame(rng)
    words, p = a_particle(x, v, (0.0, 0.0, 0.0), 0.0)
    about.call = f"{words}; p.integrate({h})"
    about.cause = "0^h is 0, so a damping of 0 keeps nothing; 0 counts as false where it is asked "
    about.cause += "for"
    about.read = "the docstring of integrate"
    p.integrate(h)
    expect_close(xyz(p.velocity), (0.0, 0.0, 0.0), then="; p.velocity")
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    about.cause = "the position moves with the velocity from before the step, which was not yet "
    about.cause += "damped"
    expect_close(xyz(p.position), wanted, then="; p.position", tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_the_mass_does_not_matter_to_a_given_acceleration(rng: Random) -> None:
    v, a, mass = components(rng), components(rng), round(rng.uniform(2.0, 90.0), 3)
    about.cause = "nothing is multiplied or divided by the mass here: an acceleration is no force"
    about.read = "book 3.2"
    for acceleration, damping in ((a, 1.0), ((0.0, 0.0, 0.0), 0.25)):
        about.call = f"p = Particle(velocity=Vector3{v}, acceleration=Vector3{acceleration}, "
        about.call += f"mass={mass}, {damping=}); p.integrate(0.5); p.velocity"
        vectors = {"velocity": Vector3(*v), "acceleration": Vector3(*acceleration)}
        p = Particle(**vectors, mass=mass, damping=damping)
        p.integrate(0.5)
        kept = math.sqrt(damping)
        wanted = tuple((v[i] + acceleration[i] * 0.5) * kept for i in range(3))
        expect_close(xyz(p.velocity), wanted)


@pytest.mark.exercise("B3.4")
def test_a_fall_of_5_seconds_lags_as_explicit_euler_does() -> None:
    about.call = "p = Particle(acceleration=Vector3(0, -10, 0)); p.integrate(1/60) 300 times; "
    about.call += "p.position"
    about.cause = "the error of explicit Euler is a t h / 2, here 0.41667 m short of 125 m"
    about.read = "book 3.3.2, Eq. 2.7 and 2.8"
    got = probes.position_after_fall(10.0, 1.0 / 60.0, 300)
    # -a t^2 / 2 + a t h / 2; 300 roundings of numbers up to 125.
    wanted = (0.0, -125.0 + 10.0 * 5.0 / 60.0 / 2.0, 0.0)
    expect_close(got, wanted, tolerance=1e-11)


@pytest.mark.exercise("B3.4")
def test_an_immovable_particle_stays_as_it_is(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_frame(rng)
    about.call = f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, mass=math.inf); "
    about.call += f"p.integrate({h})"
    about.cause = "nothing moves it: return, where the inverse mass is 0, before anything is "
    about.cause += "changed"
    about.read = "the docstring of integrate"
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf, damping=0.5)
    p.integrate(h)
    expect_unchanged("p.position", xyz(p.position), x)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)
    p.mass = 2.0
    about.call = f"{about.call}; p.mass = 2.0; p.integrate({h}); p.position"
    about.cause = "now it has a finite mass and moves"
    p.integrate(h)
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    expect_close(xyz(p.position), wanted, tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_the_last_acceleration_is_the_constant_one_and_a_vector_of_its_own(rng: Random) -> None:
    a = components(rng)
    about.call = f"p = Particle(acceleration=Vector3{a}, mass=4.0, damping=0.5); p.integrate(0.5); "
    about.call += "p.last_acceleration"
    about.cause = "the acceleration as it was given: it is no force, whatever the mass"
    about.read = "the docstring of last_acceleration"
    p = Particle(acceleration=Vector3(*a), mass=4.0, damping=0.5)
    p.integrate(0.5)
    last = p.last_acceleration
    expect_close(xyz(last), a)
    last.x = 99.0
    about.call = f"{about.call}.x = 99.0"
    about.cause = "the vector itself was given away: return a copy"
    expect_unchanged("p.acceleration", xyz(p.acceleration), a)
    about.cause = "the acceleration of the last step, not of an earlier one"
    p.acceleration = Vector3(a[1], a[2], a[0])
    p.integrate(0.5)
    about.call = f"p.acceleration = Vector3{(a[1], a[2], a[0])}; p.integrate(0.5); "
    about.call += "p.last_acceleration"
    got = xyz(p.last_acceleration)
    expect_close(got, (a[1], a[2], a[0]))


@pytest.mark.exercise("B3.4")
def test_the_step_kicks_once_after_the_position_has_moved(rng: Random) -> None:
    x, v, h = components(rng), components(rng), draw_frame(rng)
    about.call = f"p.integrate({h}), where a class derived from Particle has a kick of its own: "
    about.read = "the docstring of integrate"
    kicks = probes.kicks_of_a_step(x, v, h)
    about.cause = "Chapter 5 adds forces to the kick. For its particle to have the same step, "
    about.cause += "integrate must call self.kick(duration), once."
    got = [duration for duration, _ in kicks]
    expect_exactly(got, [h], then="the durations of the kicks")
    about.cause = "The drift comes first, with the velocity from before the step. The kick comes "
    about.cause += "second."
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    expect_close(kicks[0][1], wanted, then="p.position when kick is called", tolerance=1e-13)


@pytest.mark.exercise("B3.4")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan])
def test_a_step_takes_a_positive_and_finite_duration(duration: float) -> None:
    about.read = "the docstring of integrate"
    x, v, a = (1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0)
    for mass in (1.0, math.inf):
        about.cause = "no time passes in it, or time runs back or for ever: positive of "
        about.cause += "arguments.py refuses it"
        if mass == math.inf:
            about.cause = "a bad duration is refused where nothing moves, too: look at it first"
        about.call = f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, {mass=}); "
        about.call += f"p.integrate({duration})"
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass)
        for _ in range(2):  # what is kept of the first attempt must not let the second one in
            expect_error(
                lambda p=p: p.integrate(duration),
                ValueError,
                allowed=lambda: Particle().integrate(0.5),
            )
        about.cause = "refuse the duration before anything is changed"
        expect_unchanged("p.position", xyz(p.position), x)
        expect_unchanged("p.velocity", xyz(p.velocity), v)


@pytest.mark.exercise("B3.4")
@pytest.mark.robust
def test_text_is_no_duration() -> None:
    about.call = 'Particle().integrate("0.5")'
    about.cause = "positive of arguments.py raises the TypeError for you"
    about.read = "the docstring of integrate"
    expect_error(
        lambda: Particle().integrate("0.5"), TypeError, allowed=lambda: Particle().integrate(0.5)
    )
