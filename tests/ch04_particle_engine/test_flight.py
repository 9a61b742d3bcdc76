"""Shots in flight, build task B4.3: how they move and when they are dropped."""

from __future__ import annotations

from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import probes
from ch04_particle_engine.ballistics import BallisticRange, Shot, is_spent
from expect import about, expect_close, expect_exactly

UPDATE = "the docstring of update"
STEP = f"{UPDATE}; chapter 3's integrate"


def by_the_law(
    start: float, speed: float, acceleration: float, damping: float, duration: float, frames: int
) -> tuple[float, float]:
    """Return position and velocity on one axis after some frames of explicit Euler with damping.

    In closed form, with D = d^h, the velocity is v = D^n v0 + a h D (1 - D^n) / (1 - D), and the
    position grows by h times the velocity before each step.
    """
    kept = damping**duration
    rest = acceleration * duration * kept / (1.0 - kept)  # the speed that a step does not change
    all_kept = kept**frames
    moved = (speed - rest) * (1.0 - all_kept) / (1.0 - kept) + rest * frames
    return start + duration * moved, (speed - rest) * all_kept + rest


@pytest.mark.exercise(
    "B4.3",
    asks="A shot is spent if it is below the ground (y < 0)",
    read="the docstring of is_spent; book 4.1.2, the listing",
)
def test_a_shot_is_spent_below_the_ground_after_5_seconds_and_past_200_m() -> None:
    for position, age, spent, cause in (
        ((0.0, 1.5, 100.0), 4.0, False,
         "This shot is above the ground, younger than 5 s and less than 200 m away. Return False."),
        ((0.0, 0.0, 100.0), 4.0, False,
         "You treat a shot at exactly y = 0 as spent. It is spent only below the ground (y < 0)."),
        ((0.0, -0.001, 100.0), 4.0, True,
         "You don't treat this shot as spent, although it is below the ground (y < 0). Each of the "
         "three conditions (y, age and z) is enough on its own."),
        ((0.0, 1.5, 100.0), 5.0, False,
         "You treat a shot of exactly 5 s as spent. It is spent only when it is older than 5 s."),
        ((0.0, 1.5, 100.0), 5.001, True,
         "You ignore the age of the shot. A shot that is older than 5 s is spent, wherever it is."),
        ((0.0, 1.5, 150.0), 4.0, False,
         "You end the range too early. It ends at 200 m, as in the listing, not at 100 m (E-34)."),
        ((0.0, 1.5, 200.0), 4.0, False,
         "You treat a shot at exactly z = 200 m as spent. It is still on the range, which ends at "
         "200 m, so only z > 200 is past the end."),
        ((0.0, 1.5, 200.001), 4.0, True,
         "You ignore the z of the shot. Past the end of the range (z > 200 m), it is spent."),
        ((300.0, 300.0, -300.0), 0.0, False,
         "You limit the range in a direction in which it has no limit. Check only whether y is "
         "below 0, z is above 200 m and the age is above 5 s."),
    ):  # fmt: skip
        with calls(cause):
            shot = Shot("pistol", Particle(Vector3(*position)))
            shot.age = age
            got = is_spent(shot)
        expect_exactly(got, spent)


@pytest.mark.exercise(
    "B4.3", asks="each shot moves, and its age increases by the duration", read=UPDATE
)
def test_an_update_moves_every_shot_by_one_step(rng: Random) -> None:
    h = round(rng.uniform(0.05, 0.2), 3)
    cause = "Call integrate exactly once for each particle, with the duration of the step."
    with calls(cause):
        r = BallisticRange()
        r.fire("pistol")
        r.fire("artillery")
        r.fire("pistol")
        r.update(h)
    keep = "You remove shots that are still in flight. Keep them if is_spent returns False."
    expect_exactly(len(r.shots), 3, then="; the number of shots in r.shots", cause=keep)
    for i, (vy, vz, a) in enumerate(((0.0, 35.0, -1.0), (30.0, 40.0, -20.0), (0.0, 35.0, -1.0))):
        twice = by_the_law(1.5, vy, a, 0.99, h, 2)[0], by_the_law(0.0, vz, 0.0, 0.99, h, 2)[0]
        slips = {
            "Your update moves every shot by two time steps. Call integrate only once per shot.":
                (0.0, *twice),
            "You move every shot by 1/60 s. Pass the duration to integrate instead.":
                (0.0, 1.5 + vy / 60.0, vz / 60.0),
            "You don't move the shots. Call integrate once for the particle of each shot.":
                (0.0, 1.5, 0.0),
        }  # fmt: skip
        got, wanted = r.shots[i].particle.position, (0.0, 1.5 + vy * h, vz * h)
        expect_close(got, wanted, slips, then=f"; r.shots[{i}].particle.position", unit="m")
    slips = {
        "You add 1 to the age in every update, but the age is a time in seconds. Add the duration "
        "instead.": 1.0,
        "You never change the age of a shot. Add the duration to it in every update.": 0.0,
        "You subtract the duration from the age. The age of a shot grows, so add the duration.": -h,
    }
    once = "The age is the time since the shot was fired. Add the duration once in every update."
    expect_close(r.shots[1].age, h, slips, then="; r.shots[1].age", unit="s", cause=once)


