"""Where steps lead: energy and stability in build tasks B6.6 to B6.8, accuracy in G6.3."""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random

import pytest

from calls import calls
from ch06_springs.step_probes import Body, energy_left, growth, own_steps, stepped
from draw import Components, Triple, positive_number, unit_vector, vector
from expect import about, expect_between, expect_close, expect_exactly

ZERO = (0.0, 0.0, 0.0)
EXERCISES = {
    "explicit_euler": "B6.6",
    "semi_implicit_euler": "B6.6",
    "leapfrog": "B6.12",
    "velocity_verlet": "B6.7",
    "runge_kutta_4": "B6.8",
}
LIMITS = {  # of k h^2 / m
    "semi_implicit_euler": 4.0,
    "leapfrog": 4.0,
    "velocity_verlet": 4.0,
    "runge_kutta_4": 8.0,
}
H = 1.0 / 60.0
KAPPA = 100.0 * H**2  # k h^2 / m of the spring whose energy is measured
STEP = "the docstring of my_step"
FRAMES, ECCENTRICITY = 60, 0.5
FEW, MOST = 500, 5000  # evaluations: to be good, and at all
ORBIT = f"p moves once around an orbit of eccentricity {ECCENTRICITY}; my_step([p], apply_forces, "
ORBIT += f"duration) {FRAMES} times"
ERROR = "; the largest distance from the true orbit, divided by the semi-major axis"
Forces = Callable[[list[Components]], list[Components]]


def methods(*names: str, asks: str) -> pytest.MarkDecorator:
    """Run a check for some integrators, each as a check of its exercise."""
    marks = {
        name: pytest.mark.exercise(EXERCISES[name], asks=asks, read=f"the docstring of {name}")
        for name in names
    }
    return pytest.mark.parametrize("method", [pytest.param(n, marks=marks[n]) for n in names])


def expect_energy(method: str, frames: int, wanted: float, tolerance: float, cause: str) -> None:
    """Expect the energy of a spring after some steps, divided by that at the start."""
    with calls(
        cause,
        f"{method}([p], apply_forces, h) {frames} times, with p of 1 kg on a spring of 100 N/m, "
        "from rest at 1 m, and h = 1/60 s; the final energy divided by the initial energy",
    ):
        got = energy_left(method, 100.0, H, frames)
    expect_close(got, wanted, tolerance=tolerance)


@pytest.mark.exercise(
    "B6.6",
    asks="every step multiplies the energy by the same factor",
    read="the docstring of explicit_euler, and E-17",
)
def test_explicit_euler_gains_energy_by_its_factor() -> None:
    wanted = (1.0 + KAPPA) ** 600
    cause = "Each step multiplies the energy by 1 + k h^2 / m. Move p with its old velocity."
    # 600 steps of a few roundings each.
    expect_energy("explicit_euler", 600, wanted, 1e-11 * wanted, cause)


@pytest.mark.exercise(
    "B6.6",
    asks="its energy never drifts as long as the spring",
    read="the docstring of semi_implicit_euler",
)
def test_semi_implicit_euler_keeps_energy_near_its_start() -> None:
    """Only here thousands of steps add up a drift that one step hides in its tolerance."""
    cause = "The energy may vary by a fraction of about chi h / 2 with chi = sqrt(k / m), but it "
    cause += "must not drift. Change the velocity first, and then move with the new velocity."
    for frames in (600, 6000):
        # chi h / 2 is 1/12; its square comes on top.
        expect_energy("semi_implicit_euler", frames, 1.0, 0.1, cause)
    cause = "The particle starts at rest at 1 m. One step must give it the velocity -k h / m and "
    cause += "then, with this new velocity, the position 1 - k h^2 / m."
    expect_energy("semi_implicit_euler", 1, (1.0 - KAPPA) ** 2 + KAPPA, 1e-12, cause)


