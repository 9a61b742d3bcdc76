"""The wind of the sniper range, project 4.2a."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch05_forces.probes import winds
from ch05_forces.sniper import SniperRange, Wind
from draw import Components, components
from expect import (
    about,
    expect_between,
    expect_close,
    expect_exactly,
    expect_unchanged,
    named,
    scoped,
    xyz,
)

ZERO = (0.0, 0.0, 0.0)
READ = "the docstring of Wind.update_force"
CHANGE = "the docstring of change_wind"


@scoped
def blow(v: Components, w: Components, k1: float, k2: float) -> tuple[str, object]:
    """Let the wind act on a particle; return the words and the force."""
    about.call = f"p = Particle(velocity=Vector3{v}, mass=4.0); wind = Wind(k1={k1}, k2={k2}); "
    about.call += f"wind.velocity = Vector3{w}; wind.update_force(p, 0.5); p.force_accumulator, in "
    about.call += "N"
    p, wind = Particle(velocity=Vector3(*v), mass=4.0), Wind(k1, k2)
    wind.velocity = Vector3(*w)
    wind.update_force(p, 0.5)
    del about.cause, about.read  # what is said where update_force raises
    return about.call, xyz(p.force_accumulator)


@pytest.mark.exercise("P4.2a")
def test_the_wind_is_drag_relative_to_the_air(rng: Random) -> None:
    about.read = READ
    v, w = components(rng), components(rng)
    k1, k2 = round(rng.uniform(0.2, 0.9), 3), round(rng.uniform(0.2, 0.9), 3)
    about.cause = "Drag depends on the velocity relative to the air, u = v - w, where w is the "
    about.cause += "wind. The force must be -u (k1 + k2 |u|)."
    u = [v[i] - w[i] for i in range(3)]

    def drag(a: Sequence[float], one: float, two: float) -> list[float]:
        return [-part * (one + two * math.hypot(*a)) for part in a]

    for one, two in ((k1, 0.0), (0.0, k2), (k1, k2)):
        about.call, got = blow(v, w, one, two)
        wanted = drag(u, one, two)
        still, blown = drag(v, one, two), drag(w, one, two)
        slips = {
            "This is the drag in still air. Subtract the velocity of the wind from the "
            "velocity of the particle first.": still,
            (
                "This is the force on a particle at rest, because you use the wind alone. "
                "Subtract the velocity of the wind from the velocity of the particle."
            ): [-part for part in blown],
            "You add the velocity w of the wind to the velocity v of the particle. Drag "
            "depends on the velocity relative to the air, so use v - w.": drag(
                [v[i] + w[i] for i in range(3)], one, two
            ),
            "Your force points in the wrong direction, because it was computed with w - v. Use "
            "v - w, where v is the velocity of the particle and w that of the wind.": [
                -part for part in wanted
            ],
            "You swapped k1 and k2. In the drag, k1 is multiplied by the speed, and k2 by the "
            "square of the speed.": drag(u, two, one),
            "You add two drags, one for the particle's velocity v and one for the wind's "
            "velocity w. Compute v - w first, and then a single drag at that velocity.": [
                still[i] - blown[i] for i in range(3)
            ],
        }
        why = named(got, about.cause, slips)
        # A few roundings of numbers up to 700.
        expect_close(got, wanted, cause=why, tolerance=1e-11)


@pytest.mark.exercise("P4.2a")
def test_what_moves_with_the_air_feels_nothing(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    about.cause = "The particle moves along with the wind, so its velocity relative to the air is "
    about.cause += "0. No force must act on it."
    about.call, got = blow(v, v, 0.5, 0.25)
    expect_close(got, ZERO)
    about.cause = "The wind must push a particle at rest in the direction of the wind. Use v - w "
    about.cause += "as the relative velocity, and check the sign of the force."
    about.call, got = blow(ZERO, (2.0, 0.0, 0.0), 0.5, 0.25)
    expect_close(got, (2.0, 0.0, 0.0))
    about.cause = "The air is still, so the force must be ordinary drag, against the particle's "
    about.cause += "velocity."
    about.call, got = blow((0.0, 0.0, 2.0), ZERO, 0.5, 0.25)
    expect_close(got, (0.0, 0.0, -2.0))


@pytest.mark.exercise("P4.2a")
def test_the_wind_adds_a_force_and_changes_nothing_else(rng: Random) -> None:
    about.read = READ
    f, v, w = components(rng), components(rng), components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}); p.add_force(Vector3{f}); wind = Wind(k1=0.5, "
    about.call += f"k2=0.0); wind.velocity = Vector3{w}; wind.update_force(p, 0.5)"
    about.cause = "update_force must add the force with add_force, which keeps the other forces. "
    about.cause += "It must not change the velocity of the particle or of the wind."
    p, wind = Particle(velocity=Vector3(*v)), Wind(0.5, 0.0)
    p.add_force(Vector3(*f))
    wind.velocity = Vector3(*w)
    wind.update_force(p, 0.5)
    wanted = tuple(f[i] - 0.5 * (v[i] - w[i]) for i in range(3))
    got = xyz(p.force_accumulator)
    # A few roundings of numbers up to 30.
    expect_close(got, wanted, then="; p.force_accumulator, in N", tolerance=1e-13)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    expect_unchanged("wind.velocity", xyz(wind.velocity), w)


@pytest.mark.exercise("P4.2a")
def test_the_wind_is_drawn_level_and_from_both_sides(rng: Random) -> None:
    about.read = CHANGE
    seed = rng.randrange(1000)
    about.call = f"range = SniperRange({seed}); range.change_wind() 400 times"
    about.cause = "Each call of change_wind must draw a new wind. Call self.random.uniform once "
    about.cause += "for x and once for z."
    (seen,) = winds([seed], 400)
    expect_exactly(
        len(seen),
        401,
        call=f"{about.call}; number of winds",
        cause="Draw exactly one wind in each call to change_wind.",
    )
    about.cause = "Your wind has a vertical component, but it must be horizontal. Set y to 0."
    highest = max(abs(y) for _, y, _ in seen)
    expect_close(highest, 0.0, then="; the largest |y| of all winds, in m/s")
    for name, blown in (("x", [w[0] for w in seen]), ("z", [w[2] for w in seen])):
        about.cause = f"Draw the {name} component uniformly between -STRONGEST_WIND and "
        about.cause += "STRONGEST_WIND, which is 10 m/s."
        # Of 401 uniform numbers in 20 none lies in the last of either side once in 10^8 runs, and
        # their mean is beyond 2 more seldom: 7 times its deviation.
        for what, got, low, high in (
            ("smallest", min(blown), -10.0, -9.0),
            ("largest", max(blown), 9.0, 10.0),
            ("mean", sum(blown) / len(blown), -2.0, 2.0),
        ):
            why = about.cause
            if abs(got) > 10.0:
                why = "A component of the wind is larger than 10 m/s, perhaps because you add the "
                why += f"new wind to the old one. {about.cause}"
            expect_between(
                got, low, high, then=f"; the {what} {name} of all winds, in m/s", cause=why
            )
    about.cause = "Weak winds are too rare or too common. Draw x and z independently of each other."
    # |w| < 5 for 0.196 of all: 79 of 401, and beyond these bounds once in 10^9 runs.
    weak = sum(math.hypot(x, z) < 5.0 for x, _, z in seen)
    expect_between(weak, 27, 131, then="; number of winds below 5 m/s")
    # x z > 0 for half of all: 200 of 401, and beyond these bounds once in 10^11 runs.
    about.cause = "Winds from some directions are too common. Draw x and z independently of each "
    about.cause += "other."
    same = sum(x * z > 0.0 for x, _, z in seen)
    expect_between(same, 130, 270, then="; number of winds in which x and z have the same sign")
    about.cause = "In some winds, x and z have the same absolute value. Draw a random float for "
    about.cause += "each of them, and don't round it, because two such numbers are almost never "
    about.cause += "equal."
    same = sum(abs(abs(x) - abs(z)) < 1e-9 for x, _, z in seen)
    expect_exactly(same, 0, then="; number of winds with |x| = |z|")


@pytest.mark.exercise("P4.2a")
def test_the_wind_stays_the_same_generator() -> None:
    about.read = CHANGE
    about.call = "range = SniperRange(1); wind = range.wind; wind.k1 = 0.5; range.change_wind()"
    about.cause = "change_wind created a new Wind object, but the registry still holds the old "
    about.cause += "one. Change the velocity of self.wind instead."
    at = SniperRange(1)
    wind = at.wind
    before = xyz(wind.velocity)
    wind.k1 = 0.5
    at.change_wind()
    after = xyz(wind.velocity)
    expect_close(at.wind.k1, 0.5, then="; range.wind.k1")
    now = xyz(at.wind.velocity)
    gap = tuple(now[i] - after[i] for i in range(3))
    expect_close(gap, ZERO, then="; range.wind.velocity minus wind.velocity")
    about.cause = "The wind has the same velocity as before. Draw a new one, and store it in "
    about.cause += "self.wind.velocity."
    expect_exactly(after == before, False, then="; range.wind.velocity is the same as before")


@pytest.mark.exercise("P4.2a")
def test_the_wind_follows_the_seed_of_its_range(rng: Random) -> None:
    about.read = CHANGE
    seed = rng.randrange(1000)
    about.call = f"SniperRange({seed}) twice and SniperRange({seed + 1}) once; change_wind() six "
    about.call += "times for each of the three ranges"
    about.cause = "The same seed must always give the same winds. Draw with self.random, which "
    about.cause += "was created from the seed, instead of the random module."
    first, second, other = winds([seed, seed, seed + 1], 6)
    same = sum(a == b for a, b in zip(first, second, strict=True))
    expect_exactly(
        same, 7, then="; number of winds that are the same in the two ranges with the same seed"
    )
    about.cause = "Two different seeds gave the same winds. Draw with self.random, which was "
    about.cause += "created from the seed of the range."
    same = sum(a == b for a, b in zip(first, other, strict=True))
    expect_exactly(
        same, 0, then="; number of winds that are the same in ranges with different seeds"
    )
    about.cause = "Some calls of change_wind gave the same wind again. Draw a new wind in every "
    about.cause += "call."
    kinds = len({tuple(w) for w in first})
    expect_exactly(kinds, 7, then="; number of different winds of the first range")
