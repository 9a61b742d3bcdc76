"""The force registry, build task B5.3: generators that keep a record stand in probes.py."""

from __future__ import annotations

from itertools import takewhile
from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from ch05_forces.probes import Push, asked, asked_while_it_changes, paired
from draw import vector
from expect import about, expect_close, expect_exactly, expect_that, xyz

REGISTRY = "the docstring of ForceRegistry"
REMOVE = "the docstring of remove"
UPDATE = "the docstring of update_forces"
# How an act of probes.asked is shown. The words for an addition do not call add, because the
# student is to open the function under test.
ACTS = {
    "add": "the pair (p{}, g{}) is added; ",
    "remove": "registry.remove(p{}, g{}); ",
    "free": "p{}.inverse_mass = 1.0; ",
    "clear": "registry.clear(); ",
    "update": "registry.update_forces({}); ",
}
Calls = list[tuple[int, int, float]]


def told(asks: Calls) -> str:
    """Say which generator was called for which particle, and with which duration."""
    shown = [
        f"g{g} on p{p} for {f'{h:.6g} s' if isinstance(h, (int, float)) else repr(h)}"
        for p, g, h in asks
    ]
    return ", ".join(shown) or "no calls"


def pairs(*numbers: tuple[int, int]) -> list[tuple[Any, ...]]:
    return [("add", *pair) for pair in numbers]


def expect_asked(
    acts: list[tuple[Any, ...]],
    wanted: Calls,
    cause: str,
    slips: dict[str, Calls] | None = None,
    *,
    immovable: tuple[int, ...] = (),
    alike: bool = True,
) -> None:
    """Expect these calls of update_force: which particle, which generator, which duration.

    ``slips`` are the calls that likely mistakes make. If ``alike`` is True, all generators are
    equal under ==.
    """
    first = [*takewhile(lambda act: act[0] == "add", acts)]
    held = ", ".join(f"(p{p}, g{g})" for _, p, g in first)
    shown = f"a registry with these (particle, generator) pairs: {held}; "
    shown = shown if first else "an empty registry; "
    shown += "".join(f"p{i} is immovable; " for i in immovable)
    shown += "".join(ACTS[name].format(*numbers) for name, *numbers in acts[len(first) :])
    with calls(cause, f"{shown}the calls to update_force"):
        try:
            got = [*map(tuple, asked(immovable, acts, alike))]
        except AttributeError as error:
            if "Generator' object has no attribute" in str(error):
                about(
                    cause="You use a generator where a particle is needed. Each entry of self._pairs "
                    "is a tuple (particle, generator), in this order."
                )
            raise
        except TypeError as error:
            if "must be a Vector3, got None" not in str(error):
                raise
            nothing = "update_force returns None. Call it without passing its result to add_force."
            expect_that(False, f"TypeError: {error}", told(wanted), cause=nothing)
    for slip, asks in (slips or {}).items():
        if got == asks:
            cause = slip
    expect_that(got == wanted, told(got), told(wanted), cause=cause)


@pytest.mark.exercise("B5.3", asks="pairs (particle, generator) in _pairs", read=REGISTRY)
def test_a_pair_is_a_particle_and_then_its_generator(rng: Random) -> None:
    i, j = rng.randrange(3), rng.randrange(3)
    with calls(
        "Append one tuple (particle, generator) to self._pairs in each call of add.",
        f"registry = ForceRegistry(); registry.add(p{i}, g{j}); registry.pairs()",
    ):
        got = [*map(tuple, paired(i, j))]
    if got == [(f"g{j}", f"p{i}")]:
        about(cause="You store the generator before the particle. Store the particle first.")
    shown = ", ".join(f"({', '.join(pair)})" for pair in got) or "no pairs"
    expect_that(got == [(f"p{i}", f"g{j}")], shown, f"(p{i}, g{j})")


