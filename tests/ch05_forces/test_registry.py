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
            told.append(f"added p[{numbers[0]}] with generator[{numbers[1]}]")
        elif name == "remove":
            told.append(f"registry.remove(p[{numbers[0]}], generator[{numbers[1]}])")
        elif name == "free":
            told.append(f"p[{numbers[0]}].inverse_mass = 1.0")
        elif name == "clear":
            told.append("registry.clear()")
        else:
            told.append(f"registry.update_forces({numbers[0]})")
    about.call = "; ".join(told) + "; calls of update_force as (particle, generator, duration)"
    if immovable:
        about.call = f"p{[*immovable]} immovable; {about.call}"
    got = [*map(tuple, asked(immovable, acts))]
    for name, calls in (slips or {}).items():
        if got == calls:
            about.cause = name
    expect_exactly(got, wanted)


@pytest.mark.exercise("B5.3")
def test_every_pair_is_asked_once_a_frame(rng: Random) -> None:
    h, k = round(rng.uniform(0.1, 0.5), 3), round(rng.uniform(0.6, 0.9), 3)
    about.cause = "In each update, go through all pairs and call each generator's update_force "
    about.cause += "once, with the particle of the pair and the duration."
    about.read = "book 5.2.2"
    acts = [("add", 0, 1), ("add", 2, 0), ("add", 0, 2), ("update", h), ("update", k)]
    wanted = [(0, 1, h), (2, 0, h), (0, 2, h), (0, 1, k), (2, 0, k), (0, 2, k)]
    slips = {
        "The generators were called only in the first update. A pair must stay registered until "
        "remove or clear removes it.": wanted[:3],
        "You called the newest pair first. Call the generators in the order in which their "
        "pairs were added.": [
            *wanted[2::-1],
            *wanted[:2:-1],
        ],
        "You called only one generator per particle. A particle may have several, because every "
        "call to add registers another pair.": [one for one in wanted if one[:2] != (0, 1)],
        "The generator of one pair was not called, perhaps because you compare generators with "
        "==. Two different generators can be equal, so compare with `is`.": [
            one for one in wanted if one[:2] != (0, 2)
        ],
        "The generators always got a duration of 1/60 s. Pass them the duration that update_forces "
        "was called with.": [(p, generator, 1.0 / 60.0) for p, generator, _ in wanted],
        (
            "The particles can move, but no generator was called. Skip a particle only if its "
            "inverse mass is 0."
        ): [],
    }
    expect_asked(acts, wanted, cause=about.cause, slips=slips)


