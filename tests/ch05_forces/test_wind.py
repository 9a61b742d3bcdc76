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
from expect import about, expect_close, expect_exactly, expect_unchanged, named, scoped, xyz

ZERO = (0.0, 0.0, 0.0)
READ = "the docstring of Wind.update_force"
CHANGE = "the docstring of change_wind"


@scoped
def blow(v: Components, w: Components, k1: float, k2: float) -> tuple[str, object]:
    """Let the wind act on a particle; return the words and the force."""
    about.call = f"p = Particle(velocity=Vector3{v}, mass=4.0); wind = Wind({k1}, {k2}); "
    about.call += f"wind.velocity = Vector3{w}; wind.update_force(p, 0.5); p.force_accumulator"
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
    about.cause = "Eq. 5.1 with u = v - w, the velocity relative to the air: -u (k1 + k2 |u|)"
    u = [v[i] - w[i] for i in range(3)]

    def drag(a: Sequence[float], one: float, two: float) -> list[float]:
        return [-part * (one + two * math.hypot(*a)) for part in a]

    for one, two in ((k1, 0.0), (0.0, k2), (k1, k2)):
        about.call, got = blow(v, w, one, two)
        wanted = drag(u, one, two)
        still, blown = drag(v, one, two), drag(w, one, two)
        slips = {
            "the drag at v, as in still air": still,
            "the force on a particle at rest, as if v were 0": [-part for part in blown],
            "the drag at v + w": drag([v[i] + w[i] for i in range(3)], one, two),
            "the drag at w - v, the other way round": [-part for part in wanted],
            "Eq. 5.1 with k1 and k2 exchanged": drag(u, two, one),
            "the drag at v and the push at w, each for itself": [
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
    about.cause = "the wind blows things along until they are as fast as it is; then there is no "
    about.cause += "force"
    about.call, got = blow(v, v, 0.5, 0.25)
    expect_close(got, ZERO)
    about.cause = "the wind pushes what is at rest along its own way: u is v - w, and not w - v"
    about.call, got = blow(ZERO, (2.0, 0.0, 0.0), 0.5, 0.25)
    expect_close(got, (2.0, 0.0, 0.0))
    about.cause = "in still air the wind is the drag of the bullet"
    about.call, got = blow((0.0, 0.0, 2.0), ZERO, 0.5, 0.25)
    expect_close(got, (0.0, 0.0, -2.0))


@pytest.mark.exercise("P4.2a")
def test_the_wind_adds_a_force_and_changes_nothing_else(rng: Random) -> None:
    about.read = READ
    f, v, w = components(rng), components(rng), components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}); p.add_force(Vector3{f}); wind = Wind(0.5, "
    about.call += f"0.0); wind.velocity = Vector3{w}; wind.update_force(p, 0.5)"
    about.cause = "add_force adds; velocities are only read"
    p, wind = Particle(velocity=Vector3(*v)), Wind(0.5, 0.0)
    p.add_force(Vector3(*f))
    wind.velocity = Vector3(*w)
    wind.update_force(p, 0.5)
    wanted = tuple(f[i] - 0.5 * (v[i] - w[i]) for i in range(3))
    got = xyz(p.force_accumulator)
    # A few roundings of numbers up to 30.
    expect_close(got, wanted, then="; p.force_accumulator", tolerance=1e-13)
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    expect_unchanged("wind.velocity", xyz(wind.velocity), w)


@pytest.mark.exercise("P4.2a")
def test_the_wind_is_drawn_level_and_from_both_sides(rng: Random) -> None:
    about.read = CHANGE
    seed = rng.randrange(1000)
    about.call = f"range = SniperRange({seed}); range.change_wind() 400 times; range.wind.velocity"
    about.cause = "self.random.uniform draws a number"
    (seen,) = winds([seed], 400)
    expect_exactly(len(seen), 401, call=f"how many: {about.call}", cause="one each time")
    about.cause = "the wind is level: its y is 0"
    highest = max(abs(y) for _, y, _ in seen)
    expect_close(highest, 0.0, then=": the largest |y|")
    for name, blown in (("x", [w[0] for w in seen]), ("z", [w[2] for w in seen])):
        about.cause = f"{name} is uniform from -STRONGEST_WIND to STRONGEST_WIND, 10 m/s, anew "
        about.cause += "each time"
        # Of 401 uniform numbers in 20 none lies in the last of either side once in 10^8 runs, and
        # their mean is beyond 2 more seldom: 7 times its deviation.
        for what, got, low, high in (
            ("smallest", min(blown), -10.0, -9.0),
            ("largest", max(blown), 9.0, 10.0),
            ("mean", sum(blown) / len(blown), -2.0, 2.0),
        ):
            middle, reach = (low + high) / 2.0, (high - low) / 2.0
            why = "beyond 10 m/s, as where what is drawn is added to the old wind: " + about.cause
            why = why if abs(got) > 10.0 else about.cause
            expect_close(got, middle, then=f": the {what} {name}", cause=why, tolerance=reach)
    about.cause = "x and z are drawn each for itself, so the wind is weak at times"
    # |w| < 5 for 0.196 of all: 79 of 401, and beyond these bounds once in 10^9 runs.
    weak = sum(math.hypot(x, z) < 5.0 for x, _, z in seen)
    expect_close(weak, 79, then=": how often it is below 5 m/s", tolerance=52)
    # x z > 0 for half of all: 200 of 401, and beyond these bounds once in 10^11 runs.
    about.cause = "x and z are drawn each for itself: the wind comes from every side"
    same = sum(x * z > 0.0 for x, _, z in seen)
    expect_close(same, 200, then=": how often x and z have the same sign", tolerance=70)
    about.cause = "x and z are drawn each for itself, so they are the same as good as never"
    same = sum(abs(abs(x) - abs(z)) < 1e-9 for x, _, z in seen)
    expect_exactly(same, 0, then=": how often |x| is |z|")


@pytest.mark.exercise("P4.2a")
def test_the_wind_stays_the_same_generator() -> None:
    about.read = CHANGE
    about.call = "range = SniperRange(1); wind = range.wind; wind.k1 = 0.5; range.change_wind()"
    about.cause = "only the velocity changes: the registry knows this very wind"
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
    about.cause = "a new wind was drawn"
    expect_exactly(after == before, False, then="; is it the same as before")


@pytest.mark.exercise("P4.2a")
def test_the_wind_follows_the_seed_of_its_range(rng: Random) -> None:
    about.read = CHANGE
    seed = rng.randrange(1000)
    about.call = f"ranges of the seeds {seed}, {seed} and {seed + 1}; change_wind() of each in turn"
    about.cause = "draw with self.random: the same seed gives the same winds, whatever else is "
    about.cause += "drawn"
    first, second, other = winds([seed, seed, seed + 1], 6)
    same = sum(a == b for a, b in zip(first, second, strict=True))
    expect_exactly(same, 7, then=": winds that are the same for one seed")
    about.cause = "another seed gives other winds"
    same = sum(a == b for a, b in zip(first, other, strict=True))
    expect_exactly(same, 0, then=": winds that are the same for two seeds")
    about.cause = "each change draws a new wind"
    kinds = len({tuple(w) for w in first})
    expect_exactly(kinds, 7, then=": how many winds the first has seen")
