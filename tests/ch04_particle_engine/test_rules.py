"""Rules without an end, B4.7, and two types of your own, mini-project 4.2."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch04_particle_engine import probes
from expect import about, expect_between, expect_exactly


def words(leaves: dict[int, list[int]]) -> str:
    """Return the call in words, for rules that are given by the types of their payloads."""
    shown = [f"{type} leaves {after or 'none'}" for type, after in leaves.items()]
    more = f" and {len(shown) - 6} more" if len(shown) > 6 else ""
    return f"endless_types(rules), where {'; '.join(shown[:6])}{more}"


@pytest.mark.exercise("B4.7")
def test_rules_that_end_have_no_endless_types() -> None:
    about.read = "the docstring of endless_types"
    for leaves in (
        {1: []},
        {1: [2], 2: [3], 3: []},
        {1: [2, 3], 2: [4], 3: [4], 4: []},  # type 4 is reached twice but never leads back
        {4: [], 3: [4], 2: [4], 1: [3, 2]},
    ):
        about.call = words(leaves)
        about.cause = (
            "Every chain of payloads comes to an end here, so no type is endless. A type is "
            "endless only if its payloads lead back to that same type."
        )
        got = probes.endless(leaves)
        if got == [*leaves]:
            about.cause = (
                "You returned every type. A type counts as reached only if a payload leads to it, "
                "so don't mark the type that you start from."
            )
        elif got == [1]:
            about.cause = (
                "Type 1 leads to type 4 in two ways, through 2 and through 3, but nothing leads "
                "back to 1. Reaching a type twice doesn't make it endless, so compare each type "
                "with the one that you started from."
            )
        expect_exactly(got, [])


@pytest.mark.exercise("B4.7")
def test_a_type_that_leaves_its_own_is_endless(rng: Random) -> None:
    type = rng.randrange(2, 9)
    leaves = {1: [], type: [1, type]}
    about(
        words(leaves),
        cause="One type has itself as a payload, so it leads straight back to itself and is "
        "endless.",
    )
    about.read = "the docstring of endless_types"
    expect_exactly(probes.endless(leaves), [type])


@pytest.mark.exercise("B4.7")
def test_types_that_lead_round_in_a_ring_are_all_endless(rng: Random) -> None:
    about.read = "the docstring of endless_types"
    ring = rng.sample(range(1, 90), 40)
    for leaves, wanted, cause in (
        (
            {2: [1], 1: [2]},
            [1, 2],
            "Type 1 leads to type 2, and type 2 leads back to type 1, so "
            "both are endless. Return them in ascending order.",
        ),
        (
            {9: [1], 1: [2, 3], 2: [3], 3: [1], 4: [9], 5: []},
            [1, 2, 3],
            "Types 9 and 4 lead into a cycle, but nothing in the cycle leads back to them, so "
            "they are not endless.",
        ),
        (
            {1: [2], 2: [1], 3: [4], 4: [3], 5: [1, 3]},
            [1, 2, 3, 4],
            "There are two separate cycles here, and every type in them leads back to itself, so "
            "all four are endless.",
        ),
        (
            {type: [ring[(i + 1) % 40]] for i, type in enumerate(ring)},
            sorted(ring),
            "Each of the 40 types leads back to itself by way of all the others, so all of them "
            "are endless. Return them sorted.",
        ),
    ):
        about(words(leaves), cause=cause)
        expect_exactly(probes.endless(leaves), wanted)


@pytest.mark.exercise("B4.7")
def test_many_ways_to_the_same_types_are_not_followed_one_by_one() -> None:
    about.call = "endless_types(rules), 62 types, of which each leaves two of the next pair"
    about.cause = (
        "There are 2^30 paths through these rules, far too many to follow one by one. Keep a set "
        "of the types that you have already reached, and never visit a type twice."
    )
    about.read = "the docstring of endless_types"
    leaves = {i: [i + 2 - i % 2, i + 3 - i % 2] for i in range(60)}
    leaves |= {60: [], 61: []}
    expect_exactly(probes.endless(leaves), [])


# 4.2 Two types of your own

READ = "the docstring of own_types; book 4.2.1"


@pytest.mark.exercise("4.2")
def test_your_types_are_10_and_11_and_one_leaves_something_behind() -> None:
    about(
        "own_types(), their types",
        cause="Return two rules, one for type 10 and one for type 11.",
        read=READ,
    )
    rules = probes.own_rules()
    numbers = sorted(rule[0] for rule in rules)
    expect_exactly(numbers, [10, 11])
    about(
        "own_types(), types of their payloads",
        cause=(
            "At least one of your two types must light other fireworks when it burns out, so give "
            "it a payload."
        ),
    )
    left = [type for rule in rules for type, _ in rule[-1]]
    expect_exactly(len(left) > 0, True, then=", any at all")
    about.cause = "Every payload needs a type that has a rule, so use only types from 1 to 11."
    unknown = [type for type in left if not 1 <= type <= 11]
    expect_exactly(unknown, [], then=", others than 1 to 11")


@pytest.mark.exercise("4.2")
def test_your_types_are_like_no_other() -> None:
    about.call = "own_types() and FIREWORK_TYPES: pairs of rules that differ only in their type"
    about.cause = (
        "One rule is a copy of another with a new type. Change its ages, velocities or payloads, "
        "so that it behaves differently."
    )
    about.read = READ
    own, nine = probes.own_rules(), probes.nine_rules()
    expect_exactly(len(own), 2, call="own_types(), how many")
    all_of = [*own, *nine]
    same = [
        (own[i][0], all_of[j][0])
        for i in range(2)
        for j in range(i + 1, len(all_of))
        if own[i][1:] == all_of[j][1:]
    ]
    expect_exactly(same, [])


def own_endless_types() -> list[int]:
    """Return those of the student's own types that lead back to themselves."""
    leaves = {rule[0]: {type for type, _ in rule[-1]} for rule in probes.own_rules()}
    endless = []
    for type, other in ((10, 11), (11, 10)):
        after = leaves.get(type, set())
        if type in after or (other in after and type in leaves.get(other, set())):
            endless.append(type)
    return endless


@pytest.mark.exercise("4.2")
def test_your_types_burn_and_come_to_an_end() -> None:
    # The show is always the same, so that a type with short enough fuses never fails by chance.
    seed = 5
    about.read = READ
    about.call = "own_types(): the types that lead back to themselves by their payloads"
    about.cause = (
        "A type that leads back to itself would burn forever. Remove the payload that closes the "
        "circle."
    )
    expect_exactly(own_endless_types(), [])
    for type in (10, 11):
        about.call = (
            f"own_types(), a show of all eleven with the seed {seed}; type {type} is lit 50 m up; "
            "show.update(0.05) 800 times; how many burn"
        )
        counts = probes.own_show(type, seed, 0.05, 800)
        about.cause = (
            "Each of your types must burn for at least 0.1 s. Set its min_age to 0.1 or more."
        )
        (least,) = (rule[1] for rule in probes.own_rules() if rule[0] == type)
        expect_between(least, 0.1, math.inf, call=f"own_types(): min_age of type {type}")
        expect_between(counts[0], 1, math.inf, then=", after 0.05 s")
        about.cause = (
            "After 40 s, all fireworks must have burnt out, but some still burn. Lower max_age to "
            "shorten the fuses."
        )
        expect_exactly(counts[-1], 0, then=", after 40 s")
