"""The force registry, build task B5.3: generators that keep a record stand in probes.py."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceRegistry, Gravity
from ch05_forces.particle import Particle
from ch05_forces.probes import (
    asked,
    asked_after_a_refusal,
    asked_while_it_changes,
    failing,
    gathered,
)
from draw import components
from expect import about, expect_close, expect_error, expect_exactly, scoped

# What a generator does to the registry during an update, as in probes.py and in words.
CHANGES = {
    "remove": "removes its own pair",
    "add": "adds another pair",
    "remove the second": "removes the second pair",
    "clear": "clears the registry",
}


@scoped
def expect_asked(
    acts: list[tuple[Any, ...]],
    wanted: list[tuple[int, int, float]],
    *,
    cause: str,
    immovable: tuple[int, ...] = (),
    slips: dict[str, list[tuple[int, int, float]]] | None = None,
) -> None:
    """Expect these calls of update_force: which particle, which generator, which duration.

    ``slips`` are the calls that likely mistakes make.
    """
    about.cause = cause
    told = []
    for name, *numbers in acts:
        if name == "add":
            told.append(f"the pair (p[{numbers[0]}], generator[{numbers[1]}]) is added")
        elif name == "remove":
            told.append(f"registry.remove(p[{numbers[0]}], generator[{numbers[1]}])")
        elif name == "free":
            told.append(f"p[{numbers[0]}].inverse_mass = 1.0")
        elif name == "clear":
            told.append("registry.clear()")
        else:
            told.append(f"registry.update_forces({numbers[0]})")
    about.call = "; ".join(told) + (
        "; each call of update_force as (number of the particle, number of the generator, duration)"
    )
    if immovable:
        about.call = f"p{[*immovable]} is immovable; {about.call}"
    got = [*map(tuple, asked(immovable, acts))]
    for name, calls in (slips or {}).items():
        if got == calls:
            about.cause = name
    expect_exactly(got, wanted)


@pytest.mark.exercise("B5.3")
def test_every_pair_is_asked_once_a_frame(rng: Random) -> None:
    h, k = round(rng.uniform(0.1, 0.5), 3), round(rng.uniform(0.6, 0.9), 3)
    about.cause = "In each update, go through all pairs. Call the update_force of each generator "
    about.cause += "once, with the particle of the pair and the duration."
    about.read = "book 5.2.2"
    acts = [("add", 0, 1), ("add", 2, 0), ("add", 0, 2), ("update", h), ("update", k)]
    wanted = [(0, 1, h), (2, 0, h), (0, 2, h), (0, 1, k), (2, 0, k), (0, 2, k)]
    slips = {
        "Your generators were called only in the first update. A pair must stay registered "
        "until remove or clear removes it.": wanted[:3],
        "Your generators were called in the wrong order, with the newest pair first. Call them "
        "in the order in which their pairs were added.": [
            *wanted[2::-1],
            *wanted[:2:-1],
        ],
        "You called only one generator for each particle. A particle may have several "
        "generators, because every call of add registers another pair.": [
            one for one in wanted if one[:2] != (0, 1)
        ],
        "The generator of one pair was not called, perhaps because you compare generators with "
        "==. Two different generators can be equal, so compare with `is`.": [
            one for one in wanted if one[:2] != (0, 2)
        ],
        "Your generators were always called with a duration of 1/60 s. Pass them the duration "
        "that update_forces was called with.": [
            (p, generator, 1.0 / 60.0) for p, generator, _ in wanted
        ],
        (
            "No generator was called, although the particles can move. Skip a particle only if "
            "its inverse mass is 0."
        ): [],
    }
    expect_asked(acts, wanted, cause=about.cause, slips=slips)


@pytest.mark.exercise("B5.3")
def test_one_generator_may_serve_many_particles() -> None:
    about.cause = "One generator was added for three particles, so it belongs to three pairs. "
    about.cause += "Call its update_force once for every pair."
    about.read = "the docstring of ForceRegistry"
    acts = [("add", 0, 0), ("add", 1, 0), ("add", 2, 0), ("update", 0.5)]
    expect_asked(acts, [(0, 0, 0.5), (1, 0, 0.5), (2, 0, 0.5)], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_a_pair_that_is_added_twice_acts_twice() -> None:
    about.cause = "The same pair was added twice, so its generator must be called twice. Don't "
    about.cause += "check whether a pair is already registered."
    about.read = "the docstring of add"
    about.call = "registry.add(p, generator) twice; registry.update_forces(0.5); number of calls "
    about.call += "of generator.update_force"
    got = asked((), [("add", 1, 1), ("add", 1, 1), ("update", 0.5)])
    expect_exactly(len(got), 2)


@pytest.mark.exercise("B5.3")
def test_remove_takes_back_one_call_of_add() -> None:
    about.read = "the docstring of remove"
    about.cause = "Each call of remove must remove exactly one pair and keep all the others. Stop "
    about.cause += "after the first pair that matches."
    adds = [("add", 0, 0), ("add", 1, 1), ("add", 0, 0), ("add", 0, 0)]
    everyone = [(0, 0, 0.5), (1, 1, 0.5), (0, 0, 0.5), (0, 0, 0.5)]
    expect_asked(
        [*adds, ("update", 0.5)],
        everyone,
        cause="The pair (p[0], generator[0]) was added three times, and every call of "
        "add registers another pair. All three must act until remove is called.",
    )
    about.call = "the pair (p[0], generator[0]) is added three times; the pair (p[1], "
    about.call += "generator[1]) is added once; registry.remove(p[0], generator[0]); "
    about.call += "registry.update_forces(0.5); each call of update_force as (number of the "
    about.call += "particle, number of the generator, duration), sorted"
    got = sorted(asked((), [*adds, ("remove", 0, 0), ("update", 0.5)]))
    wanted = [(0, 0, 0.5), (0, 0, 0.5), (1, 1, 0.5)]
    expect_exactly([*map(tuple, got)], wanted)
    acts = [*adds, *[("remove", 0, 0)] * 3, ("update", 0.5)]
    expect_asked(acts, [(1, 1, 0.5)], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_remove_looks_for_both_the_particle_and_the_generator() -> None:
    about.read = "the docstring of remove"
    about.cause = "You removed the wrong pair or none, perhaps because you compare with ==. Two "
    about.cause += "different generators can be equal, so compare with `is`, and check both the "
    about.cause += "particle and the generator."
    pairs = [("add", 0, 0), ("add", 0, 1), ("add", 1, 0), ("add", 1, 1)]
    everyone = [(0, 0, 0.5), (0, 1, 0.5), (1, 0, 0.5), (1, 1, 0.5)]
    for i, (_, particle, generator) in enumerate(pairs):
        acts = [*pairs, ("remove", particle, generator), ("update", 0.5)]
        expect_asked(acts, everyone[:i] + everyone[i + 1 :], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_remove_of_what_is_absent_changes_nothing() -> None:
    about.read = "the docstring of remove"
    about.cause = "The pair (p[0], generator[0]) is not registered when remove is called. remove "
    about.cause += "must then do nothing, without raising an error."
    acts = [("remove", 0, 0), ("add", 0, 1), ("add", 1, 0), ("remove", 0, 0), ("update", 0.5)]
    expect_asked(acts, [(0, 1, 0.5), (1, 0, 0.5)], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_clear_takes_back_everything() -> None:
    about.read = "the docstring of clear"
    about.cause = "Some pairs were still called after clear. It must remove all pairs, so that "
    about.cause += "only pairs that are added later can act."
    acts = [("add", 0, 0), ("add", 1, 1), ("update", 0.5), ("clear",), ("update", 0.5)]
    acts += [("clear",), ("add", 2, 1), ("update", 0.25)]
    expect_asked(acts, [(0, 0, 0.5), (1, 1, 0.5), (2, 1, 0.25)], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_immovable_particles_are_skipped() -> None:
    about.read = "the docstring of update_forces"
    about.cause = "No force can move the immovable particle p[1], so update_forces must skip its "
    about.cause += "pairs. Don't remove them, because the particle may become movable later."
    acts = [("add", 0, 0), ("add", 1, 0), ("add", 1, 1), ("add", 2, 0), ("update", 0.5)]
    wanted = [(0, 0, 0.5), (2, 0, 0.5)]
    slips = {
        "Your loop stops at the pair of the immovable particle. Skip only this pair, and "
        "continue with the next one.": wanted[:1]
    }
    expect_asked(acts, wanted, cause=about.cause, immovable=(1,), slips=slips)
    about.cause = "The particle p[1] was immovable at first, but now it can move. Check the "
    about.cause += "inverse mass in every update."
    acts = [("add", 1, 2), ("add", 0, 2), ("update", 0.5), ("free", 1), ("update", 0.5)]
    wanted = [(0, 2, 0.5), (1, 2, 0.5), (0, 2, 0.5)]
    expect_asked(acts, wanted, cause=about.cause, immovable=(1,))


@pytest.mark.exercise("B5.3")
def test_an_update_adds_to_the_forces_that_are_there(rng: Random) -> None:
    by_hand, first, second = components(rng), components(rng), components(rng)
    about.call = f"p.add_force(Vector3{by_hand}); two generators push p with {first} and {second}; "
    about.call += "registry.update_forces(0.5); p.force_accumulator, in N"
    about(
        cause="The sum must contain the forces of both generators and the one that was "
        "added with add_force. Don't clear the forces in update_forces, because only a step "
        "does that.",
        read="book 5.2.2",
    )
    before, after, emptied = gathered(by_hand, [first, second])
    wanted = tuple(by_hand[i] + first[i] + second[i] for i in range(3))
    # Two roundings of numbers up to 30.
    expect_close(after, wanted, tolerance=1e-13)
    about.cause = "The sum of the forces on the particle has changed. add, remove and clear must "
    about.cause += "change only the registry, not the forces."
    name = f"p.add_force(Vector3{by_hand}); registry.add(p, generator); p.force_accumulator, in N"
    expect_close(before, by_hand, call=name, read="the docstring of add")
    about.read = "the docstring of clear"
    expect_close(emptied, wanted, then=", after registry.clear()", tolerance=1e-13)


@pytest.mark.exercise("B5.3")
def test_a_generator_may_change_the_registry_meanwhile() -> None:
    about.read = "the docstring of update_forces"
    about.cause = "A generator added or removed pairs during the update. Such a change must take "
    about.cause += "effect only in the next update, so loop over a copy of the list."
    for what, second in (("remove", 2), ("add", 4), ("remove the second", 2), ("clear", 0)):
        about.call = "a registry with three pairs; in each update the first generator "
        about.call += f"{CHANGES[what]}; registry.update_forces(0.5) twice; number of generators "
        about.call += "called in each update"
        got = asked_while_it_changes(what)
        expect_exactly(got, [3, second])


@pytest.mark.exercise("B5.3")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan, "0.5"])
def test_an_update_takes_a_positive_and_finite_duration(duration: float) -> None:
    about(f"registry.update_forces({duration!r})", read="the docstring of update_forces")
    about.cause = "The duration must be a positive, finite number. Check it first, with the "
    about.cause += "function positive from arguments.py, which raises both errors for you."
    expect_error(
        lambda: ForceRegistry().update_forces(duration),
        TypeError if isinstance(duration, str) else ValueError,
        allowed=lambda: ForceRegistry().update_forces(0.5),
    )
    for immovable in (False, True):
        got = asked_after_a_refusal(duration, immovable)
        about.cause = "update_forces raised an error because of the duration, but it had already "
        about.cause += "called a generator. Check the duration before you call any generator."
        then = " with one pair, which raises an error; registry.update_forces(0.5); number of "
        then += "generators called in both updates"
        expect_exactly(got, 1, then=then)


@pytest.mark.exercise("B5.3")
@pytest.mark.robust
def test_what_a_generator_raises_comes_out() -> None:
    about.call = "registry.update_forces(0.5) with a generator that raises ArithmeticError"
    about.cause = "An error that a generator raises must reach the caller of update_forces, so "
    about.cause += "don't catch it."
    about.read = "the docstring of update_forces"
    registry = failing()
    expect_error(
        lambda: registry.update_forces(0.5),
        ArithmeticError,
        allowed=lambda: ForceRegistry().update_forces(0.5),
    )


@pytest.mark.exercise("B5.3")
@pytest.mark.robust
@pytest.mark.parametrize("bad", [None, "gravity"])
def test_only_a_particle_and_a_generator_can_be_added(bad: Any) -> None:
    about.read = "the docstring of add"
    registry, other = ForceRegistry(), ForceRegistry()
    p, gravity = Particle(), Gravity(Vector3(0.0, -10.0, 0.0))
    for call, attempt in (
        (f"registry.add(p, {bad!r})", lambda: registry.add(p, bad)),
        (f"registry.add({bad!r}, gravity)", lambda: registry.add(bad, gravity)),
        ("registry.add(gravity, p)", lambda: registry.add(gravity, p)),  # type: ignore[arg-type]
    ):
        about.call = call
        about.cause = "registry.add must check both arguments. Raise TypeError if the particle "
        about.cause += "has no add_force or if the generator has no update_force."
        expect_error(attempt, TypeError, allowed=lambda: other.add(p, gravity))
        about.cause = "registry.add raised an error, but it registered the pair anyway. Check "
        about.cause += "both arguments before you append the pair."
        about.call += ", which raises TypeError; registry.update_forces(0.5)"
        came = "no error"
        try:
            registry.update_forces(0.5)
        except AttributeError as error:  # what was refused has no method, or no inverse mass
            came = f"AttributeError: {error}"
        expect_exactly(came, "no error")
