"""Going further, G6.3: a step of one's own, by its evaluations and its error."""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random

import pytest

from ch06_springs.step_probes import own_steps
from draw import Components, components, direction, dot, positive_number
from expect import about, blame, expect_between, expect_close

STEP = "the docstring of my_step"
FRAMES, ECCENTRICITY = 60, 0.5
FEW, MOST = 500, 5000  # evaluations: to be good, and at all


class Asked:
    """A field of forces that counts its evaluations, and refuses more than MOST of them."""

    def __init__(self, forces_at: Callable[[list[Components]], list[Components]]) -> None:
        self.forces_at, self.count = forces_at, 0

    def __call__(self, places: list[Components]) -> list[Components]:
        self.count += 1
        if self.count > MOST:
            about.cause = f"Your steps evaluate the forces more than {MOST} times in total. Split "
            about.cause += "each time step into fewer parts."
            raise ValueError(
                f"more than {MOST} evaluations of the forces: split the time step into fewer parts"
            )
        return self.forces_at(places)


def turn_of_an_orbit(rng: Random) -> tuple[int, float]:
    """Step once around a center, and return the number of evaluations and the largest error.

    The error is the distance from the solution of Kepler's equation, in units of the semi-major
    axis. The size, position and plane of the orbit, the mass and the strength of the force are
    drawn, but neither result depends on them.
    """
    size, mass, mu = (positive_number(rng, 0.5, 4.0) for _ in range(3))
    center, along = components(rng), direction(rng)
    other = direction(rng)
    share = dot(along, other)
    across = [b - share * a for a, b in zip(along, other, strict=True)]
    length = math.hypot(*across)
    across = [part / length for part in across]

    def place(x: float, y: float) -> Components:
        a, b, c = (o + x * p + y * q for o, p, q in zip(center, along, across, strict=True))
        return a, b, c

    def forces_at(places: list[Components]) -> list[Components]:
        offset = [a - b for a, b in zip(places[0], center, strict=True)]
        strength = -mu * mass / math.hypot(*offset) ** 3
        return [tuple(strength * part for part in offset)]  # type: ignore[list-item]

    e = ECCENTRICITY
    speed = math.sqrt(mu / size * (1.0 + e) / (1.0 - e))
    x, y, z = (speed * part for part in across)
    start = (place(size * (1.0 - e), 0.0), (x, y, z), (0.0, 0.0, 0.0), mass)
    duration = 2.0 * math.pi * math.sqrt(size**3 / mu) / FRAMES
    field = Asked(forces_at)
    places, *_ = own_steps([start], field, duration, FRAMES)
    worst = 0.0
    for frame, (found,) in zip(range(1, FRAMES + 1), places, strict=True):
        mean = 2.0 * math.pi * frame / FRAMES
        angle = mean
        for _ in range(60):  # Newton's method on Kepler's equation, which has long converged then
            angle -= (angle - e * math.sin(angle) - mean) / (1.0 - e * math.cos(angle))
        true = place(size * (math.cos(angle) - e), size * math.sqrt(1.0 - e * e) * math.sin(angle))
        error = math.dist(found, true) / size
        worst = error if not error <= worst else worst  # a NaN stays
    return field.count, worst


