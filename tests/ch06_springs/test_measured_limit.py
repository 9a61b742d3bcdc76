"""How stiff may a spring be: exercise 6.5, measured."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch06_springs.exercises import largest_stable_stiffness, swings_wider
from ch06_springs.step_probes import measured, never_safe, released, wider
from expect import about, blame, expect_between, expect_close, expect_error, expect_exactly

WIDER = "the docstring of swings_wider"
LARGEST = "the docstring of largest_stable_stiffness"


def draw_step(rng: Random) -> tuple[float, float]:
    """Draw the fraction of its force that a step uses, and a damping, for which mistakes show.

    With a share of 1 it would be the book's step, and a damping near 1 is none.
    """
    share = rng.choice((0.745, 1.42)) * rng.uniform(0.985, 1.015)
    return round(share, 3), round(rng.uniform(0.34, 0.37), 3)


def limit_of(share: float, explicit: bool, damping: float, h: float) -> float:
    """Return the stiffness up to which a step that uses a fraction of its force is stable."""
    keep = damping**h
    return ((1.0 / keep - 1.0) if explicit else 2.0 * (1.0 + keep) / keep) / (share * h * h)


@pytest.mark.exercise("6.5")
def test_how_the_particle_is_released() -> None:
    about("swings_wider(integrator, 7.0, 0.25, 0.125): what the integrator gets", read=WIDER)
    seen = released()
    name = "swings_wider(integrator, 7.0, 0.25, 0.125): is the integrator called"
    calls = (
        "Let the integrator that is passed in make the steps. It can be any function, so there is "
        "no formula for it: you have to try it out."
    )
    expect_exactly(len(seen) > 0, True, call=name, cause=calls)
    count, place, velocity, mass, damping, before, force, h, drift = seen[0]
    about.cause = (
        "Pass the integrator a list with exactly one particle. Don't add anything else, such as "
        "the anchor."
    )
    expect_exactly(count, 1, then=": the number of particles")
    about.cause = (
        "Give the particle a mass of 1 kg, because the limit is measured for that mass. A heavier "
        "particle would tolerate a stiffer spring."
    )
    expect_close(mass, 1.0, then=": its mass")
    about.cause = (
        "The particle should have the damping that is passed to swings_wider. Set it when you "
        "create the particle."
    )
    if damping == 1.0:
        about.cause = (
            "The particle has no damping. The damping belongs to the particle here, not to the "
            "spring, so pass it to Particle."
        )
    expect_close(damping, 0.25, then=": its damping")
    about.cause = (
        "You called the integrator with the wrong duration. Pass the duration on to it unchanged."
    )
    expect_close(h, 0.125, then=": the duration")
    about.cause = "Release the particle at a distance of START, which is 10 m, from the anchor."
    expect_close(math.hypot(*place), 10.0, then=": distance from the anchor")
    about.cause = (
        "This scene has no gravity. Leave the particle's own acceleration at 0, so that only the "
        "spring acts."
    )
    expect_close(drift, (0.0, 0.0, 0.0), then=": acceleration")
    about.cause = "Release the particle at rest, with a velocity of 0."
    expect_close(velocity, (0.0, 0.0, 0.0), then=": velocity")
    by_hand = (
        "You added a force to the particle before you called the integrator. Pass "
        "registry.update_forces as apply_forces, and let the integrator call it."
    )
    expect_close(
        before,
        (0.0, 0.0, 0.0),
        call="swings_wider(integrator, 7.0, 0.25, 0.125): the force in the accumulator when the "
        "integrator is called",
        cause=by_hand,
    )
    about.cause = (
        "Pass the update_forces of a registry as apply_forces. The registry should contain one "
        "AnchoredSpring of this stiffness, with a rest length of 0 and no damping."
    )
    wanted = tuple(-7.0 * part for part in place)
    expect_close(force, wanted, then=": the force that apply_forces adds", tolerance=1e-11)


@pytest.mark.exercise("6.5")
@pytest.mark.parametrize("explicit", [True, False], ids=["the_book_s_step", "velocity_first"])
def test_swings_on_either_side_of_the_limit(explicit: bool, rng: Random) -> None:
    about.read = WIDER
    h = 1.0 / 60.0
    share, damping = draw_step(rng)
    limit = limit_of(share, explicit, damping, h)
    for part, wanted, cause in (
        (
            0.5,
            False,
            "The stiffness is only half the limit, so the oscillation clearly dies out, and the "
            "answer is False. Is your comparison the wrong way around?",
        ),
        (
            0.98,
            False,
            "The stiffness is 2 % below the limit, so the oscillation dies out. Perhaps you "
            "compare swings too early in the run, or single positions instead of maxima.",
        ),
        (
            1.02,
            True,
            (
                "The stiffness is 2 % above the limit, so the oscillation grows, although only "
                "slowly with the book's step. Take enough steps, and compare late swings with "
                "early ones."
            ),
        ),
        (
            4.0,
            True,
            "The stiffness is far above the limit, so the oscillation grows without bound. Stop as "
            "soon as it is huge, before a number overflows.",
        ),
        (
            1e6,
            True,
            "At this stiffness the position soon becomes too large for a float. Stop and return "
            "True before that happens.",
        ),
    ):
        about.cause = cause
        k = part * limit
        about.call = f"swings_wider(integrator, {k!r}, {damping}, 1/60), a step that is "
        about.call += f"stable up to {limit:.6g} N/m"
        got = wider(share, explicit, k, damping, h)
        expect_exactly(got, wanted)


@pytest.mark.exercise("6.5")
def test_swings_that_stay_as_they_are_are_not_wider() -> None:
    about.read = WIDER
    about.cause = (
        "Without damping, semi-implicit Euler keeps the amplitude, but no step need fall exactly "
        "on the peak of a swing. Compare the largest distance over many late swings with the "
        "largest over many early ones."
    )
    for share in (0.1, 0.9, 0.98):
        k = share * 14_400.0
        about.call = f"swings_wider(integrator, {k}, 1.0, 1/60), a step stable up to 14400 N/m"
        got = wider(1.0, False, k, 1.0, 1.0 / 60.0)
        expect_exactly(got, False)
    about.call = "swings_wider(integrator, 14700, 1.0, 1/60), a step that is stable up to 14400 N/m"
    about.cause = (
        "The stiffness is 2 % above the limit of 14400 N/m, so the oscillation grows. Return True."
    )
    got = wider(1.0, False, 14_700.0, 1.0, 1.0 / 60.0)
    expect_exactly(got, True)
    about.call = "swings_wider(integrator, 1.0, 1.0, 1/60), the book's step"
    about.cause = (
        "Without damping the book's step is unstable for every spring, but this oscillation grows "
        "slowly, by only 12 % in FRAMES steps. Take that many steps before you decide."
    )
    got = wider(1.0, True, 1.0, 1.0, 1.0 / 60.0)
    expect_exactly(got, True)


@pytest.mark.exercise("6.5")
@pytest.mark.parametrize("explicit", [True, False], ids=["the_book_s_step", "velocity_first"])
def test_the_largest_stiffness_is_measured(explicit: bool, rng: Random) -> None:
    about.read = LARGEST
    share, damping = draw_step(rng)
    h = 1.0 / 20.0
    if explicit:
        damping = 0.9  # with which it is stable up to about 1 N/m
    about.call = f"largest_stable_stiffness(integrator, {damping}, {h!r}), with an integrator that "
    about.call += "the check provides"
    about.cause = (
        "Measure the limit with the integrator that is passed in, because no formula covers every "
        "integrator. Keep halving the interval between a stable and an unstable stiffness."
    )
    got = measured(share, explicit, damping, h)
    wanted = limit_of(share, explicit, damping, h)
    slips = {
        "The result is still SOFTEST / h^2, where the search began. If the stiffness in the middle "
        "is stable, make it the new lower bound.": 1e-7 / h**2,
        "The result is still STIFFEST / h^2, where the search began. If the stiffness in the "
        "middle is unstable, make it the new upper bound.": 16.0 / h**2,
        "You returned max_stable_stiffness, the formula for the book's step. This is a different "
        "integrator, so measure its limit with swings_wider.": limit_of(1.0, True, damping, h),
        "The result is STIFFEST / h. The bounds of the search go with the square of the duration, "
        "so divide by h^2.": 16.0 / h,
    }
    blame(got, slips)
    if isinstance(got, float) and 0.02 < abs(got / wanted - 1.0) < 0.3:
        about.cause = (
            f"The result is off by {abs(got / wanted - 1.0):.1%}. Keep halving the interval until "
            "its ends differ by less than 1 %."
        )
    # 1 % is promised; as much again for those who measure in another way.
    expect_close(got, wanted, tolerance=0.02 * wanted)


@pytest.mark.exercise("6.5")
def test_the_ends_of_what_is_measured() -> None:
    about.read = LARGEST
    h = 1.0 / 60.0
    about.call = "largest_stable_stiffness(integrator, 0.5, 1/60), an integrator that makes every "
    about.call += "swing wider"
    about.cause = (
        "With this integrator every oscillation grows, so no spring is stable. Return 0 or a "
        "stiffness very close to it."
    )
    got = never_safe(h)
    # A spring of 0.36 N/m, with k h^2 / m = 1e-4, is softer than any that matters in a game.
    expect_between(got, -0.36, 0.36)
    about.cause = (
        "The search ends at STIFFEST / h^2, so don't try anything stiffer. If even that is stable, "
        "return it."
    )
    about.call = "largest_stable_stiffness(integrator, 0.5, 0.8), a step stable up to 400 / h^2"
    most = 16.0 / 0.8**2
    got = measured(0.01, False, 0.5, 0.8)
    expect_close(got, most, tolerance=0.01 * most)
    about.call = "largest_stable_stiffness(integrator, 0.0, 1/60), semi-implicit Euler"
    about.cause = (
        "A damping of 0 is valid. It stops the particle at the end of each step, so even a spring "
        "of STIFFEST / h^2 is stable. Return that stiffness."
    )
    got = measured(1.0, False, 0.0, h)
    most = 16.0 * 3600.0
    expect_close(got, most, tolerance=0.01 * most)


@pytest.mark.exercise("6.5")
@pytest.mark.robust
def test_measuring_needs_numbers_that_mean_something() -> None:
    about.read = WIDER
    about.cause = (
        "This argument is invalid, so raise ValueError. Particle and AnchoredSpring check the "
        "damping and the stiffness for you, but checking the duration is up to you."
    )

    def step(particles: list, apply_forces: object, duration: float) -> None:
        """Do nothing: the particle never swings wider."""

    for bad in (
        (-1.0, 0.5, 0.25),
        (math.nan, 0.5, 0.25),
        (1.0, -0.5, 0.25),
        (1.0, math.nan, 0.25),
        (1.0, 0.5, 0.0),
        (1.0, 0.5, -0.25),
        (1.0, 0.5, math.nan),
    ):
        expect_error(
            lambda bad=bad: swings_wider(step, *bad),
            ValueError,
            call="swings_wider(integrator, {}, {}, {})".format(*bad),
            allowed=lambda: wider(1.0, True, 1e6, 0.5, 0.25),  # it soon stops
        )
    about.read = LARGEST
    for damping, duration in ((-0.5, 0.25), (math.nan, 0.25), (0.5, 0.0), (0.5, math.inf)):
        expect_error(
            lambda damping=damping, duration=duration: largest_stable_stiffness(
                step, damping, duration
            ),
            ValueError,
            call=f"largest_stable_stiffness(integrator, {damping}, {duration})",
            allowed=lambda: wider(1.0, True, 1e6, 0.5, 0.25),  # it soon stops
        )
    about.call = "swings_wider(integrator, 10.0, 0.5, 1/60), the book's step"
    about.cause = (
        "All arguments of this call are valid, so don't raise an error. A stiffness of 10 N/m is "
        "below the limit of 41.8 N/m, so the oscillation dies out."
    )
    got = wider(1.0, True, 10.0, 0.5, 1.0 / 60.0)
    expect_exactly(got, False)
