"""A grenade on the range, mini-project 4.1."""

from __future__ import annotations

import math
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import probes
from ch04_particle_engine.ballistics import BallisticRange, Shot, grenade_after
from expect import about, expect_close, expect_exactly, expect_that, scoped

AFTER = "the docstring of grenade_after"
BURST_FRAME = 16  # of a quarter of a second each: 4 s

ROUNDED = 1e-12  # some rounding errors of numbers up to 30


def thrown(cause: str, frames: int, *others: str) -> Any:
    """Throw a grenade, fire others, and update the range in frames of a quarter of a second."""
    fired = "; ".join(f'r.fire("{name}")' for name in ("grenade", *others))
    with calls(cause, f"r = BallisticRange(); {fired}; for i in range({frames}): r.update(0.25)"):
        at = BallisticRange()
        for name in ("grenade", *others):
            at.fire(name)
        for _ in range(frames):
            at.update(0.25)
    return at


def types_of(at: Any) -> list[Any]:
    return [shot.type for shot in at.shots]


@scoped
def why_it_disappears() -> str:
    """Return why a grenade leaves the range before its fuse has burned down."""
    with calls(about.cause):
        p = Particle(position=Vector3(0.0, -0.5, 9.0), velocity=Vector3(0.0, -8.0, 5.0))
        left = grenade_after(Shot("grenade", p))
    if len(left) == 0:
        return "You return an empty list for a grenade below the ground. Call bounce first."
    return "Your update removes the grenade when it falls below the ground. Call grenade_after."


@scoped
def why_it_bursts() -> str:
    """Return why a grenade bursts in its first time step."""
    with calls(about.cause):
        shot = Shot("grenade", Particle(Vector3(0.0, 1.0, 9.0)))
        shot.age = 5.0
        left = grenade_after(shot)
    if len(left) < 2:
        return "You compare the age the wrong way round. Burst the grenade at FUSE (4 s) or more."
    return "Your grenade bursts whatever its age is. Let it burst only if that is FUSE or more."


@pytest.mark.exercise(
    "4.1",
    asks="now below the ground, let it bounce first",
    read="the docstrings of update and grenade_after",
)
def test_a_grenade_bounces_until_its_fuse_has_burnt() -> None:
    frames = BURST_FRAME - 1
    with calls(
        "In update, call grenade_after for each grenade, and add the list that it returns to the "
        "shots that keep flying, as in flying += grenade_after(shot).",
        f'r = BallisticRange(); r.fire("grenade"); for i in range({frames}): r.update(0.25)',
    ):
        seen = probes.flight(["grenade"], 0.25, frames)
    heights = [shots[0][1][1] for shots in seen if shots]
    why = about.cause if len(heights) == frames else why_it_disappears()
    then = "; the number of updates that the grenade survives"
    expect_exactly(len(heights), frames, then=then, cause=why)
    lowest, then = min(heights), "; the lowest height that the grenade reaches"
    why = "The grenade never returns to y = 0. Let bounce move it there when it lands."
    if lowest > ROUNDED and len(seen[0]) > 1:
        why = why_it_bursts()
    # It lands in frame 12 and is put back to exactly 0.
    expect_close(lowest, 0.0, then=then, unit="m", tolerance=ROUNDED, cause=why)
    risen, then = max(heights[heights.index(lowest) :]), "; the greatest height after the bounce"
    rises = "The grenade does not rise again. It must leave the ground at half its speed."
    expect_that(risen > 0.5, f"{risen:.6g} m", "more than 0.5 m", then=then, cause=rises)


@pytest.mark.exercise("4.1", asks="If the age of the grenade has reached FUSE", read=AFTER)
def test_a_grenade_bursts_when_its_age_has_reached_4_seconds() -> None:
    at = thrown(
        "Until the fuse has burned for 4 s (FUSE), keep the grenade and don't let it burst.",
        BURST_FRAME - 1,
    )
    expect_exactly(types_of(at), ["grenade"], then="; the types of the shots")
    cause = "Return 12 shots of the type fragment as soon as the grenade's age reaches FUSE (4 s)."
    late = types_of(thrown(cause, BURST_FRAME + 1))
    at = thrown(cause, BURST_FRAME)
    types = types_of(at)
    if types == ["grenade"] and late[:1] == ["fragment"]:
        cause = "Your grenade bursts only when its age is above FUSE. Use >= to compare them."
    if types == ["grenade"] * 12:
        cause = "The 12 shots still have the type grenade. Give each of them the type fragment."
    if "grenade" in types and "fragment" in types:
        cause = "The grenade is still there. In update, replace the grenade by its fragments."
    if len(types) == 12 and "grenade" not in types and len({*types}) == 1:
        cause = f"Your 12 shots have the type {types[0]!r}. The type must be 'fragment'."
    kinds = " and ".join(sorted({str(type) for type in types}))
    shown = f"{len(types)} shot{'s' * (len(types) != 1)}{' of type ' * bool(types)}{kinds}"
    right, then = "12 shots of type fragment", "; the shots on the range"
    expect_that(types == ["fragment"] * 12, shown, right, then=then, cause=cause)
    expect_close(
        [shot.age for shot in at.shots],
        [0.0] * 12,
        then="; the ages of the shots in s",
        tolerance=0.0,
        cause="The fragments are new shots, so their age is 0, not the age of the grenade.",
    )


