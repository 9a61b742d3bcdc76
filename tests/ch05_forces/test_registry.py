"""The force registry, build task B5.3: generators that keep a record stand in probes.py."""

from __future__ import annotations

from itertools import takewhile
from random import Random
from typing import Any

import pytest

from ch05_forces.probes import (
    asked,
    asked_while_it_changes,
    gathered,
    paired,
)
from draw import components
from expect import about, blame, expect_close, expect_exactly, expect_that, scoped

COPY = "Loop over a copy of the list."
# What g0 does to the registry during an update, as in probes.py and in words, and the mistake.
CHANGES = {
    "remove": (
        "removes the pair (p, g0)",
        f"Your loop skips g1, because g0 removes its own pair during the loop. {COPY}",
    ),
    "add": (
        "adds another pair (p, g0)",
        f"Your loop also processes the pair that g0 adds during the loop. {COPY}",
    ),
    "remove the second": (
        "removes the pair (p, g1)",
        "Your loop skips g1, because g0 removes the pair (p, g1) during the loop. Loop over a copy "
        "of the list, and process every pair in the copy.",
    ),
    "clear": (
        "clears the registry",
        f"Your loop ends early, because g0 clears the registry during the loop. {COPY}",
    ),
}


def told(calls: list[tuple[int, int, float]]) -> str:
    """Say which generator was called for which particle, and with which duration."""
    shown = [
        f"g{g} on p{p} for {f'{h:.6g} s' if isinstance(h, (int, float)) else repr(h)}"
        for p, g, h in calls
    ]
    return ", ".join(shown) or "no calls"


def holding(*pairs: tuple[int, int]) -> str:
    """Describe a registry that holds these pairs, each the numbers of a particle and a generator.

    The words do not call add, because the student is to open the function under test.
    """
    if not pairs:
        return "an empty registry; "
    shown = ", ".join(f"(p{p}, g{g})" for p, g in pairs)
    return f"a registry with these (particle, generator) pairs: {shown}; "


@scoped
def expect_asked(
    acts: list[tuple[Any, ...]],
    wanted: list[tuple[int, int, float]],
    *,
    cause: str,
    immovable: tuple[int, ...] = (),
    slips: dict[str, list[tuple[int, int, float]]] | None = None,
    alike: bool = True,
) -> None:
    """Expect these calls of update_force: which particle, which generator, which duration.

    ``slips`` are the calls that likely mistakes make. If ``alike`` is True, all generators are
    equal under ==.
    """
    about.cause = cause
    first = [*takewhile(lambda act: act[0] == "add", acts)]
    about.call = holding(*((p, g) for _, p, g in first))
    about.call += "".join(f"p{i} is immovable; " for i in immovable)
    for name, *numbers in acts[len(first) :]:
        if name == "add":
            about.call += f"the pair (p{numbers[0]}, g{numbers[1]}) is added; "
        elif name == "remove":
            about.call += f"registry.remove(p{numbers[0]}, g{numbers[1]}); "
        elif name == "free":
            about.call += f"p{numbers[0]}.inverse_mass = 1.0; "
        elif name == "clear":
            about.call += "registry.clear(); "
        else:
            about.call += f"registry.update_forces({numbers[0]}); "
    about.call += "the calls to update_force"
    try:
        got = [*map(tuple, asked(immovable, acts, alike))]
    except AttributeError as error:
        if "Generator' object has no attribute" in str(error):
            about.cause = "You use a generator where a particle is needed. Each entry of "
            about.cause += "self._pairs is a tuple (particle, generator), in this order."
        raise
    except TypeError as error:
        if "must be a Vector3, got None" not in str(error):
            raise
        about.cause = (
            "update_force adds the force to the particle itself and returns None. Call it "
        )
        about.cause += "without passing its result to add_force."
        expect_that(False, f"TypeError: {error}", told(wanted))
    for name, calls in (slips or {}).items():
        if got == calls:
            about.cause = name
    expect_that(got == wanted, told(got), told(wanted))


@pytest.mark.exercise("B5.3", asks="pairs (particle, generator) in _pairs")
def test_a_pair_is_a_particle_and_then_its_generator(rng: Random) -> None:
    i, j = rng.randrange(3), rng.randrange(3)
    about.call = f"registry = ForceRegistry(); registry.add(p{i}, g{j}); registry.pairs()"
    about.cause = (
        "pairs() must return one (particle, generator) tuple for each call of add. Append "
    )
    about.cause += "the tuple (particle, generator) to self._pairs."
    about.read = "the docstring of ForceRegistry"
    got = [*map(tuple, paired(i, j))]
    if got == [(f"g{j}", f"p{i}")]:
        about.cause = "You store the generator before the particle. The other methods and later "
        about.cause += "chapters expect the particle first, so store (particle, generator)."
    shown = ", ".join(f"({', '.join(pair)})" for pair in got) or "no pairs"
    expect_that(got == [(f"p{i}", f"g{j}")], shown, f"(p{i}, g{j})")