@pytest.mark.exercise("G6.3", asks="farther from its true position than 0.5 %")
def test_it_moves_all_particles_by_their_forces(rng: Random) -> None:
    about.read = STEP
    m, n = positive_number(rng, 1.0, 4.0), positive_number(rng, 1.0, 4.0)
    stiffness, along = positive_number(rng, 5.0, 20.0), direction(rng)
    v, a, middle = components(rng), components(rng), components(rng)
    about.call = f"two particles of {m} kg and {n} kg are joined by a spring of {stiffness} N/m; "
    about.call += f"my_step(particles, apply_forces, duration) {FRAMES} times"
    about.cause = "Your step is less accurate than velocity Verlet, whose error is at most 0.003 m "
    about.cause += "here. Use a method of order 2 or more."

    def ends(swung: float, t: float) -> list[Components]:
        """Where the two are: their middle falls, the spring between them swings."""
        fallen = [p + q * t + 0.5 * r * t * t for p, q, r in zip(middle, v, a, strict=True)]
        shares = (-n / (m + n) * swung, m / (m + n) * swung)
        return [
            tuple(p + share * part for p, part in zip(fallen, along, strict=True))  # type: ignore[misc]
            for share in shares
        ]

    def forces_at(places: list[Components]) -> list[Components]:
        offset = [q - p for p, q in zip(*places, strict=True)]
        pull = [stiffness * part for part in offset]
        return [tuple(pull), tuple(-part for part in pull)]  # type: ignore[list-item]

    def mistakes(which: int, t: float, place: Components) -> list[tuple[list[float], str]]:
        """Return about where a particle is after each of two mistakes."""
        apart = (0.5 - which) * (1.0 - math.cos(math.sqrt(2.0 * stiffness) * t))
        parts = zip(ends(1.0, 0.0)[which], v, a, along, strict=True)
        return [
            (
                [p - 0.5 * r * t * t for p, r in zip(place, a, strict=True)],
                "You leave out the particle's own acceleration. Add it to f / m, the acceleration "
                "that the forces cause.",
            ),
            (
                [s + q * t + 0.5 * r * t * t + apart * part for s, q, r, part in parts],
                "You don't divide the force f by the mass m. The acceleration is "
                "particle.acceleration + f / m.",
            ),
        ]

    period = 2.0 * math.pi * math.sqrt(m * n / (m + n) / stiffness)
    bodies = [(place, v, a, mass) for place, mass in zip(ends(1.0, 0.0), (m, n), strict=True)]
    places, velocities, left = own_steps(bodies, Asked(forces_at), period / FRAMES, FRAMES)
    for frame in (15, 40, 60):
        true = ends(math.cos(2.0 * math.pi * frame / FRAMES), period * frame / FRAMES)
        ways = [
            [p - q for p, q in zip(*pair, strict=True)]
            for pair in zip(places[frame - 1], true, strict=True)
        ]
        if math.hypot(*(m * p + n * q for p, q in zip(*ways, strict=True))) < 5e-3:
            about.cause = "The center of mass moves correctly, but the particles don't oscillate "
            about.cause += "correctly around it. Clear the forces of each particle after you use "
            about.cause += "them, and use a method of order 2 or more."
        for which, place in enumerate(true):
            # Of a length of 1 m; velocity Verlet, once a frame, is off by 3e-3 at most.
            got = places[frame - 1][which]
            if not math.dist(got, place) < 5.0:
                about.cause = "Your particle is more than 5 m from its true position, where even "
                about.cause += "explicit Euler comes closer. Multiply every change of a position "
                about.cause += "or velocity by its part of the duration."
            blame(got, mistakes(which, period * frame / FRAMES, place), tolerance=1e-3)
            expect_close(
                got,
                place,
                then=f"; particles[{which}].position after {frame} steps, in m",
                tolerance=5e-3,
            )
    falling = [p + q * period for p, q in zip(v, a, strict=True)]
    about.cause = "The positions are right, but the velocities are not those at the end of the "
    about.cause += "step. Update the velocities over the whole duration too."
    # After a whole period the spring has its velocity of the start, none; it has up to 9 m/s.
    expect_close(
        velocities[-1][0],
        falling,
        then=f"; particles[0].velocity after {FRAMES} steps, in m/s",
        tolerance=5e-2,
    )
    about.cause = "Some forces are still in the accumulators at the end of the step. Clear the "
    about.cause += "forces of each particle after you use them."
    expect_close(
        left[0],
        (0.0, 0.0, 0.0),
        then="; particles[0].force_accumulator after the last step, in N",
        tolerance=0.0,
    )


@pytest.mark.exercise("G6.3", asks="It must be at most 1e-2.")
def test_it_follows_an_orbit(rng: Random, on_chart: Callable[[float, float], None]) -> None:
    about.read = STEP
    about.call = f"p moves once around an orbit of eccentricity {ECCENTRICITY}; my_step([p], "
    about.call += f"apply_forces, duration) {FRAMES} times"
    about.cause = "Explicit and semi-implicit Euler are not accurate enough here. Use a method of "
    about.cause += "order 2 or more. You may split a step into parts, as long as you evaluate the "
    about.cause += f"forces at most {MOST} times in total."
    count, error = turn_of_an_orbit(rng)
    on_chart(count, error)
    # Velocity Verlet in 16 parts a frame is off by 2e-3, explicit Euler in 80 by 0.3.
    expect_between(
        error,
        0.0,
        0.01,
        then="; the largest distance from the true orbit, divided by the semi-major axis",
    )


@pytest.mark.exercise("G6.3", asks="With at most 500 evaluations, an error of 1e-3")
@pytest.mark.parametrize("most", [1e-3, 1e-4], ids=["error 0.001", "error 0.0001"])
def test_it_is_accurate_with_few_evaluations(rng: Random, most: float) -> None:
    about.read = STEP
    about.call = f"p moves once around an orbit of eccentricity {ECCENTRICITY}; my_step([p], "
    about.call += f"apply_forces, duration) {FRAMES} times"
    about.cause = "Your steps evaluate the forces too often. Split each time step into fewer "
    about.cause += f"parts, so that one revolution takes at most {FEW} evaluations."
    count, error = turn_of_an_orbit(rng)
    expect_between(count, 0, FEW, then="; the number of evaluations of the forces")
    about.cause = f"Your step is not accurate enough for its {count} evaluations of the forces. "
    about.cause += "Take shorter steps where the particle moves fast, and longer ones elsewhere."
    # Runge-Kutta 4, twice a frame, has 480 and 2.4e-4. These do not depend on what is drawn.
    expect_between(
        error,
        0.0,
        most,
        then="; the largest distance from the true orbit, divided by the semi-major axis",
    )