@pytest.mark.exercise(
    "B6.12", asks="keeps the energy within a narrower band", read="the docstring of leapfrog"
)
def test_leapfrog_swings_as_its_frequency_says() -> None:
    """Only here thousands of steps must end at the energy of a closed form."""
    cause = "The energy keeps returning to its start. Drift for h / 2, kick for h, drift for h / 2."
    for frames in (1, 600, 6000):
        angle = frames * 2.0 * math.asin(0.5 * math.sqrt(KAPPA))
        # From rest x is cos(n w h), and v / chi is -sin(n w h) / sqrt(1 - kappa / 4).
        wanted = math.cos(angle) ** 2 + math.sin(angle) ** 2 / (1.0 - KAPPA / 4.0)
        # Each step has a few roundings; the angle gathers those of all of them.
        expect_energy("leapfrog", frames, wanted, 1e-9, cause)


@pytest.mark.exercise(
    "B6.6",
    asks="undamped springs below max_stable_stiffness are stable",
    read="the docstring of explicit_euler and of max_stable_stiffness",
)
def test_damping_saves_explicit_euler_up_to_a_stiffness() -> None:
    keep = 0.5**H
    for share in (0.98, 1.02):
        k = share * (1.0 / keep - 1.0) / H**2
        with calls(
            "Multiply the velocity by d^h once per step, and move p with its old velocity.",
            f"explicit_euler([p], apply_forces, h) with p of 1 kg and damping d = 0.5 on a spring "
            f"of {k:.4f} N/m, and h = 1/60 s; the largest distance in steps 1500 to 2000, divided "
            "by that in steps 0 to 500",
        ):
            near = growth("explicit_euler", k, 0.5, H, 500)
            far = growth("explicit_euler", k, 0.5, H, 2000, since=1500)
        # The farthest of a swing lies between frames, at most 0.2 % farther, and is up to half a
        # swing of 58 frames from where the 500 begin or end, in which it changes by 0.4 %.
        expect_close(far / near, (keep * (1.0 + k * H * H)) ** 750, tolerance=0.01)


@methods("explicit_euler", *LIMITS, asks="says how quickly its error shrinks")
def test_the_order_of_a_step(method: str) -> None:
    body: Body = ((1.0, 0.0, 0.5), (0.0, 1.0, 0.0), ZERO, 1.0, 1.0, ZERO)
    order = {"leapfrog": 2, "velocity_verlet": 2, "runge_kutta_4": 4}.get(method, 1)
    for what, forces in (("", (1.0, 0.0, 1.0)), (" - v / 2", (1.0, 0.5, 1.0))):
        if method == "leapfrog" and what:
            order = 1  # it asks with the old velocity for forces that depend on it
        with calls(
            f"The error of this method must be smaller by a factor of {2**order} if the time step "
            "is halved. Perhaps you evaluate a force at the wrong time, or move the particle with "
            "the wrong velocity.",
            f"{method}(particles, apply_forces, h); forces -(1 + r^2) x{what} for 1 s, in 80, 160 "
            "and 320 steps; log2 of the ratio of the differences between the final positions, "
            "which is the order of the method",
        ):
            ends = [
                stepped(method, [body], forces, 1 / n, n)["positions"][0] for n in (80, 160, 320)
            ]
        long, short = math.dist(ends[0], ends[1]), math.dist(ends[1], ends[2])
        # The next order adds some h to it: 0.01 at most here.
        got = math.log2(long / short) if short > 0.0 else math.nan
        expect_close(got, float(order), tolerance=0.1)


@methods(*LIMITS, asks="stable if k h² / m is below")
def test_a_step_fails_just_beyond_its_limit_and_not_before(method: str) -> None:
    limit = LIMITS[method]
    for share in (0.98, 1.02):
        k = share * limit / H**2
        with calls(
            f"{method} is stable as long as k h^2 / m is below {limit:g}, and here it is "
            f"{share * limit:g}. Your step behaves differently, so compare it with the formulas in "
            "the docstring.",
            f"{method}([p], apply_forces, h) 500 times, with p of 1 kg on a spring of {k:.6g} N/m, "
            "released 1 m away, and h = 1/60 s",
        ):
            far = growth(method, k, 1.0, H, 500)
        expect_exactly(far < 100.0, share < 1.0, then="; the largest distance is below 100 m")
        expect_exactly(far > 1e6, share > 1.0, then="; the largest distance is above 1e6 m")


