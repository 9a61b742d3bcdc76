"""A grenade on the range, mini-project 4.1."""

from __future__ import annotations

import math
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import ballistics, probes
from expect import about, expect_close, expect_exactly, expect_that, scoped

BURST_FRAME = 16  # of a quarter of a second each: 4 s

TWELVE = "A grenade bursts into 12 fragments (FRAGMENTS). Return a list of 12 shots."

ROUNDED = 1e-12  # some rounding errors of numbers up to 30


@scoped
def thrown(*, frames: int, others: tuple[str, ...] = ()) -> tuple[str, Any]:
    """Throw a grenade, fire others, and update the range in frames of a quarter of a second."""
    fired = "; ".join(f'r.fire("{name}")' for name in ("grenade", *others))
    about.call = f"r = BallisticRange(); {fired}; for i in range({frames}): r.update(0.25)"
    at = ballistics.BallisticRange()
    at.fire("grenade")
    for name in others:
        at.fire(name)
    for _ in range(frames):
        at.update(0.25)
    return about.call, at


@scoped
def why_it_disappears() -> str:
    """Return why a grenade leaves the range before its fuse has burned down."""
    about.call = (
        "p = Particle(position=Vector3(0, -0.5, 9), velocity=Vector3(0, -8, 5)); "
        'grenade_after(Shot("grenade", p))'
    )
    low = Particle(Vector3(0.0, -0.5, 9.0), Vector3(0.0, -8.0, 5.0))
    if len(ballistics.grenade_after(ballistics.Shot("grenade", low))) == 0:
        return (
            "Your grenade_after returns an empty list for a grenade below the ground, because "
            "is_spent is True there. Call bounce first, which moves it up to the ground."
        )
    return (
        "Your update removes the grenade when it falls below the ground, like any other shot. Call "
        "grenade_after for each grenade instead of is_spent."
    )


@scoped
def why_it_bursts() -> str:
    """Return why a grenade bursts in its first time step."""
    about.call = (
        'shot = Shot("grenade", Particle(Vector3(0, 1, 9))); shot.age = 5; grenade_after(shot)'
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 9.0)))
    shot.age = 5.0
    if len(ballistics.grenade_after(shot)) < 2:
        return (
            "You compare the age with FUSE the wrong way round, so your grenade bursts while its "
            "fuse still burns. It bursts if its age is FUSE (4 s) or more."
        )
    return (
        "Your grenade bursts in the first update, whatever its age is, so it never reaches the "
        "ground. Let it burst only if its age is FUSE (4 s) or more."
    )


@pytest.mark.exercise("4.1", asks="now below the ground, let it bounce first")
def test_a_grenade_bounces_until_its_fuse_has_burnt() -> None:
    frames = BURST_FRAME - 1
    about.call = 'r = BallisticRange(); r.fire("grenade"); '
    about.call += f"for i in range({frames}): r.update(0.25)"
    about.cause = (
        "In update, call grenade_after for each grenade, and add the list that it returns to the "
        "shots that keep flying, as in flying += grenade_after(shot)."
    )
    about.read = "the docstrings of update and grenade_after"
    heights = probes.heights_of("grenade", 0.25, frames)
    if len(heights) < frames:
        about.cause = why_it_disappears()
    expect_exactly(
        len(heights),
        frames,
        then="; the number of updates that the grenade survives",
    )
    about.cause = "The grenade never returns to y = 0. Let bounce move it there when it lands."
    lowest = min(heights)
    if lowest > ROUNDED and len(thrown(frames=1)[1].shots) > 1:
        about.cause = why_it_bursts()
    # It lands in frame 12 and is put back to exactly 0.
    lowest_of = "; the lowest height that the grenade reaches"
    expect_close(lowest, 0.0, then=lowest_of, unit="m", tolerance=ROUNDED)
    landed = heights.index(lowest)
    about.cause = (
        "The grenade does not rise again after its bounce. It must leave the ground at half the "
        "speed at which it fell."
    )
    risen = max(heights[landed:])
    highest = "; the greatest height after the bounce"
    expect_that(risen > 0.5, f"{risen:.6g} m", "more than 0.5 m", then=highest)


@pytest.mark.exercise("4.1", asks="If the age of the grenade has reached FUSE")
def test_a_grenade_bursts_when_its_age_has_reached_4_seconds() -> None:
    about(
        cause="The fuse of a grenade burns for 4 s (FUSE). Until then, keep the grenade in the "
        "list and don't let it burst."
    )
    about.read = "the docstring of grenade_after"
    about.call, at = thrown(frames=BURST_FRAME - 1)
    types = tuple(shot.type for shot in at.shots)
    expect_exactly(types, ("grenade",), then="; the types of the shots")
    about.cause = (
        "After 4 s, your grenade has not burst into 12 fragments. Return 12 shots of the type "
        "fragment as soon as the age of the grenade reaches FUSE."
    )
    about.call, at = thrown(frames=BURST_FRAME)
    types = tuple(shot.type for shot in at.shots)
    if types == ("grenade",) and thrown(frames=BURST_FRAME + 1)[1].shots[0].type == "fragment":
        about.cause = (
            "Your grenade bursts only when its age is above FUSE. It bursts as soon as its age has "
            "reached FUSE, so use >= in the comparison."
        )
    if types == ("grenade",) * 12:
        about.cause = (
            "The 12 shots of your burst still have the type grenade. Give each of them the type "
            "fragment."
        )
    if "grenade" in types and "fragment" in types:
        about.cause = "The grenade is still there. In update, replace the grenade by its fragments."
    if len(types) == 12 and "grenade" not in types and len({*types}) == 1:
        about.cause = f"Your 12 shots have the type {types[0]!r}. The type must be 'fragment'."
    kinds = " and ".join(sorted({str(type) for type in types}))
    shown = f"{len(types)} shot{'s' * (len(types) != 1)}{' of type ' * bool(types)}{kinds}"
    holds = types == ("fragment",) * 12
    expect_that(holds, shown, "12 shots of type fragment", then="; the shots on the range")
    about.cause = "The fragments are new shots, so their age is 0, not the age of the grenade."
    ages = tuple(shot.age for shot in at.shots)
    expect_close(ages, (0.0,) * 12, then="; the ages of the shots in s", tolerance=0.0)