@pytest.mark.exercise("B5.3", asks="Go through the pairs in the order")
def test_every_pair_is_called_once_per_step(rng: Random) -> None:
    h, k = round(rng.uniform(0.1, 0.5), 3), round(rng.uniform(0.6, 0.9), 3)
    about.cause = "Your calls to update_force are wrong. Call generator.update_force(particle, "
    about.cause += "duration) exactly once for every pair."
    about.read = "book 5.2.2"
    acts = [("add", 0, 1), ("add", 2, 0), ("add", 0, 2), ("update", h), ("update", k)]
    wanted = [(0, 1, h), (2, 0, h), (0, 2, h), (0, 1, k), (2, 0, k), (0, 2, k)]
    slips = {
        "You call the generators only in the first update. A pair must stay registered until "
        "remove or clear removes it.": wanted[:3],
        "You call the generator of the newest pair first. Call the generators in the order in "
        "which their pairs were added.": [
            *wanted[2::-1],
            *wanted[:2:-1],
        ],
        "You call only one generator for each particle. A particle may have several "
        "generators, because every call to add registers another pair.": [
            one for one in wanted if one[:2] != (0, 1)
        ],
        "Your registry leaves out the pair (p0, g2), because you compare generators with ==. Two "
        "different generators can be equal. Don't leave out any pair, because even the same pair "
        "may be added twice.": [one for one in wanted if one[:2] != (0, 2)],
        "You always pass a duration of 1/60 s to the generators. Pass them the duration that "
        "update_forces receives.": [(p, generator, 1.0 / 60.0) for p, generator, _ in wanted],
        "You call the generator of only one pair in each update, the first one. Perhaps a return "
        "or break ends your loop early.": [wanted[0], wanted[3]],
        "Your registry keeps only the newest pair. In add, append the new pair to the list of the "
        "others.": [wanted[2], wanted[5]],
        "Your update_forces calls none of the generators, although all particles can move. Skip "
        "a particle only if its inverse mass is 0.": [],
    }
    expect_asked(acts, wanted, cause=about.cause, slips=slips)


@pytest.mark.exercise("B5.3", asks="It may act on several particles")
def test_one_generator_may_act_on_several_particles() -> None:
    about.cause = "You don't call g0 for all three particles. Call a generator once for every pair "
    about.cause += "that it belongs to."
    about.read = "the docstring of ForceRegistry"
    acts = [("add", 0, 0), ("add", 1, 0), ("add", 2, 0), ("update", 0.5)]
    expect_asked(acts, [(0, 0, 0.5), (1, 0, 0.5), (2, 0, 0.5)], cause=about.cause)


@pytest.mark.exercise("B5.3", asks="a pair added twice acts twice")
def test_a_pair_that_is_added_twice_acts_twice() -> None:
    about.cause = "Your registry treats a pair that was added twice as one pair. Keep both, so "
    about.cause += "that the generator acts twice."
    about.read = "the docstring of add"
    about.call = "registry.add(p, g); registry.add(p, g); registry.update_forces(0.5); number of "
    about.call += "calls of g.update_force"
    got = asked((), [("add", 1, 1), ("add", 1, 1), ("update", 0.5)])
    expect_exactly(len(got), 2, unit="calls")