@pytest.mark.exercise(
    "4.1", asks="replace each grenade by the shots", read="the docstrings of update and is_spent"
)
def test_other_shots_fly_on_and_spent_fragments_are_removed() -> None:
    at = thrown(
        "Only the grenade bursts, and the fireball keeps flying. In the list, put the fragments "
        "where the grenade was, before the fireball.",
        BURST_FRAME,
        "fireball",
    )
    wanted = ["fragment"] * 12 + ["fireball"]
    expect_exactly(types_of(at), wanted, then="; the types of the shots, in order")
    at = thrown(
        "Some fragments are still in the list. Only grenades bounce, so remove a fragment that "
        "falls below the ground, like any other shot.",
        BURST_FRAME + 40,
    )
    expect_exactly(len(at.shots), 0, then="; the number of shots")


@pytest.mark.exercise("4.1", asks="an empty list if is_spent is True for it", read=AFTER)
def test_a_grenade_past_the_end_of_the_range_is_spent() -> None:
    with calls(
        "You keep a grenade that is past the end of the range, at z = 201 m. Call is_spent for "
        "grenades too, and return an empty list if it returns True."
    ):
        shot = Shot("grenade", Particle(Vector3(0.0, 1.0, 201.0)))
        left = len(grenade_after(shot))
    expect_exactly(left, 0)
    with calls("This grenade is in flight and its fuse burns. Return a list of only the grenade."):
        shot = Shot("grenade", Particle(Vector3(0.0, 1.0, 9.0)))
        shot.age = 2.0
        left = grenade_after(shot)
    kept, then = (
        [(each.type, each.age) for each in left],
        "; (type, age) of each shot in the result",
    )
    expect_exactly(kept, [("grenade", 2.0)], then=then)


@pytest.mark.exercise("4.1", asks="let it bounce first. Then check its fuse", read=AFTER)
def test_a_grenade_bounces_before_it_bursts_and_bursts_before_it_is_spent() -> None:
    with calls("A grenade bursts into 12 fragments (FRAGMENTS). Return a list of 12 shots."):
        p = Particle(position=Vector3(0.0, -0.5, 9.0), velocity=Vector3(0.0, -8.0, 5.0))
        shot = Shot("grenade", p)
        shot.age = 4.0
        left = grenade_after(shot)
    pieces = [each.particle for each in left]
    why = about.cause
    if len(pieces) == 12:
        why = "Your grenade bursts before it bounces. Call bounce before fragments."
    heights, then = [piece.position.y for piece in pieces], "; the heights of the 12 fragments"
    expect_close(heights, [0.0] * 12, then=then, unit="m", tolerance=0.0, cause=why)
    velocities = [piece.velocity for piece in pieces]
    expect_close(
        (math.fsum(v.y for v in velocities) / 12.0, math.fsum(v.z for v in velocities) / 12.0),
        (4.0, 4.0),
        then="; the mean velocity of the fragments along Y and along Z, in m/s",
        tolerance=ROUNDED,
        cause="The fragments must get the velocity that the grenade has after its bounce, 4 m/s "
        "upward and 4 m/s along Z. Call bounce before fragments.",
    )
    for z, age, cause in (
        (9.0, 4.5,
         "Your grenade bursts at an age of exactly 4 s (FUSE), but not at 4.5 s. Compare with >=, "
         "because a step seldom ends at exactly this age."),
        (201.0, 6.0,
         "You call is_spent first, so this grenade never bursts. Check the fuse first."),
    ):  # fmt: skip
        with calls(cause):
            shot = Shot("grenade", Particle(Vector3(0.0, 1.0, z)))
            shot.age = age
            count = len(grenade_after(shot))
        expect_exactly(count, 12)
