"""The wind of the sniper range, project 4.2a."""

from __future__ import annotations

import itertools
import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch05_forces.probes import winds
from ch05_forces.sniper import SniperRange, Wind
from draw import Triple, vector
from expect import expect_between, expect_close, expect_exactly, expect_that, xyz
from unmoved import expect_kept

ZERO = Triple((0.0, 0.0, 0.0))
READ = "the docstring of Wind.update_force"
CHANGE = "the docstring of change_wind"


def blown(cause: str, v: Triple, w: Triple, k1: float, k2: float) -> Any:
    """Return the force of a wind of this velocity on a particle."""
    with calls(cause):
        p, wind = Particle(velocity=Vector3(*v), mass=4.0), Wind(k1=k1, k2=k2)
        wind.velocity = Vector3(*w)
        wind.update_force(p, 0.5)
        got = p.force_accumulator
    return xyz(got)


@pytest.mark.exercise("P4.2a", asks="the velocity of the particle relative to the air", read=READ)
def test_the_wind_is_drag_relative_to_the_air(rng: Random) -> None:
    v, w = vector(rng), vector(rng)
    one, two = round(rng.uniform(0.2, 0.9), 3), round(rng.uniform(0.2, 0.9), 3)

    def drag(a: Triple, k1: float, k2: float) -> Triple:
        return -a * (k1 + k2 * abs(a))

    for k1, k2 in ((one, 0.0), (0.0, two), (one, two)):
        wanted = drag(v - w, k1, k2)
        cause = "The force must be the drag at v - w, the velocity relative to the wind."
        got = blown(cause, v, w, k1, k2)
        slips = {
            "You ignore the wind.": drag(v, k1, k2),
            "You use the wind alone, as if the particle were at rest.": -drag(w, k1, k2),
            "You add the velocity of the wind to that of the particle.": drag(v + w, k1, k2),
            "Your force has the wrong sign, because it was computed with w - v, or because of an "
            "extra minus sign.": -wanted,
            "You divide the drag by the mass. Leave the mass out.": wanted / 4.0,
            "You use the constants K1 and K2. Use self.k1 and self.k2 instead.":
                drag(v - w, 0.02, 0.0003),
            "update_force added no force to the particle. Pass the drag to particle.add_force."
            if k1
            else "Your force is zero if k1 is 0. Include the quadratic drag (k2), too.": ZERO,
            "You swapped k1 and k2. In the drag, k2 belongs to the square of the speed.":
                drag(v - w, k2, k1),
            "You add two drags, one for the particle's velocity and one for the wind's.":
                drag(v, k1, k2) - drag(w, k1, k2),
        }  # fmt: skip
        # A few roundings of numbers up to 700.
        expect_close(got, wanted, slips, tolerance=1e-11, unit="N")


@pytest.mark.exercise("P4.2a", asks="therefore feels no force", read=READ)
def test_a_particle_that_moves_with_the_air_feels_no_force(rng: Random) -> None:
    drawn = vector(rng)
    for v, w, force, cause in (
        (drawn, drawn, ZERO,
         "This particle moves along with the wind, so no force must act on it."),
        (ZERO, (2.0, 0.0, 0.0), (2.0, 0.0, 0.0),
         "Wind pushes a particle at rest along. Compute the drag at v - w, not at w - v."),
        ((0.0, 0.0, 2.0), ZERO, (0.0, 0.0, -2.0),
         "In still air, the force must be ordinary drag against the velocity."),
    ):  # fmt: skip
        expect_close(blown(cause, v, w, 0.5, 0.25), force, unit="N")


@pytest.mark.exercise("P4.2a", asks="the moving air to the particle's other forces", read=READ)
def test_the_wind_keeps_earlier_forces_and_velocities(rng: Random) -> None:
    f, v, w = vector(rng), vector(rng), vector(rng)
    with calls("Add the drag to the earlier forces with add_force, and don't clear any forces."):
        p, wind = Particle(velocity=Vector3(*v)), Wind(k1=0.5, k2=0.0)
        p.add_force(Vector3(*f))
        wind.velocity = Vector3(*w)
        wind.update_force(p, 0.5)
        got = p.force_accumulator
    # A few roundings of numbers up to 30.
    expect_close(got, f - 0.5 * (v - w), unit="N", tolerance=1e-13)
    expect_kept("p.velocity", xyz(p.velocity), v)
    expect_kept("wind.velocity", xyz(wind.velocity), w)