@pytest.mark.exercise("B4.3", asks="Move each particle with one call of integrate", read=STEP)
def test_many_updates_follow_the_law_of_the_step(rng: Random) -> None:
    frames, h = rng.randrange(20, 80), 1.0 / 60.0
    for name, speeds, a, damping in (
        ("pistol", (0.0, 0.0, 35.0), -1.0, 0.99),
        ("artillery", (0.0, 30.0, 40.0), -20.0, 0.99),
        ("fireball", (0.0, 0.0, 10.0), 0.6, 0.9),
    ):
        with calls(
            "Each update must move a shot with a single call of integrate, exactly as in chapter "
            "3. Don't change its position or velocity in any other way.",
            f'r = BallisticRange(); r.fire("{name}"); r.update(1/60), called {frames} times',
        ):
            shots = probes.flight([name], h, frames)[-1]
        expect_exactly(len(shots), 1, then="; len(r.shots)")
        axes = zip((0.0, 1.5, 0.0), speeds, (0.0, a, 0.0), strict=True)
        law = [by_the_law(p, v, acting, damping, h, frames) for p, v, acting in axes]
        # The rounding errors of 80 steps up to 60 m, and of the law, where 1 - D loses four digits.
        for i, field in enumerate(("position", "velocity")):
            wanted = tuple(axis[i] for axis in law)
            then = f"; r.shots[0].particle.{field}"
            expect_close(shots[0][1 + i], wanted, then=then, tolerance=1e-9)


@pytest.mark.exercise(
    "B4.3", asks="remove every shot that is spent now", read=f"{UPDATE}; book 4.1.2"
)
def test_shots_are_removed_in_the_update_that_ends_their_flight() -> None:
    h = 1.0 / 32.0
    landed = next(n for n in range(200) if by_the_law(1.5, 30.0, -20.0, 0.99, h, n)[0] < 0.0)
    fallen = next(n for n in range(200) if by_the_law(1.5, 0.0, -1.0, 0.99, h, n)[0] < 0.0)
    past = next(n for n in range(200) if by_the_law(0.0, 100.0, 0.0, 0.99, h, n)[0] > 200.0)
    after = "Call is_spent after integrate, so that the shot disappears in the update in which it"
    never = (
        "Your update never removes this shot. Collect the shots for which is_spent is False in a "
        "new list, and assign this list to self.shots after the loop."
    )
    for name, frame, wanted, cause in (
        ("artillery", h, landed, f"{after} falls below y = 0."),
        ("pistol", h, fallen,
         "Only a grenade bounces. Remove any other shot as soon as it falls below y = 0."),
        ("laser", h, past, f"{after} passes z = 200 m."),
        # 40 frames are exactly 5 s, and a shot of 5 s is not too old.
        ("fireball", 1.0 / 8.0, 41,
         "Add the duration before you call is_spent, so that the shot disappears in the update in "
         "which its age passes 5 s."),
    ):  # fmt: skip
        with calls(
            f"You remove the shot in the wrong update. {cause}",
            f'r = BallisticRange(); r.fire("{name}"); r.update({frame}), repeated until r.shots is '
            "empty; the number of updates",
        ):
            counts = [len(shots) for shots in probes.flight([name], frame, 200)]
        got, why = counts.index(0) + 1 if 0 in counts else 201, about.cause
        if got == 201:
            why = never
        elif got == wanted + 1:
            why = f"You remove the shot one update too late. {cause}"
        expect_exactly(got, wanted, unit="updates", cause=why)


@pytest.mark.exercise("B4.3", asks="Build a new list of the remaining shots", read=UPDATE)
def test_spent_shots_next_to_each_other_are_all_removed() -> None:
    names = ["laser", "laser", "fireball", "laser", "laser", "fireball"]
    build = "Build a new list of the shots that keep flying."
    with calls(
        f"Each update must remove all spent shots and keep the others. {build}",
        f"r = BallisticRange(); for name in {names}: r.fire(name); r.update(0.5), called 5 times; "
        "the types of the shots after update",
    ):
        seen = [[shot[0] for shot in shots] for shots in probes.flight(names, 0.5, 5)]
    if 2 < len(seen[-1]) < len(names):
        about(
            cause="You remove shots from the list while you loop over it, so each removal makes "
            f"the loop skip the next shot. {build}"
        )
    for i, wanted in enumerate([names] * 4 + [["fireball", "fireball"]]):
        expect_exactly(", ".join(seen[i]), ", ".join(wanted), then=f" {i + 1}")


@pytest.mark.exercise("B4.3", asks="Move each particle with one call of integrate", read=STEP)
def test_flight_time_and_range_come_close_to_the_closed_form_as_frames_get_short() -> None:
    """Only here the wanted numbers come from the exact motion, not from the law of the step."""
    # With damping .99 as drag, the exact values are 3.0347583 s and 119.557788 m.
    wanted, errors = (3.0347583, 119.557788), []
    scene = 'r = BallisticRange(); r.fire("artillery")'
    for h in (1.0 / 500.0, 1.0 / 1000.0):
        with calls(
            "The shot lands too far from the exact solution, which allows only a small error for "
            "such short steps. Check that update calls integrate exactly once per shot.",
            f"{scene}; r.update({h}) until the shot lands; (time of flight in s, z in m)",
        ):
            got = probes.landing("artillery", h)
        # The step ends a t h / 2 too high, 0.06 m for 1/500 s, which it falls in 0.002 s.
        expect_close(got, wanted, tolerance=2.0 * 50.0 * h)
        errors.append(got[0] - wanted[0])
    # The next order changes the ratio by h / t. The time is known to 5e-8 s of 1e-3 s.
    expect_close(
        errors[0] / errors[1],
        2.0,
        tolerance=0.01,
        call=f"{scene}; r.update(h) until the shot lands; the error of the time of flight for h = "
        "1/500 s, divided by the error for h = 1/1000 s",
        cause="With time steps that are half as long, the error must be half as large. Check that "
        "each update makes exactly one step.",
    )