@pytest.mark.exercise("B5.3", asks="Go through the pairs in the order", read="book 5.2.2")
def test_every_pair_is_called_once_per_step(rng: Random) -> None:
    h, k = round(rng.uniform(0.1, 0.5), 3), round(rng.uniform(0.6, 0.9), 3)
    wanted = [(0, 1, h), (2, 0, h), (0, 2, h), (0, 1, k), (2, 0, k), (0, 2, k)]
    slips = {
        "You call the generators only in the first update. A pair stays until it is removed.": wanted[:3],
        "You call the generator of the newest pair first. Keep the order of the pairs.":
            [*wanted[2::-1], *wanted[:2:-1]],
        "You call only one generator for each particle. A particle may have several generators, "
        "because every call to add registers another pair.":
            [one for one in wanted if one[:2] != (0, 1)],
        "Your registry leaves out the pair (p0, g2), because you compare generators with ==. "
        "Don't leave out any pair.": [one for one in wanted if one[:2] != (0, 2)],
        "You always pass 1/60 s to the generators. Pass the duration of update_forces.":
            [(p, generator, 1.0 / 60.0) for p, generator, _ in wanted],
        "You call the generator of only one pair in each update, the first one. Perhaps a return "
        "or break ends your loop early.": [wanted[0], wanted[3]],
        "Your registry keeps only the newest pair. In add, append the new pair to the list of the "
        "others.": [wanted[2], wanted[5]],
        "Your update_forces calls none of the generators, although all particles can move. Skip a "
        "particle only if its inverse mass is 0.": [],
    }  # fmt: skip
    expect_asked(
        [*pairs((0, 1), (2, 0), (0, 2)), ("update", h), ("update", k)],
        wanted,
        "Call generator.update_force(particle, duration) exactly once for every pair.",
        slips,
    )


@pytest.mark.exercise("B5.3", asks="It may act on several particles", read=REGISTRY)
def test_one_generator_may_act_on_several_particles() -> None:
    expect_asked(
        [*pairs((0, 0), (1, 0), (2, 0)), ("update", 0.5)],
        [(0, 0, 0.5), (1, 0, 0.5), (2, 0, 0.5)],
        "Call a generator once for every pair that it belongs to.",
    )


@pytest.mark.exercise("B5.3", asks="a pair added twice acts twice", read="the docstring of add")
def test_a_pair_that_is_added_twice_acts_twice() -> None:
    with calls(
        "The registry must keep both pairs, so that the generator acts twice.",
        "registry.add(p, g); registry.add(p, g); registry.update_forces(0.5); number of calls of "
        "g.update_force",
    ):
        got = asked((), [*pairs((1, 1), (1, 1)), ("update", 0.5)])
    expect_exactly(len(got), 2, unit="calls")


@pytest.mark.exercise("B5.3", asks="Undo one call of add", read=REMOVE)
def test_remove_undoes_one_call_of_add() -> None:
    adds, a, b = pairs((0, 0), (1, 1), (0, 0), (0, 0)), (0, 0, 0.5), (1, 1, 0.5)
    expect_asked(
        [*adds, ("update", 0.5)],
        [a, b, a, a],
        "Every call to add registers another pair, so call its generator three times.",
    )
    cause = "Delete only the first pair whose particle and generator are passed to remove."
    with calls(
        cause,
        "a registry with these (particle, generator) pairs: (p0, g0), (p1, g1), (p0, g0), (p0, "
        "g0); registry.remove(p0, g0); registry.update_forces(0.5); the calls to update_force, "
        "sorted by particle",
    ):
        got = [*map(tuple, sorted(asked((), [*adds, ("remove", 0, 0), ("update", 0.5)])))]
    slips = {
        "remove deleted all three pairs (p0, g0). Stop after the first pair that matches.": [b],
        "One call to remove deleted two of the three pairs (p0, g0). Stop after the first pair "
        "that matches, because a loop skips pairs if its list changes.": [a, b],
        "One call to remove emptied the registry. Delete only the first pair (p0, g0).": [],
        "remove(p0, g0) did not delete any pair. Find the first pair (p0, g0).": [a, a, a, b],
    }  # fmt: skip
    why = next((slip for slip, asks in slips.items() if asks == got), cause)
    expect_that(got == [a, a, b], told(got), told([a, a, b]), cause=why)
    acts = [*adds, *[("remove", 0, 0)] * 3, ("update", 0.5)]
    place = "You delete the first or the last pair, whichever it is. Compare its particle and its "
    place += "generator with those passed to remove."
    expect_asked(acts, [b], cause, {place: [a]})