@pytest.mark.exercise("B5.3", asks="Undo one call of add")
def test_remove_undoes_one_call_of_add() -> None:
    about.read = "the docstring of remove"
    about.cause = "remove does not delete the right pair. Find the first pair whose particle and "
    about.cause += "generator are the ones passed to remove, and delete only this pair."
    adds = [("add", 0, 0), ("add", 1, 1), ("add", 0, 0), ("add", 0, 0)]
    everyone = [(0, 0, 0.5), (1, 1, 0.5), (0, 0, 0.5), (0, 0, 0.5)]
    expect_asked(
        [*adds, ("update", 0.5)],
        everyone,
        cause="The same pair (p0, g0) was added three times, so its generator must be called "
        "three times. Every call to add registers another pair.",
    )
    about.call = f"{holding((0, 0), (1, 1), (0, 0), (0, 0))}registry.remove(p0, g0); "
    about.call += "registry.update_forces(0.5); the calls to update_force, sorted by particle"
    got = [*map(tuple, sorted(asked((), [*adds, ("remove", 0, 0), ("update", 0.5)])))]
    wanted = [(0, 0, 0.5), (0, 0, 0.5), (1, 1, 0.5)]
    why = about.cause
    if got == [(1, 1, 0.5)]:
        why = "One call to remove deleted all three pairs (p0, g0). Stop after the first pair "
        why += "that matches."
    elif got == [(0, 0, 0.5), (1, 1, 0.5)]:
        why = "One call to remove deleted two of the three pairs (p0, g0). Stop after the first "
        why += "pair that matches, because a loop skips pairs if its list changes."
    elif not got:
        why = "One call to remove emptied the registry. Delete only the first pair (p0, g0)."
    elif got == sorted(everyone):
        why = "remove(p0, g0) did not delete any pair. Find the first pair (p0, g0) in the list "
        why += "and delete it."
    expect_that(got == wanted, told(got), told(wanted), cause=why)
    acts = [*adds, *[("remove", 0, 0)] * 3, ("update", 0.5)]
    place = "You delete the first or the last pair, whichever it is. Compare its particle and its "
    place += "generator with those passed to remove."
    expect_asked(acts, [(1, 1, 0.5)], cause=about.cause, slips={place: [(0, 0, 0.5)]})


@pytest.mark.exercise("B5.3", asks="are still two different generators")
def test_remove_looks_for_both_the_particle_and_the_generator() -> None:
    about.read = "the docstring of remove"
    about.cause = "remove must delete exactly the pair that is passed to it. Compare both the "
    about.cause += "particle and the generator with `is`."
    pairs = [("add", 0, 0), ("add", 0, 1), ("add", 1, 0), ("add", 1, 1)]
    everyone = [(0, 0, 0.5), (0, 1, 0.5), (1, 0, 0.5), (1, 1, 0.5)]
    either = (
        "Either you don't compare the particles, or you write `or` where both comparisons must "
    )
    either += "be true. Compare both, and write `and`."
    alone = "You don't compare the generators. Compare both the particle and the generator."
    equal = "You compare generators with ==. Two different generators can be equal, so use `is`."
    for alike, removed, wrong, why in (
        (False, (1, 0), (0, 0), either),
        (False, (0, 1), (0, 0), alone),
        (True, (0, 1), (0, 0), equal),
        *((alike, pair[:2], None, "") for alike in (False, True) for pair in everyone),
    ):
        slips = {}
        if wrong:
            slip = f"Your remove deleted (p{wrong[0]}, g{wrong[1]}) instead of (p{removed[0]}, "
            slip += f"g{removed[1]}). {why}"
            slips[slip] = [one for one in everyone if one[:2] != wrong]
        acts = [*pairs, ("remove", *removed), ("update", 0.5)]
        wanted = [one for one in everyone if one[:2] != removed]
        expect_asked(acts, wanted, cause=about.cause, slips=slips, alike=alike)


@pytest.mark.exercise("B5.3", asks="If there is no such pair, do nothing")
def test_removing_an_absent_pair_changes_nothing() -> None:
    about.read = "the docstring of remove"
    about.cause = "The pair (p0, g0) is not registered when remove is called. In this case, remove "
    about.cause += "must do nothing and raise no error."
    acts = [("remove", 0, 0), ("add", 0, 1), ("add", 1, 0), ("remove", 0, 0), ("update", 0.5)]
    expect_asked(acts, [(0, 1, 0.5), (1, 0, 0.5)], cause=about.cause)


@pytest.mark.exercise("B5.3", asks="Remove all pairs from the registry")
def test_clear_removes_all_pairs() -> None:
    about.read = "the docstring of clear"
    about.cause = "The calls to update_force are wrong. clear must remove all pairs from the "
    about.cause += "registry, and a pair that is added afterward must work as usual."
    acts = [("add", 0, 0), ("add", 1, 1), ("update", 0.5), ("clear",), ("update", 0.5)]
    acts += [("clear",), ("add", 2, 1), ("update", 0.25)]
    first = [(0, 0, 0.5), (1, 1, 0.5)]
    slips = {
        "g0 and g1 are still called after registry.clear(). clear must remove all pairs from the "
        "registry.": [*first, *first, (0, 0, 0.25), (1, 1, 0.25), (2, 1, 0.25)],
        "Your clear removed only the first pair in the registry. It must remove all pairs, so "
        "don't loop over the list while you remove pairs from it.": [
            *first,
            (1, 1, 0.5),
            (2, 1, 0.25),
        ],
    }
    expect_asked(acts, [*first, (2, 1, 0.25)], cause=about.cause, slips=slips)


