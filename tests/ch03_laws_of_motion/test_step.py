"""The step, build task B3.4. Each check but one leaves out what another is about."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion import probes
from ch03_laws_of_motion.particle import Particle
from draw import Components, components
from expect import cause_of, expect_close, expect_error, expect_exactly, expect_unchanged, xyz


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
    read = "book 3.3.2, Eq. 2.7; errata.md"
    for h in (draw_frame(rng), 3, 0.001):  # a long frame is a whole number of seconds: an int
        words, p = a_particle(x, v, a)
        call = f"{words}; p.integrate({h}); p.position"
        cause = "p' = p + v h, with the velocity from before the step"
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
        cause = cause_of(xyz(p.position), mistakes, cause)
        # Rounding of numbers up to 40.
        expect_close(call, xyz(p.position), wanted, cause=cause, read=read, tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_the_velocity_gains_what_the_acceleration_gives(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_frame(rng)
    words, p = a_particle(x, v, a)
    call = f"{words}; p.integrate({h}); p.velocity"
    cause = "v' = v + a h, once a step; a damping of 1 changes nothing"
    read = "book 3.3.2, Eq. 2.8"
    p.integrate(h)
    wanted = tuple(v[i] + a[i] * h for i in range(3))
    mistakes = [
        (
            tuple(v[i] + a[i] for i in range(3)),
            "the acceleration was added once a frame: it is per second, so v + a h",
        ),
        (v, "the acceleration was left out: v' = v + a h"),
    ]
    cause = cause_of(xyz(p.velocity), mistakes, cause)
    expect_close(call, xyz(p.velocity), wanted, cause=cause, read=read, tolerance=1e-13)
    cause = "the acceleration is only read: the next step needs it as it was given"
    expect_unchanged(call, "p.acceleration", xyz(p.acceleration), a, cause=cause, read=read)
    p.acceleration = Vector3(*x)
    call = f"{words}; p.integrate({h}); p.acceleration = Vector3{x}; p.integrate({h}); p.velocity"
    cause = "a new acceleration counts from the next step on"
    p.integrate(h)
    wanted = tuple(v[i] + a[i] * h + x[i] * h for i in range(3))
    expect_close(call, xyz(p.velocity), wanted, cause=cause, read=read, tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_a_slow_and_a_fast_particle_keep_their_velocities(rng: Random) -> None:
    h = draw_frame(rng)
    cause = "without damping and acceleration no step changes a velocity, however small or large"
    read = "book 3.2: the first law"
    for v in ((1e-9, -2e-5, 3e-3), (1e3, -2e5, 3e8)):
        call = f"p = Particle(velocity=Vector3{v}); p.integrate({h})"
        p = Particle(velocity=Vector3(*v))
        p.integrate(h)
        wanted = tuple(v[i] * h for i in range(3))
        expect_close(f"{call}; p.position", xyz(p.position), wanted, cause=cause, read=read)
        expect_unchanged(call, "p.velocity", xyz(p.velocity), v, cause=cause, read=read)


@pytest.mark.exercise("B3.4")
def test_damping_is_the_share_that_is_kept_in_a_second(rng: Random) -> None:
    v, drawn = components(rng), round(rng.uniform(0.2, 0.8), 3)
    read = "book 3.3, Eq. 3.6"
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
        call = f"p = Particle(velocity=Vector3{v}, {damping=}); p.integrate(h) for each h in "
        cause = "a frame of h seconds keeps d^h: damping ** duration"
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
        cause = cause_of(got, mistakes, cause)
        wanted = (v[0] * kept, v[1] * kept, v[2] * kept)
        # A few roundings of numbers up to 10.
        name = f"{call}{frames}; p.velocity"
        expect_close(name, got, wanted, cause=cause, read=read, tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_damping_comes_after_the_acceleration(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_frame(rng)
    damping = round(rng.uniform(0.2, 0.8), 3)
    words, p = a_particle(x, v, a, damping)
    call = f"{words}; p.integrate({h}); p.velocity"
    cause = "v' = (v + a h) d^h, as in the book's listing: what the acceleration adds is damped too"
    read = "the docstring of integrate, errata.md"
    p.integrate(h)
    wanted = tuple((v[i] + a[i] * h) * damping**h for i in range(3))
    equation = (
        "that is Eq. 3.6, v d^h + a h, which the book's listing contradicts (E-16): the engine "
        "keeps to the listing, (v + a h) d^h"
    )
    mistakes = [(tuple(v[i] * damping**h + a[i] * h for i in range(3)), equation)]
    cause = cause_of(xyz(p.velocity), mistakes, cause)
    expect_close(call, xyz(p.velocity), wanted, cause=cause, read=read, tolerance=1e-13)
    cause = "the velocity is damped, the acceleration is not"
    expect_unchanged(call, "p.acceleration", xyz(p.acceleration), a, cause=cause, read=read)


@pytest.mark.exercise("B3.4")
def test_a_new_damping_counts_from_the_next_step_on(rng: Random) -> None:
    v, damping = components(rng), round(rng.uniform(0.2, 0.8), 3)
    call = f"p = Particle(velocity=Vector3{v}); p.integrate(0.5); p.damping = {damping}; "
    call += "p.integrate(0.5); p.velocity"
    cause = "d^h belongs to the damping of now: what is kept from an earlier step is out of date"
    read = "the docstring of integrate"
    p = Particle(velocity=Vector3(*v))
    p.integrate(0.5)
    p.damping = damping
    p.integrate(0.5)
    kept = math.sqrt(damping)
    wanted = (v[0] * kept, v[1] * kept, v[2] * kept)
    expect_close(call, xyz(p.velocity), wanted, cause=cause, read=read)


@pytest.mark.exercise("B3.4")
def test_a_damping_of_0_stops_the_particle(rng: Random) -> None:
    x, v, h = components(rng), components(rng), draw_frame(rng)
    words, p = a_particle(x, v, (0.0, 0.0, 0.0), 0.0)
    call = f"{words}; p.integrate({h})"
    cause = "0^h is 0, so a damping of 0 keeps nothing; 0 counts as false where it is asked for"
    read = "the docstring of integrate"
    p.integrate(h)
    expect_close(f"{call}; p.velocity", xyz(p.velocity), (0.0, 0.0, 0.0), cause=cause, read=read)
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    cause = "the position moves with the velocity from before the step, which was not yet damped"
    name = f"{call}; p.position"
    expect_close(name, xyz(p.position), wanted, cause=cause, read=read, tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_the_mass_does_not_matter_to_a_given_acceleration(rng: Random) -> None:
    v, a, mass = components(rng), components(rng), round(rng.uniform(2.0, 90.0), 3)
    cause = "nothing is multiplied or divided by the mass here: an acceleration is no force"
    read = "book 3.2"
    for acceleration, damping in ((a, 1.0), ((0.0, 0.0, 0.0), 0.25)):
        call = (
            f"p = Particle(velocity=Vector3{v}, acceleration=Vector3{acceleration}, mass={mass}, "
        )
        call += f"{damping=}); p.integrate(0.5); p.velocity"
        vectors = {"velocity": Vector3(*v), "acceleration": Vector3(*acceleration)}
        p = Particle(**vectors, mass=mass, damping=damping)
        p.integrate(0.5)
        kept = math.sqrt(damping)
        wanted = tuple((v[i] + acceleration[i] * 0.5) * kept for i in range(3))
        expect_close(call, xyz(p.velocity), wanted, cause=cause, read=read)


@pytest.mark.exercise("B3.4")
def test_a_fall_of_5_seconds_lags_as_explicit_euler_does() -> None:
    call = "p = Particle(acceleration=Vector3(0, -10, 0)); p.integrate(1/60) 300 times; p.position"
    cause = "the error of explicit Euler is a t h / 2, here 0.41667 m short of 125 m"
    read = "book 3.3.2, Eq. 2.7 and 2.8"
    got = probes.position_after_fall(10.0, 1.0 / 60.0, 300)
    # -a t^2 / 2 + a t h / 2; 300 roundings of numbers up to 125.
    wanted = (0.0, -125.0 + 10.0 * 5.0 / 60.0 / 2.0, 0.0)
    expect_close(call, got, wanted, cause=cause, read=read, tolerance=1e-11)


@pytest.mark.exercise("B3.4")
def test_an_immovable_particle_stays_as_it_is(rng: Random) -> None:
    x, v, a, h = components(rng), components(rng), components(rng), draw_frame(rng)
    call = f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, mass=math.inf); p.integrate({h})"
    cause = "nothing moves it: return, where the inverse mass is 0, before anything is changed"
    read = "the docstring of integrate"
    p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=math.inf, damping=0.5)
    p.integrate(h)
    expect_unchanged(call, "p.position", xyz(p.position), x, cause=cause, read=read)
    expect_unchanged(call, "p.velocity", xyz(p.velocity), v, cause=cause, read=read)
    expect_unchanged(call, "p.acceleration", xyz(p.acceleration), a, cause=cause, read=read)
    p.mass = 2.0
    call = f"{call}; p.mass = 2.0; p.integrate({h}); p.position"
    cause = "now it has a finite mass and moves"
    p.integrate(h)
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    expect_close(call, xyz(p.position), wanted, cause=cause, read=read, tolerance=1e-13)


@pytest.mark.exercise("B3.4")
def test_the_last_acceleration_is_the_constant_one_and_a_vector_of_its_own(rng: Random) -> None:
    a = components(rng)
    call = f"p = Particle(acceleration=Vector3{a}, mass=4.0, damping=0.5); "
    call += "p.integrate(0.5); p.last_acceleration"
    cause = "the acceleration as it was given: it is no force, whatever the mass"
    read = "the docstring of last_acceleration"
    p = Particle(acceleration=Vector3(*a), mass=4.0, damping=0.5)
    p.integrate(0.5)
    last = p.last_acceleration
    expect_close(call, xyz(last), a, cause=cause, read=read)
    last.x = 99.0
    call = f"{call}.x = 99.0"
    cause = "the vector itself was given away: return a copy"
    expect_unchanged(call, "p.acceleration", xyz(p.acceleration), a, cause=cause, read=read)
    cause = "the acceleration of the last step, not of an earlier one"
    p.acceleration = Vector3(a[1], a[2], a[0])
    p.integrate(0.5)
    call = f"p.acceleration = Vector3{(a[1], a[2], a[0])}; p.integrate(0.5); p.last_acceleration"
    got = xyz(p.last_acceleration)
    expect_close(call, got, (a[1], a[2], a[0]), cause=cause, read=read)


@pytest.mark.exercise("B3.4")
def test_the_step_kicks_once_after_the_position_has_moved(rng: Random) -> None:
    x, v, h = components(rng), components(rng), draw_frame(rng)
    call = f"p.integrate({h}), where a class derived from Particle has a kick of its own: "
    read = "the docstring of integrate"
    kicks = probes.kicks_of_a_step(x, v, h)
    cause = "Chapter 5 adds forces to the kick. For its particle to have the same step, integrate "
    cause += "must call self.kick(duration), once."
    got = [duration for duration, _ in kicks]
    expect_exactly(f"{call}the durations of the kicks", got, [h], cause=cause, read=read)
    cause = "The drift comes first, with the velocity from before the step. The kick comes second."
    wanted = tuple(x[i] + v[i] * h for i in range(3))
    name = f"{call}p.position when kick is called"
    expect_close(name, kicks[0][1], wanted, cause=cause, read=read, tolerance=1e-13)


@pytest.mark.exercise("B3.4")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan])
def test_a_step_takes_a_positive_and_finite_duration(duration: float) -> None:
    read = "the docstring of integrate"
    x, v, a = (1.0, 2.0, 3.0), (4.0, 5.0, 6.0), (7.0, 8.0, 9.0)
    for mass in (1.0, math.inf):
        cause = "no time passes in it, or time runs back or for ever: positive of arguments.py "
        cause += "refuses it"
        if mass == math.inf:
            cause = "a bad duration is refused where nothing moves, too: look at it first"
        call = f"p = Particle(Vector3{x}, Vector3{v}, Vector3{a}, {mass=}); p.integrate({duration})"
        p = Particle(Vector3(*x), Vector3(*v), Vector3(*a), mass=mass)
        for _ in range(2):  # what is kept of the first attempt must not let the second one in
            expect_error(
                call,
                lambda p=p: p.integrate(duration),
                ValueError,
                allowed=lambda: Particle().integrate(0.5),
                cause=cause,
                read=read,
            )
        cause = "refuse the duration before anything is changed"
        expect_unchanged(call, "p.position", xyz(p.position), x, cause=cause, read=read)
        expect_unchanged(call, "p.velocity", xyz(p.velocity), v, cause=cause, read=read)


@pytest.mark.exercise("B3.4")
@pytest.mark.robust
def test_text_is_no_duration() -> None:
    call = 'Particle().integrate("0.5")'
    cause = "positive of arguments.py raises the TypeError for you"
    read = "the docstring of integrate"
    expect_error(
        call,
        lambda: Particle().integrate("0.5"),  # type: ignore[arg-type]
        TypeError,
        allowed=lambda: Particle().integrate(0.5),
        cause=cause,
        read=read,
    )