@pytest.mark.exercise("B5.3")
def test_one_generator_may_serve_many_particles() -> None:
    about.cause = "A particle or a generator may belong to several pairs. Call update_force once "
    about.cause += "for every pair."
    about.read = "the docstring of ForceRegistry"
    acts = [("add", 0, 0), ("add", 1, 0), ("add", 2, 0), ("update", 0.5)]
    expect_asked(acts, [(0, 0, 0.5), (1, 0, 0.5), (2, 0, 0.5)], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_a_pair_that_is_added_twice_acts_twice() -> None:
    about.cause = "The same pair was added more than once, so its generator must act that many "
    about.cause += "times. Don't check whether the pair is already registered."
    about.read = "the docstring of add"
    about.call = "registry.add(p, generator) twice; registry.update_forces(0.5); number of calls"
    got = asked((), [("add", 1, 1), ("add", 1, 1), ("update", 0.5)])
    expect_exactly(len(got), 2)


@pytest.mark.exercise("B5.3")
def test_remove_takes_back_one_call_of_add() -> None:
    about.read = "the docstring of remove"
    about.cause = "Each call to remove must remove exactly one pair and keep all the others. Stop "
    about.cause += "after the first pair that matches."
    adds = [("add", 0, 0), ("add", 1, 1), ("add", 0, 0), ("add", 0, 0)]
    everyone = [(0, 0, 0.5), (1, 1, 0.5), (0, 0, 0.5), (0, 0, 0.5)]
    expect_asked(
        [*adds, ("update", 0.5)],
        everyone,
        cause="This pair was added more than once, and every call to add registers another pair. "
        "Until remove is called, all of them must act.",
    )
    about.call = "added p[0] with generator[0] three times, and p[1] with generator[1]; "
    about.call += "registry.remove(p[0], generator[0]); calls of update_force, sorted"
    got = sorted(asked((), [*adds, ("remove", 0, 0), ("update", 0.5)]))
    wanted = [(0, 0, 0.5), (0, 0, 0.5), (1, 1, 0.5)]
    expect_exactly([*map(tuple, got)], wanted)
    acts = [*adds, *[("remove", 0, 0)] * 3, ("update", 0.5)]
    expect_asked(acts, [(1, 1, 0.5)], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_remove_looks_for_both_the_particle_and_the_generator() -> None:
    about.read = "the docstring of remove"
    about.cause = "Two different generators can be equal, so == doesn't tell them apart. Compare "
    about.cause += "with `is`, and remove the pair whose particle and generator are the very "
    about.cause += "objects that were passed in."
    pairs = [("add", 0, 0), ("add", 0, 1), ("add", 1, 0), ("add", 1, 1)]
    everyone = [(0, 0, 0.5), (0, 1, 0.5), (1, 0, 0.5), (1, 1, 0.5)]
    for i, (_, particle, generator) in enumerate(pairs):
        acts = [*pairs, ("remove", particle, generator), ("update", 0.5)]
        expect_asked(acts, everyone[:i] + everyone[i + 1 :], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_remove_of_what_is_absent_changes_nothing() -> None:
    about.read = "the docstring of remove"
    about.cause = "This pair is not registered, so remove must do nothing. Don't raise an error, "
    acts = [("remove", 0, 0), ("add", 0, 1), ("add", 1, 0), ("remove", 0, 0), ("update", 0.5)]
    expect_asked(acts, [(0, 1, 0.5), (1, 0, 0.5)], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_clear_takes_back_everything() -> None:
    about.read = "the docstring of clear"
    about.cause = "clear must remove all pairs. After that, only pairs that are added later may "
    about.cause += "act."
    acts = [("add", 0, 0), ("add", 1, 1), ("update", 0.5), ("clear",), ("update", 0.5)]
    acts += [("clear",), ("add", 2, 1), ("update", 0.25)]
    expect_asked(acts, [(0, 0, 0.5), (1, 1, 0.5), (2, 1, 0.25)], cause=about.cause)


@pytest.mark.exercise("B5.3")
def test_immovable_particles_are_skipped() -> None:
    about.read = "the docstring of update_forces"
    about.cause = "No force can move a particle whose inverse mass is 0, so skip its pair in "
    about.cause += "update_forces. Keep the pair, because the particle may become movable later."
    acts = [("add", 0, 0), ("add", 1, 0), ("add", 1, 1), ("add", 2, 0), ("update", 0.5)]
    wanted = [(0, 0, 0.5), (2, 0, 0.5)]
    slips = {
        "Your loop stopped at the immovable particle. Skip only this pair, and continue with the "
        "next one.": wanted[:1]
    }
    expect_asked(acts, wanted, cause=about.cause, immovable=(1,), slips=slips)
    about.cause = "This particle used to be immovable, but it can move now. Check its inverse mass "
    about.cause += "in every update."
    acts = [("add", 1, 2), ("add", 0, 2), ("update", 0.5), ("free", 1), ("update", 0.5)]
    wanted = [(0, 2, 0.5), (1, 2, 0.5), (0, 2, 0.5)]
    expect_asked(acts, wanted, cause=about.cause, immovable=(1,))


@pytest.mark.exercise("B5.3")
def test_an_update_adds_to_the_forces_that_are_there(rng: Random) -> None:
    by_hand, first, second = components(rng), components(rng), components(rng)
    about.call = f"p.add_force(Vector3{by_hand}); generators push with {first} and {second}; "
    about.call += "registry.update_forces(0.5); p.force_accumulator"
    about(
        cause="The sum must contain the forces of both generators and the one that was added by "
        "hand. Don't clear the forces in update_forces, because only a step does that.",
        read="book 5.2.2",
    )
    before, after, emptied = gathered(by_hand, [first, second])
    wanted = tuple(by_hand[i] + first[i] + second[i] for i in range(3))
    # Two roundings of numbers up to 30.
    expect_close(after, wanted, tolerance=1e-13)
    about.cause = "The force on the particle has changed. add, remove and clear must change only "
    about.cause += "the registry, not the forces."
    name = f"p.add_force(Vector3{by_hand}); p in registry.add(); p.force_accumulator"
    expect_close(before, by_hand, call=name, read="the docstring of add")
    about.read = "the docstring of clear"
    expect_close(emptied, wanted, then=", after registry.clear()", tolerance=1e-13)


@pytest.mark.exercise("B5.3")
def test_a_generator_may_change_the_registry_meanwhile() -> None:
    about.read = "the docstring of update_forces"
    about.cause = "A generator added or removed pairs during the update. Such changes must not "
    about.cause += "take effect until the next update, so loop over a copy of the list."
    for what, second in (("remove", 2), ("add", 4), ("remove the second", 2), ("clear", 0)):
        about.call = f"three pairs, the first generator changes the registry ({what}); "
        about.call += "registry.update_forces(0.5) twice; number of generators called in each"
        got = asked_while_it_changes(what)
        expect_exactly(got, [3, second])


@pytest.mark.exercise("B5.3")
@pytest.mark.robust
@pytest.mark.parametrize("duration", [0.0, -0.5, math.inf, math.nan, "0.5"])
def test_an_update_takes_a_positive_and_finite_duration(duration: float) -> None:
    about(f"registry.update_forces({duration!r})", read="the docstring of update_forces")
    about.cause = "The duration must be a positive, finite number. Check it first, with positive "
    about.cause += "from arguments.py, which raises both errors for you."
    expect_error(
        lambda: ForceRegistry().update_forces(duration),
        TypeError if isinstance(duration, str) else ValueError,
        allowed=lambda: ForceRegistry().update_forces(0.5),
    )
    for immovable in (False, True):
        got = asked_after_a_refusal(duration, immovable)
        about.cause = "The duration was rejected, but a generator had already been called. Check "
        about.cause += "the duration before you call any generator."
        then = " with one pair, then registry.update_forces(0.5); number of generators called"
        expect_exactly(got, 1, then=then)


@pytest.mark.exercise("B5.3")
@pytest.mark.robust
def test_what_a_generator_raises_comes_out() -> None:
    about.call = "a generator raises ArithmeticError; registry.update_forces(0.5)"
    about.cause = "An error raised in a generator must reach the caller, so don't catch it in "
    about.cause += "update_forces."
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
        about.cause = "registry.add must check its arguments. Raise TypeError if the particle has "
        about.cause += "no add_force or the generator has no update_force."
        expect_error(attempt, TypeError, allowed=lambda: other.add(p, gravity))
        about.cause = "The call raised an error, but it registered the pair anyway. Check both "
        about.cause += "arguments before you append the pair."
        about.call += ", which is refused; registry.update_forces(0.5)"
        came = "no error"
        try:
            registry.update_forces(0.5)
        except AttributeError as error:  # what was refused has no method, or no inverse mass
            came = str(error)
        expect_exactly(came, "no error")
