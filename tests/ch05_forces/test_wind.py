"""The wind of the sniper range, project 4.2a."""

from __future__ import annotations

import itertools
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
    expect_that,
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
    about.call += f"wind.velocity = Vector3{w}; wind.update_force(p, 0.5); "
    about.call += "p.force_accumulator"
    p, wind = Particle(velocity=Vector3(*v), mass=4.0), Wind(k1, k2)
    wind.velocity = Vector3(*w)
    wind.update_force(p, 0.5)
    del about.cause, about.read  # what is said where update_force raises
    return about.call, xyz(p.force_accumulator)


@pytest.mark.exercise("P4.2a", asks="the velocity of the particle relative to the air")
def test_the_wind_is_drag_relative_to_the_air(rng: Random) -> None:
    about.read = READ
    v, w = components(rng), components(rng)
    k1, k2 = round(rng.uniform(0.2, 0.9), 3), round(rng.uniform(0.2, 0.9), 3)
    about.cause = "The force is wrong. It must be the drag at the velocity v - w, where v is the "
    about.cause += "velocity of the particle and w that of the wind."
    u = [v[i] - w[i] for i in range(3)]

    def drag(a: Sequence[float], one: float, two: float) -> list[float]:
        return [-part * (one + two * math.hypot(*a)) for part in a]

    for one, two in ((k1, 0.0), (0.0, k2), (k1, k2)):
        about.call, got = blow(v, w, one, two)
        wanted = drag(u, one, two)
        still, blown = drag(v, one, two), drag(w, one, two)
        slips = {
            "You ignore the wind. Subtract the velocity of the wind from the velocity of the "
            "particle before you compute the drag.": still,
            "You use the wind alone, as if the particle were at rest. Subtract the velocity of "
            "the wind from the velocity of the particle.": [-part for part in blown],
            "You add the velocity w of the wind to the velocity v of the particle. Subtract it, "
            "because drag depends on v - w.": drag([v[i] + w[i] for i in range(3)], one, two),
            "Your force has the wrong sign, because it was computed with w - v, or because of an "
            "extra minus sign. Use v - w, where v is the velocity of the particle and w that of "
            "the wind, and add the drag unchanged.": [-part for part in wanted],
            "You divide the drag by the mass. Add the force itself, because the step divides it by "
            "the mass later.": [part / 4.0 for part in wanted],
            "You use the constants K1 and K2. Use the coefficients self.k1 and self.k2 of this "
            "wind.": drag(u, 0.02, 0.0003),
            "update_force added no force to the particle. Pass the drag to particle.add_force."
            if one
            else "Your force is zero if k1 is 0. Include the quadratic drag (k2), too.": ZERO,
            "You swapped k1 and k2. In the drag, k1 is multiplied by the speed, and k2 by the "
            "square of the speed.": drag(u, two, one),
            "You add two drags, one for the particle's velocity v and one for the wind's "
            "velocity w. Compute v - w first, and then a single drag at that velocity.": [
                still[i] - blown[i] for i in range(3)
            ],
        }
        why = named(got, about.cause, slips)
        # A few roundings of numbers up to 700.
        expect_close(got, wanted, cause=why, tolerance=1e-11, unit="N")


@pytest.mark.exercise("P4.2a", asks="therefore feels no force")
def test_a_particle_that_moves_with_the_air_feels_no_force(rng: Random) -> None:
    about.read = READ
    v = components(rng)
    about.cause = "You add a force to a particle that moves along with the wind. Its velocity "
    about.cause += "relative to the air is zero, so no force must act on it."
    about.call, got = blow(v, v, 0.5, 0.25)
    expect_close(got, ZERO, unit="N")
    about.cause = "The wind must push a particle at rest in the direction of the wind. Compute the "
    about.cause += "drag at v - w, not at w - v."
    about.call, got = blow(ZERO, (2.0, 0.0, 0.0), 0.5, 0.25)
    expect_close(got, (2.0, 0.0, 0.0), unit="N")
    about.cause = "The force is wrong in still air. It must be ordinary drag, against the velocity "
    about.cause += "of the particle."
    about.call, got = blow((0.0, 0.0, 2.0), ZERO, 0.5, 0.25)
    expect_close(got, (0.0, 0.0, -2.0), unit="N")


