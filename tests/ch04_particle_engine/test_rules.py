"""Rules without an end, B4.7, and two types of one's own, mini-project 4.2."""

from __future__ import annotations

from random import Random

import pytest

from ch04_particle_engine import probes
from expect import expect_exactly


def words(leaves: dict[int, list[int]]) -> str:
    """Return the call for rules, each given by the types that it leaves behind."""
    shown = [f"{type} leaves {after or 'none'}" for type, after in leaves.items()]
    more = f" and {len(shown) - 6} more" if len(shown) > 6 else ""
    return f"endless_types(rules), where {'; '.join(shown[:6])}{more}"


@pytest.mark.exercise("B4.7")
def test_rules_that_end_have_no_endless_types() -> None:
    cause = (
        "every way down ends at a type without payloads. Is a type counted as reached before "
        "anything leads to it?"
    )
    read = "the docstring of endless_types"
    for leaves in (
        {1: []},
        {1: [2], 2: [3], 3: []},
        {1: [2, 3], 2: [4], 3: [4], 4: []},  # met twice, but never comes back
        {4: [], 3: [4], 2: [4], 1: [3, 2]},
    ):
        call = words(leaves)
        expect_exactly(call, probes.endless(leaves), [], cause=cause, read=read)


@pytest.mark.exercise("B4.7")
def test_a_type_that_leaves_its_own_is_endless(rng: Random) -> None:
    type = rng.randrange(2, 9)
    leaves = {1: [], type: [1, type]}
    call = words(leaves)
    cause = "it leads back to itself at once"
    read = "the docstring of endless_types"
    expect_exactly(call, probes.endless(leaves), [type], cause=cause, read=read)


@pytest.mark.exercise("B4.7")
def test_types_that_lead_round_in_a_ring_are_all_endless(rng: Random) -> None:
    read = "the docstring of endless_types"
    ring = rng.sample(range(1, 90), 40)
    for leaves, wanted, cause in (
        ({2: [1], 1: [2]}, [1, 2], "1 leads to 2 and 2 to 1: both, in ascending order"),
        (
            {9: [1], 1: [2, 3], 2: [3], 3: [1], 4: [9], 5: []},
            [1, 2, 3],
            "9 and 4 lead into the ring, but nothing comes back to them",
        ),
        ({1: [2], 2: [1], 3: [4], 4: [3], 5: [1, 3]}, [1, 2, 3, 4], "there are two rings"),
        (
            {type: [ring[(i + 1) % 40]] for i, type in enumerate(ring)},
            sorted(ring),
            "each of the 40 leads back to itself by way of the others; in ascending order",
        ),
    ):
        call = words(leaves)
        expect_exactly(call, probes.endless(leaves), wanted, cause=cause, read=read)


@pytest.mark.exercise("B4.7")
def test_many_ways_to_the_same_types_are_not_followed_one_by_one() -> None:
    call = "endless_types(rules), 62 types, of which each leaves two of the next pair"
    cause = (
        "there are 2^30 ways down: remember the types that have been reached, and do not look at "
        "one again"
    )
    read = "the docstring of endless_types"
    leaves = {i: [i + 2 - i % 2, i + 3 - i % 2] for i in range(60)}
    leaves |= {60: [], 61: []}
    expect_exactly(call, probes.endless(leaves), [], cause=cause, read=read)


# 4.2 Two types of your own

READ = "the docstring of own_types; book 4.2.1"


@pytest.mark.exercise("4.2")
def test_your_types_are_10_and_11_and_one_leaves_something_behind() -> None:
    call = "own_types(), their types"
    cause = "two rules, with the types 10 and 11"
    read = READ
    rules = probes.own_rules()
    numbers = sorted(rule[0] for rule in rules)
    expect_exactly(call, numbers, [10, 11], cause=cause, read=read)
    call = "own_types(), types of their payloads"
    cause = "give one of them a payload"
    left = [type for rule in rules for type, _ in rule[-1]]
    expect_exactly(f"{call}, any at all", len(left) > 0, True, cause=cause, read=read)
    cause = "a payload is of a type that has a rule: 1 to 11"
    unknown = [type for type in left if not 1 <= type <= 11]
    expect_exactly(f"{call}, others than 1 to 11", unknown, [], cause=cause, read=read)


@pytest.mark.exercise("4.2")
def test_your_types_are_like_no_other() -> None:
    call = "own_types() and FIREWORK_TYPES, rules that differ in nothing but their type"
    cause = "a copy with another number is no type of your own: change ages, flight or payload"
    read = READ
    own, nine = probes.own_rules(), probes.nine_rules()
    expect_exactly("own_types(), how many", len(own), 2, cause=cause, read=read)
    all_of = [*own, *nine]
    same = [
        (own[i][0], all_of[j][0])
        for i in range(2)
        for j in range(i + 1, len(all_of))
        if own[i][1:] == all_of[j][1:]
    ]
    expect_exactly(call, same, [], cause=cause, read=read)


@pytest.mark.exercise("4.2")
def test_your_types_burn_and_come_to_an_end() -> None:
    # Always the same show: that fuses of one's own are short enough must not be luck.
    seed = 5
    read = READ
    for type in (10, 11):
        call = f"own_types(), a show of all eleven with the seed {seed}; type {type} is lit 50 m "
        call += "up; show.update(0.05) 800 times; how many burn"
        counts = probes.own_show(type, seed, 0.05, 800)
        cause = "each type burns for 0.1 s at least, whatever is drawn: a smallest age of 0.1 s"
        (least,) = (rule[1] for rule in probes.own_rules() if rule[0] == type)
        name = f"own_types(), the smallest age of type {type}, less than 0.1 s"
        expect_exactly(name, least < 0.1, False, cause=cause, read=read)
        expect_exactly(f"{call}, any after 0.05 s", counts[0] > 0, True, cause=cause, read=read)
        cause = "after 40 s it is dark: fuses are too long, or a type leads back to itself"
        expect_exactly(f"{call}, after 40 s", counts[-1], 0, cause=cause, read=read)