@pytest.mark.exercise("P4.2a", asks="Draw a new horizontal wind at random", read=CHANGE)
def test_the_wind_is_horizontal_and_from_all_directions(rng: Random) -> None:
    seed = rng.randrange(1000)
    with calls(
        "Draw exactly one wind in each call of change_wind. Call self.random.uniform once for x "
        "and once for z, and store the vector in self.wind.velocity.",
        f"game = SniperRange({seed}), which draws a first wind; 400 times: game.change_wind()",
    ):
        (seen,) = winds([seed], 400)
    expect_exactly(len(seen), 401, then="; number of winds")
    drawn = seen[1:]
    highest = max(abs(y) for _, y, _ in seen)
    cause = "Your wind has a vertical component, but the wind must be horizontal. Set y to 0."
    then = "; the largest absolute value of game.wind.velocity.y"
    expect_close(highest, 0.0, then=then, unit="m/s", cause=cause)
    for name, part in (("x", [x for x, _, _ in seen]), ("z", [z for _, _, z in seen])):
        draw = f"Draw {name} uniformly between -STRONGEST_WIND and STRONGEST_WIND."
        cause = f"The {name} component of your wind has the wrong range. {draw}"
        if min(part) >= 0.0 or max(part) <= 0.0:
            cause = f"The {name} component of your wind never changes its sign. {draw}"
        if not any(map(any, seen)):
            cause = "The wind is always zero. Store the vector that you draw in self.wind.velocity."
        elif len(set(map(tuple, drawn))) == 1:
            cause = "Every wind is the same. Draw from self.random, without seeding it again."
        elif not any(part[1:]):
            cause = f"The {name} component of your wind is always 0. {draw}"
        elif max(map(abs, part)) > 10.0 and all(
            abs(one - other) <= 10.0 for one, other in itertools.pairwise(part)
        ):
            cause = "You add each wind to the previous one. Replace the velocity instead."
        # Of 401 uniform numbers in 20 none lies in the last of either side once in 10^8 runs, and
        # their mean is beyond 2 more seldom: 7 times its deviation.
        for what, got, low, high in (
            ("smallest", min(part), -10.0, -9.0),
            ("largest", max(part), 9.0, 10.0),
            ("mean", sum(part) / len(part), -2.0, 2.0),
        ):
            then = f"; the {what} value of game.wind.velocity.{name}"
            expect_between(got, low, high, then=then, unit="m/s", cause=cause)
    speeds = [math.hypot(x, z) for x, _, z in drawn]
    cause = "Weak winds are too rare or too common. Draw x and z independently of each other."
    if max(speeds) - min(speeds) < 1e-9:
        cause = "All your winds have the same speed. Draw x and z independently of each other."
    elif all(abs(abs(x) - abs(z)) < 1e-9 for x, _, z in drawn):
        cause = "In all winds, x and z have the same size. Draw two numbers instead of one."
    # |w| < 5 for 0.196 of all: 79 of 401, and beyond these bounds once in 10^9 runs.
    weak = sum(math.hypot(x, z) < 5.0 for x, _, z in seen)
    then = "; number of winds slower than 5 m/s, out of 401"
    expect_between(weak, 27, 131, then=then, cause=cause)
    # x z > 0 for half of all: 200 of 401, and beyond these bounds once in 10^11 runs.
    cause = "Winds from some directions are too common. Draw x and z independently of each other."
    same = sum(x * z > 0.0 for x, _, z in seen)
    then = "; number of winds in which x and z have the same sign, out of 401"
    expect_between(same, 130, 270, then=then, cause=cause)
    cause = "Sometimes |x| equals |z|. Draw a separate random number for each."
    if all(x == round(x) and z == round(z) for x, _, z in drawn):
        cause = "You draw whole numbers. Draw floats with self.random.uniform instead."
    same = sum(abs(abs(x) - abs(z)) < 1e-9 for x, _, z in seen)
    expect_exactly(same, 0, then="; number of winds with |x| = |z|, out of 401", cause=cause)


@pytest.mark.exercise("P4.2a", asks="and keep this generator", read=CHANGE)
def test_change_wind_keeps_the_wind_object() -> None:
    keep = "Keep the Wind object, which the registry holds, and change its velocity."
    with calls(keep):
        game = SniperRange(1)
        wind = game.wind
        wind.k1 = 0.5
    before = xyz(wind.velocity)
    with calls(keep, more=True):
        game.change_wind()
    after = xyz(wind.velocity)
    expect_close(game.wind.k1, 0.5, then="; game.wind.k1")
    gap = Triple(xyz(game.wind.velocity)) - after
    expect_close(gap, ZERO, then="; game.wind.velocity - wind.velocity", unit="m/s")
    cause = "change_wind did not change the wind. Store a new velocity in self.wind.velocity."
    kept = "the velocity of the wind stays the same"
    expect_that(after != before, kept, "a new velocity", cause=cause)


@pytest.mark.exercise("P4.2a", asks="the same seed must always give the same winds", read=CHANGE)
def test_the_same_seed_gives_the_same_winds(rng: Random) -> None:
    seed = rng.randrange(1000)
    own = "Draw the winds with self.random, which was created from the seed."
    with calls(
        own,
        f"a = SniperRange({seed}); b = SniperRange({seed}); c = SniperRange({seed + 1}); "
        "6 times: a.change_wind(), b.change_wind() and c.change_wind()",
    ):
        first, second, other = winds([seed, seed, seed + 1], 6)
    for name, winds_of, wanted, cause in (
        ("b", second, 7, f"Two ranges with the same seed have different winds. {own}"),
        ("c", other, 0, f"Ranges with different seeds have the same winds. {own}"),
    ):
        same = sum(a == b for a, b in zip(first, winds_of, strict=True))
        then = f"; number of winds that are equal in a and {name}, counting the initial wind"
        expect_exactly(same, wanted, then=then, unit="of 7 winds", cause=cause)
    kinds, then = len({tuple(w) for w in first}), "; number of different winds in a"
    cause = "Some calls of change_wind repeat an earlier wind. Draw a new wind in every call."
    expect_exactly(kinds, 7, then=then, unit="winds", cause=cause)