@pytest.mark.exercise("4.1", asks="replace each grenade by the shots")
def test_other_shots_fly_on_and_spent_fragments_are_removed() -> None:
    about.read = "the docstrings of update and is_spent"
    about.cause = "Only the grenade bursts, and the fireball keeps flying."
    about.call, at = thrown(frames=BURST_FRAME, others=("fireball",))
    types = [shot.type for shot in at.shots]
    about.cause += " In the list, put the fragments where the grenade was, before the fireball."
    expect_exactly(
        types, ["fragment"] * 12 + ["fireball"], then="; the types of the shots, in order"
    )
    about.cause = (
        "Some fragments are still in the list. Only grenades bounce, so remove a fragment that "
        "falls below the ground, like any other shot."
    )
    about.call, at = thrown(frames=BURST_FRAME + 40)
    expect_exactly(len(at.shots), 0, then="; the number of shots")


@pytest.mark.exercise("4.1", asks="an empty list if is_spent is True for it")
def test_a_grenade_past_the_end_of_the_range_is_spent() -> None:
    about.call = 'shot = Shot("grenade", Particle(Vector3(0, 1, 201))); len(grenade_after(shot))'
    about.cause = (
        "You keep a grenade that is past the end of the range, at z = 201 m. Call is_spent for "
        "grenades too, and return an empty list if it returns True."
    )
    about.read = "the docstring of grenade_after"
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 201.0)))
    left = ballistics.grenade_after(shot)
    expect_exactly(len(left), 0)
    about.call = (
        'shot = Shot("grenade", Particle(Vector3(0, 1, 9))); shot.age = 2; grenade_after(shot)'
    )
    about.cause = (
        "This grenade is still in flight, and its fuse still burns. Return a list that contains "
        "only the grenade."
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 9.0)))
    shot.age = 2.0
    left = [(each.type, each.age) for each in ballistics.grenade_after(shot)]
    expect_exactly(left, [("grenade", 2.0)], then="; (type, age) of each shot in the result")


@pytest.mark.exercise("4.1", asks="let it bounce first. Then check its fuse")
def test_a_grenade_bounces_before_it_bursts_and_bursts_before_it_is_spent() -> None:
    about.read = "the docstring of grenade_after"
    about.call = (
        "p = Particle(position=Vector3(0, -0.5, 9), velocity=Vector3(0, -8, 5)); shot = "
        'Shot("grenade", p); shot.age = 4; grenade_after(shot)'
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0, -0.5, 9), Vector3(0.0, -8.0, 5.0)))
    shot.age = 4.0
    left = ballistics.grenade_after(shot)
    about.cause = (
        "Your grenade bursts before it bounces, so its fragments start below the ground. Call "
        "bounce before fragments."
    )
    heights = [each.particle.position.y for each in left]
    if len(heights) != 12:
        about.cause = TWELVE
    expect_close(
        heights, [0.0] * 12, then="; the heights of the 12 fragments", unit="m", tolerance=0.0
    )
    about.cause = (
        "The fragments must get the velocity that the grenade has after its bounce, 4 m/s upward "
        "and 4 m/s along Z. Call bounce before fragments."
    )
    mean = [math.fsum(each.particle.velocity.y for each in left) / 12.0]
    mean.append(math.fsum(each.particle.velocity.z for each in left) / 12.0)
    expect_close(
        mean,
        (4.0, 4.0),
        then="; the mean velocity of the fragments along Y and along Z, in m/s",
        tolerance=ROUNDED,
    )
    about.call = (
        'shot = Shot("grenade", Particle(Vector3(0, 1, 9))); shot.age = 4.5; '
        "len(grenade_after(shot))"
    )
    about.cause = (
        "Your grenade bursts at an age of exactly 4 s (FUSE), but not at 4.5 s. Compare with >=, "
        "because a step seldom ends at exactly this age."
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 9.0)))
    shot.age = 4.5
    expect_exactly(len(ballistics.grenade_after(shot)), 12)
    about.call = (
        'shot = Shot("grenade", Particle(Vector3(0, 1, 201))); shot.age = 6; '
        "len(grenade_after(shot))"
    )
    about.cause = (
        "You call is_spent before you check the fuse, so this grenade disappears without a burst. "
        "Check the fuse first."
    )
    shot = ballistics.Shot("grenade", Particle(Vector3(0.0, 1.0, 201.0)))
    shot.age = 6.0
    left = ballistics.grenade_after(shot)
    expect_exactly(len(left), 12)