@pytest.mark.exercise("B5.3", asks="are still two different generators", read=REMOVE)
def test_remove_looks_for_both_the_particle_and_the_generator() -> None:
    everyone = [(0, 0, 0.5), (0, 1, 0.5), (1, 0, 0.5), (1, 1, 0.5)]
    for alike, removed, wrong, why in (
        (False, (1, 0), (0, 0),
         "Either you don't compare the particles, or you write `or` where both comparisons must "
         "be true. Compare both, and write `and`."),
        (False, (0, 1), (0, 0),
         "You don't compare the generators. Compare both the particle and the generator."),
        (True, (0, 1), (0, 0),
         "You compare generators with ==. Two different generators can be equal, so use `is`."),
        *((alike, pair[:2], None, "") for alike in (False, True) for pair in everyone),
    ):  # fmt: skip
        slips = {}
        if wrong:
            slip = "Your remove deleted (p{}, g{}) instead of (p{}, g{}). {}"
            slip = slip.format(*wrong, *removed, why)
            slips[slip] = [one for one in everyone if one[:2] != wrong]
        expect_asked(
            [*pairs((0, 0), (0, 1), (1, 0), (1, 1)), ("remove", *removed), ("update", 0.5)],
            [one for one in everyone if one[:2] != removed],
            "remove must delete only this pair. Compare particle and generator with `is`.",
            slips,
            alike=alike,
        )


@pytest.mark.exercise("B5.3", asks="If there is no such pair, do nothing", read=REMOVE)
def test_removing_an_absent_pair_changes_nothing() -> None:
    expect_asked(
        [("remove", 0, 0), *pairs((0, 1), (1, 0)), ("remove", 0, 0), ("update", 0.5)],
        [(0, 1, 0.5), (1, 0, 0.5)],
        "remove must do nothing, and raise no error, if the pair is not registered.",
    )


@pytest.mark.exercise(
    "B5.3", asks="Remove all pairs from the registry", read="the docstring of clear"
)
def test_clear_removes_all_pairs() -> None:
    a, b, c = (0, 0, 0.5), (1, 1, 0.5), (2, 1, 0.25)
    slips = {
        "g0 and g1 are still called after registry.clear(). Remove their pairs.":
            [a, b, a, b, (0, 0, 0.25), (1, 1, 0.25), c],
        "Your clear removed only the first pair in the registry. Remove all pairs, but "
        "don't loop over the list while you remove pairs from it.": [a, b, b, c],
    }  # fmt: skip
    acts = [*pairs((0, 0), (1, 1)), ("update", 0.5), ("clear",), ("update", 0.5)]
    expect_asked(
        [*acts, ("clear",), *pairs((2, 1)), ("update", 0.25)],
        [a, b, c],
        "clear must remove all pairs. A pair that is added afterward must work as usual.",
        slips,
    )