class Asked:
    """A field of forces that counts its evaluations, and refuses more than MOST of them."""

    def __init__(self, forces_at: Forces) -> None:
        self.forces_at, self.count = forces_at, 0

    def __call__(self, places: list[Components]) -> list[Components]:
        self.count += 1
        if self.count > MOST:
            cause = f"Your steps evaluate the forces more than {MOST} times in total. Split each "
            about(cause=f"{cause}time step into fewer parts.")
            raise ValueError(
                f"more than {MOST} evaluations of the forces: split the time step into fewer parts"
            )
        return [(x, y, z) for x, y, z in self.forces_at(places)]


def turn_of_an_orbit(rng: Random) -> tuple[int, float]:
    """Step once around a center, and return the number of evaluations and the largest error.

    The error is the distance from the solution of Kepler's equation, in units of the semi-major
    axis. The size, position and plane of the orbit, the mass and the strength of the force are
    drawn, but neither result depends on them.
    """
    size, mass, mu = (positive_number(rng, 0.5, 4.0) for _ in range(3))
    center, along, other = vector(rng), unit_vector(rng), unit_vector(rng)
    across = other - (along @ other) * along
    across /= abs(across)

    def place(x: float, y: float) -> Triple:
        return center + x * along + y * across

    def forces_at(places: list[Components]) -> list[Components]:
        offset = Triple(places[0]) - center
        return [-mu * mass / abs(offset) ** 3 * offset]

    e = ECCENTRICITY
    velocity = math.sqrt(mu / size * (1.0 + e) / (1.0 - e)) * across
    start = (place(size * (1.0 - e), 0.0), velocity, (0.0, 0.0, 0.0), mass)
    duration = 2.0 * math.pi * math.sqrt(size**3 / mu) / FRAMES
    field = Asked(forces_at)
    places, *_ = own_steps([start], field, duration, FRAMES)
    worst = 0.0
    for frame, (found,) in zip(range(1, FRAMES + 1), places, strict=True):
        angle = mean = 2.0 * math.pi * frame / FRAMES
        for _ in range(60):  # Newton's method on Kepler's equation, which has long converged then
            angle -= (angle - e * math.sin(angle) - mean) / (1.0 - e * math.cos(angle))
        true = place(size * (math.cos(angle) - e), size * math.sqrt(1.0 - e * e) * math.sin(angle))
        error = math.dist(found, true) / size
        worst = error if not error <= worst else worst  # a NaN stays
    return field.count, worst