@pytest.mark.exercise("P4.2a", asks="the moving air to the particle's other forces")
def test_the_wind_keeps_earlier_forces_and_velocities(rng: Random) -> None:
    about.read = READ
    f, v, w = components(rng), components(rng), components(rng)
    about.call = f"p = Particle(velocity=Vector3{v}); p.add_force(Vector3{f}); wind = Wind(k1=0.5, "
    about.call += f"k2=0.0); wind.velocity = Vector3{w}; wind.update_force(p, 0.5)"
    about.cause = "The sum of the forces is wrong. Add the drag with add_force, and don't clear "
    about.cause += "any forces."
    p, wind = Particle(velocity=Vector3(*v)), Wind(0.5, 0.0)
    p.add_force(Vector3(*f))
    wind.velocity = Vector3(*w)
    wind.update_force(p, 0.5)
    wanted = tuple(f[i] - 0.5 * (v[i] - w[i]) for i in range(3))
    got = xyz(p.force_accumulator)
    # A few roundings of numbers up to 30.
    expect_close(got, wanted, then="; p.force_accumulator", unit="N", tolerance=1e-13)
    about.cause = "You change p.velocity, because -= works in place. Use -, which creates a new "
    about.cause += "vector."
    expect_unchanged("p.velocity", xyz(p.velocity), v)
    about.cause = about.cause.replace("p.velocity", "wind.velocity")
    expect_unchanged("wind.velocity", xyz(wind.velocity), w)


@pytest.mark.exercise("P4.2a", asks="Draw a new horizontal wind at random")
def test_the_wind_is_horizontal_and_from_all_directions(rng: Random) -> None:
    about.read = CHANGE
    seed = rng.randrange(1000)
    about.call = (
        f"range = SniperRange({seed}), which draws a first wind; 400 times: range.change_wind()"
    )
    about.cause = "Each call of change_wind must draw a new wind. Call self.random.uniform once "
    about.cause += "for x and once for z, and store the vector in self.wind.velocity."
    (seen,) = winds([seed], 400)
    drawn = seen[1:]
    expect_exactly(
        len(seen),
        401,
        call=f"{about.call}; number of winds",
        cause="Draw exactly one wind in each call of change_wind.",
    )
    about.cause = "Your wind has a vertical component, but the wind must be horizontal. Set y to 0."
    highest = max(abs(y) for _, y, _ in seen)
    then = "; the largest absolute value of range.wind.velocity.y"
    expect_close(highest, 0.0, then=then, unit="m/s")
    for name, blown in (("x", [w[0] for w in seen]), ("z", [w[2] for w in seen])):
        draw = f"Draw {name} uniformly between -STRONGEST_WIND and STRONGEST_WIND."
        about.cause = f"The {name} component of your wind has the wrong range. {draw}"
        if min(blown) >= 0.0 or max(blown) <= 0.0:
            about.cause = f"The {name} component of your wind never changes its sign. {draw}"
        if not any(map(any, seen)):
            about.cause = "The wind is always zero. Store the vector that you draw in "
            about.cause += "self.wind.velocity."
        elif len(set(map(tuple, drawn))) == 1:
            about.cause = "Every call to change_wind gives the same wind. Draw new numbers from "
            about.cause += "self.random in each call, and don't create or seed a generator there."
        elif not any(blown[1:]):
            about.cause = f"The {name} component of your wind is always 0. {draw}"
        elif max(map(abs, blown)) > 10.0 and all(
            abs(one - other) <= 10.0 for one, other in itertools.pairwise(blown)
        ):
            about.cause = "You add each new wind to the previous one, so the wind becomes too "
            about.cause += "strong. Replace the old velocity with the new one."
        # Of 401 uniform numbers in 20 none lies in the last of either side once in 10^8 runs, and
        # their mean is beyond 2 more seldom: 7 times its deviation.
        for what, got, low, high in (
            ("smallest", min(blown), -10.0, -9.0),
            ("largest", max(blown), 9.0, 10.0),
            ("mean", sum(blown) / len(blown), -2.0, 2.0),
        ):
            then = f"; the {what} value of range.wind.velocity.{name}"
            expect_between(got, low, high, then=then, unit="m/s")
    about.cause = "Weak winds are too rare or too common. Draw x and z independently of each other."
    speeds = [math.hypot(x, z) for x, _, z in drawn]
    if max(speeds) - min(speeds) < 1e-9:
        about.cause = "All your winds have the same speed, because x and z depend on each other. "
        about.cause += "Draw x and z separately, each with self.random.uniform."
    elif all(abs(abs(x) - abs(z)) < 1e-9 for x, _, z in drawn):
        about.cause = "You use the same random number for x and z. Draw a separate random number "
        about.cause += "for each component."
    # |w| < 5 for 0.196 of all: 79 of 401, and beyond these bounds once in 10^9 runs.
    weak = sum(math.hypot(x, z) < 5.0 for x, _, z in seen)
    expect_between(weak, 27, 131, then="; number of winds slower than 5 m/s, out of 401")
    # x z > 0 for half of all: 200 of 401, and beyond these bounds once in 10^11 runs.
    about.cause = "Winds from some directions are too common. Draw x and z independently of each "
    about.cause += "other."
    same = sum(x * z > 0.0 for x, _, z in seen)
    then = "; number of winds in which x and z have the same sign, out of 401"
    expect_between(same, 130, 270, then=then)
    about.cause = "In some winds, x and z have the same absolute value. Draw a separate random "
    about.cause += "number for each of them."
    if all(x == round(x) and z == round(z) for x, _, z in drawn):
        about.cause = "You draw whole numbers, so x and z sometimes have the same size. Draw "
        about.cause += "floats with self.random.uniform instead."
    same = sum(abs(abs(x) - abs(z)) < 1e-9 for x, _, z in seen)
    expect_exactly(same, 0, then="; number of winds with |x| = |z|, out of 401")