@pytest.mark.exercise("B5.3", asks="and skip immovable particles", read=UPDATE)
def test_immovable_particles_are_skipped() -> None:
    a, b = (0, 0, 0.5), (2, 0, 0.5)
    slips = {
        "Your loop ends at an immovable particle. Skip only this pair, and continue.": [a],
        "You call g0 and g1 for p1, which is immovable. Skip its pairs. Test inverse_mass, because "
        "a mass of infinity counts as true.": [a, (1, 0, 0.5), (1, 1, 0.5), b],
    }
    expect_asked(
        [*pairs((0, 0), (1, 0), (1, 1), (2, 0)), ("update", 0.5)],
        [a, b],
        "Skip the pairs of immovable particles without removing them.",
        slips,
        immovable=(1,),
    )
    expect_asked(
        [*pairs((1, 2), (0, 2)), ("update", 0.5), ("free", 1), ("update", 0.5)],
        [(0, 2, 0.5), (1, 2, 0.5), (0, 2, 0.5)],
        "p1 can move in the second update. Keep its pair in the registry, and check it again.",
        immovable=(1,),
    )


@pytest.mark.exercise(
    "B5.3", asks="without changing the particles and generators", read="book 5.2.2"
)
def test_the_registry_keeps_earlier_forces(rng: Random) -> None:
    by_hand, first, second = vector(rng), vector(rng), vector(rng)
    g0, g1 = Push(first), Push(second)
    with calls(
        "registry.add must only add the pair, and change no forces.",
        f"p.add_force(Vector3{by_hand}); a registry with the pairs (p, g0) and (p, g1)",
    ):
        p, registry = Particle(mass=2.0), ForceRegistry()
        p.add_force(Vector3(*by_hand))
        registry.add(p, g0)
        registry.add(p, g1)
        got = xyz(p.force_accumulator)
    then = "; p.force_accumulator"
    expect_close(got, by_hand, then=then, read="the docstring of add", unit="N")
    with calls(
        "The sum must contain the force from add_force and those of both generators.",
        f"{about.call}; g0 adds a force of {first} N, and g1 a force of {second} N; "
        "registry.update_forces(0.5)",
    ):
        registry.update_forces(0.5)
    wanted = by_hand + first + second
    slips = {
        "The force from p.add_force is missing. Don't clear the sum.": first + second,
        "The sum is zero. Don't clear it, and don't integrate the particle.": (0, 0, 0),
    }
    # Two roundings of numbers up to 30.
    expect_close(p.force_accumulator, wanted, slips, then=then, tolerance=1e-13, unit="N")
    with calls(
        "registry.clear must only remove the pairs, and change no forces.",
        "registry.clear(); p.force_accumulator",
        more=True,
    ):
        registry.remove(p, g0)
        registry.clear()
        got = p.force_accumulator
    expect_close(got, wanted, tolerance=1e-13, unit="N", read="the docstring of clear")


@pytest.mark.exercise("B5.3", asks="A generator may add or remove pairs", read=UPDATE)
def test_a_generator_may_change_the_registry_during_an_update() -> None:
    copy = "Loop over a copy of the list, and process every pair in it."
    for what, second, change, mistake in (
        ("remove", 2, "removes the pair (p, g0)",
         "Your loop skips g1, because g0 removes its own pair during the loop."),
        ("add", 4, "adds another pair (p, g0)",
         "Your loop also processes the pair that g0 adds during the loop."),
        ("remove the second", 2, "removes the pair (p, g1)",
         "Your loop skips g1, because g0 removes the pair (p, g1) during the loop."),
        ("clear", 0, "clears the registry",
         "Your loop ends early, because g0 clears the registry during the loop."),
    ):  # fmt: skip
        with calls(
            f"A change during an update must take effect only in the next update. {copy}",
            "a registry with the pairs (p, g0), (p, g1) and (p, g2); every call to "
            f"g0.update_force {change}; registry.update_forces(0.5); registry.update_forces(0.5); "
            "number of generators that each update calls",
        ):
            got = asked_while_it_changes(what)
        if got[0] not in (0, 3):
            about(cause=f"{mistake} {copy}")
        came, right = (f"{a} in the first update, {b} in the second" for a, b in (got, (3, second)))
        expect_that(got == [3, second], came, right)