@pytest.mark.exercise("B5.3", asks="and skip immovable particles")
def test_immovable_particles_are_skipped() -> None:
    about.read = "the docstring of update_forces"
    about.cause = "No force can move the immovable particle p1. Skip its pairs without removing "
    about.cause += "them, and process all other pairs."
    acts = [("add", 0, 0), ("add", 1, 0), ("add", 1, 1), ("add", 2, 0), ("update", 0.5)]
    wanted = [(0, 0, 0.5), (2, 0, 0.5)]
    slips = {
        "Your loop ends when it reaches a pair with an immovable particle. Skip only this pair, "
        "and continue with the next one.": wanted[:1],
        "You call g0 and g1 for p1, although no force can move an immovable particle. Skip the "
        "pairs of p1, but keep them in the registry. Test inverse_mass, which is 0 here, because "
        "a mass of infinity counts as true.": [
            (0, 0, 0.5),
            (1, 0, 0.5),
            (1, 1, 0.5),
            (2, 0, 0.5),
        ],
    }
    expect_asked(acts, wanted, cause=about.cause, immovable=(1,), slips=slips)
    about.cause = (
        "You skip p1 in the second update, although it can move by then. Keep its pair in "
    )
    about.cause += "the registry, and check the inverse mass in every update."
    acts = [("add", 1, 2), ("add", 0, 2), ("update", 0.5), ("free", 1), ("update", 0.5)]
    wanted = [(0, 2, 0.5), (1, 2, 0.5), (0, 2, 0.5)]
    expect_asked(acts, wanted, cause=about.cause, immovable=(1,))


@pytest.mark.exercise("B5.3", asks="without changing the particles and generators")
def test_the_registry_keeps_earlier_forces(rng: Random) -> None:
    by_hand, first, second = components(rng), components(rng), components(rng)
    about.call = f"p.add_force(Vector3{by_hand}); a registry with the pairs (p, g0) and (p, g1); "
    about.call += f"g0 adds a force of {first} N, and g1 a force of {second} N; "
    about.call += "registry.update_forces(0.5); p.force_accumulator"
    about(
        cause="The sum of the forces is wrong. It must contain the force from add_force and the "
        "forces of both generators.",
        read="book 5.2.2",
    )
    before, after, emptied = gathered(by_hand, [first, second])
    wanted = tuple(by_hand[i] + first[i] + second[i] for i in range(3))
    cleared = "The force from p.add_force is missing from the sum. Don't clear the sum in "
    cleared += "update_forces, because only a time step does that."
    moved = "The sum is zero after update_forces. Don't clear it and don't integrate the particle "
    moved += "there, because the particles move only after the update."
    blame(tuple(after), {cleared: [first[i] + second[i] for i in range(3)], moved: (0, 0, 0)})
    # Two roundings of numbers up to 30.
    expect_close(after, wanted, tolerance=1e-13, unit="N")
    about.cause = "registry.add changed the sum of the forces on p. It must only add the pair to "
    about.cause += "the registry."
    name = f"p.add_force(Vector3{by_hand}); registry.add(p, g); p.force_accumulator"
    expect_close(before, by_hand, call=name, read="the docstring of add", unit="N")
    about.read = "the docstring of clear"
    about.cause = "registry.clear changed the sum of the forces on p. It must only remove the "
    about.cause += "pairs from the registry."
    name = about.call.replace("p.force_acc", "registry.clear(); p.force_acc")
    expect_close(emptied, wanted, call=name, tolerance=1e-13, unit="N")


@pytest.mark.exercise("B5.3", asks="A generator may add or remove pairs")
def test_a_generator_may_change_the_registry_during_an_update() -> None:
    about.read = "the docstring of update_forces"
    for what, second in (("remove", 2), ("add", 4), ("remove the second", 2), ("clear", 0)):
        change, mistake = CHANGES[what]
        about.call = "a registry with the pairs (p, g0), (p, g1) and (p, g2); every call to "
        about.call += f"g0.update_force {change}; registry.update_forces(0.5); "
        about.call += "registry.update_forces(0.5); number of generators that each update calls"
        got = asked_while_it_changes(what)
        about.cause = "A change during an update must take effect only in the next update. " + COPY
        if got[0] not in (0, 3):
            about.cause = mistake
        came, right = (f"{a} in the first update, {b} in the second" for a, b in (got, (3, second)))
        expect_that(got == [3, second], came, right)