@pytest.mark.exercise("G6.3", asks="farther from its true position than 0.5 %", read=STEP)
def test_it_moves_all_particles_by_their_forces(rng: Random) -> None:
    m, n = positive_number(rng, 1.0, 4.0), positive_number(rng, 1.0, 4.0)
    stiffness, along = positive_number(rng, 5.0, 20.0), unit_vector(rng)
    v, a, middle = vector(rng), vector(rng), vector(rng)
    shares = (-n / (m + n), m / (m + n))

    def ends(swung: float, t: float) -> list[Triple]:
        """Where the two are: their middle falls, the spring between them swings."""
        fallen = middle + t * v + 0.5 * t * t * a
        return [fallen + share * swung * along for share in shares]

    def forces_at(places: list[Components]) -> list[Components]:
        pull = stiffness * (Triple(places[1]) - places[0])
        return [pull, -pull]

    period = 2.0 * math.pi * math.sqrt(m * n / (m + n) / stiffness)
    start = ends(1.0, 0.0)
    with calls(
        "Your step is less accurate than velocity Verlet. Use a method of order 2 or more.",
        f"two particles of {m} kg and {n} kg are joined by a spring of {stiffness} N/m; "
        f"my_step(particles, apply_forces, duration) {FRAMES} times",
    ):
        bodies = [(place, v, a, mass) for place, mass in zip(start, (m, n), strict=True)]
        places, velocities, left = own_steps(bodies, Asked(forces_at), period / FRAMES, FRAMES)
    cause = about.cause
    for frame in (15, 40, 60):
        t = period * frame / FRAMES
        found = [Triple(place) for place in places[frame - 1]]
        true = ends(math.cos(2.0 * math.pi * frame / FRAMES), t)
        if abs(m * (found[0] - true[0]) + n * (found[1] - true[1])) < 5e-3:
            cause = "The center of mass moves correctly, but the particles don't oscillate "
            cause += "correctly around it. Clear the forces of each particle after you use them, "
            cause += "and use a method of order 2 or more."
        for which, (got, wanted) in enumerate(zip(found, true, strict=True)):
            if not math.dist(got, wanted) < 5.0:
                cause = "Your particle is more than 5 m from its true position, where even "
                cause += "explicit Euler comes closer. Multiply every change of a position or "
                cause += "velocity by its part of the duration."
            apart = (0.5 - which) * (1.0 - math.cos(math.sqrt(2.0 * stiffness) * t))
            slips = {
                "You leave out the particle's own acceleration. Add it to f / m, the acceleration "
                "that the forces cause.": wanted - 0.5 * t * t * a,
                "You don't divide the force f by the mass m. The acceleration is "
                "particle.acceleration + f / m.":
                    start[which] + t * v + 0.5 * t * t * a + apart * along,
            }  # fmt: skip
            near = [slip for slip, wrong in slips.items() if math.dist(got, wrong) < 2e-2]
            then = f"; particles[{which}].position after {frame} steps"
            # Of a length of 1 m; velocity Verlet, once a frame, is off by 3e-3 at most.
            expect_close(got, wanted, then=then, unit="m", cause=[*near, cause][0], tolerance=5e-3)
    # After a whole period the spring has its velocity of the start, none; it has up to 9 m/s.
    cause = "The velocities are not those at the end of the step. Update them over all of it, too."
    got, then = velocities[-1][0], f"; particles[0].velocity after {FRAMES} steps"
    expect_close(got, v + period * a, then=then, unit="m/s", cause=cause, tolerance=5e-2)
    cause = "Clear the forces of each particle after you use them. Some are left at the end."
    then = "; particles[0].force_accumulator after the last step"
    expect_close(left[0], (0.0, 0.0, 0.0), then=then, unit="N", cause=cause, tolerance=0.0)


@pytest.mark.exercise("G6.3", asks="It must be at most 1e-2.", read=STEP)
def test_it_follows_an_orbit(rng: Random, on_chart: Callable[[float, float], None]) -> None:
    with calls(
        f"Use a method of order 2 or more, and at most {MOST} evaluations of the forces in total.",
        ORBIT,
    ):
        count, error = turn_of_an_orbit(rng)
    on_chart(count, error)
    # Velocity Verlet in 16 parts a frame is off by 2e-3, explicit Euler in 80 by 0.3.
    expect_between(error, 0.0, 0.01, then=ERROR)


@pytest.mark.exercise("G6.3", asks="With at most 500 evaluations, an error of 1e-3", read=STEP)
@pytest.mark.parametrize("most", [1e-3, 1e-4], ids=["error 0.001", "error 0.0001"])
def test_it_is_accurate_with_few_evaluations(rng: Random, most: float) -> None:
    with calls(
        f"Evaluate the forces at most {FEW} times. Split each time step into fewer parts.",
        ORBIT,
    ):
        count, error = turn_of_an_orbit(rng)
    expect_between(count, 0, FEW, then="; the number of evaluations of the forces")
    cause = f"Your step is not accurate enough for its {count} evaluations of the forces. Take "
    cause += "shorter steps where the particle moves fast, and longer ones elsewhere."
    # Runge-Kutta 4, twice a frame, has 480 and 2.4e-4. These do not depend on what is drawn.
    expect_between(error, 0.0, most, then=ERROR, cause=cause)