@pytest.mark.exercise("P4.2a", asks="and keep this generator")
def test_change_wind_keeps_the_wind_object() -> None:
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
    expect_close(gap, ZERO, then="; range.wind.velocity - wind.velocity", unit="m/s")
    about.cause = "change_wind did not change the wind. Draw a new velocity, and store it in "
    about.cause += "self.wind.velocity."
    expect_that(after != before, "the velocity of the wind stays the same", "a new velocity")


@pytest.mark.exercise("P4.2a", asks="the same seed must always give the same winds")
def test_the_same_seed_gives_the_same_winds(rng: Random) -> None:
    about.read = CHANGE
    seed = rng.randrange(1000)
    about.call = f"a = SniperRange({seed}); b = SniperRange({seed}); c = SniperRange({seed + 1}); "
    about.call += "6 times: a.change_wind(), b.change_wind() and c.change_wind()"
    about.cause = "Two ranges with the same seed have different winds. Draw the winds with "
    about.cause += "self.random, which was created from the seed."
    first, second, other = winds([seed, seed, seed + 1], 6)
    same = sum(a == b for a, b in zip(first, second, strict=True))
    then = "; number of winds that are equal in a and b, counting the initial wind"
    expect_exactly(same, 7, then=then, unit="of 7 winds")
    about.cause = "Ranges with different seeds have the same winds. Draw the winds with "
    about.cause += "self.random, which was created from the seed."
    same = sum(a == b for a, b in zip(first, other, strict=True))
    then = "; number of winds that are equal in a and c, counting the initial wind"
    expect_exactly(same, 0, then=then, unit="of 7 winds")
    about.cause = "Some calls of change_wind repeat an earlier wind. Draw a new wind in every "
    about.cause += "call."
    kinds = len({tuple(w) for w in first})
    expect_exactly(
        kinds, 7, then="; number of different winds in a, including the initial wind", unit="winds"
    )
