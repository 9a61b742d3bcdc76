"""Rules without an end, B4.7, and two types of your own, mini-project 4.2."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from calls import calls
from ch04_particle_engine import probes
from expect import expect_between, expect_exactly, expect_that

READ = "the docstring of endless_types"
OWN = "the docstring of own_types; book 4.2.2"
ROUND = "Your search goes round the cycle without end. Remember which types you have visited."


def words(leaves: dict[int, list[int]]) -> str:
    """Return the call in words, for rules that are given by the types of their payloads."""
    nouns = ("nothing", "type ", "types ")
    shown = [
        f"type {type} lights {nouns[min(len(after), 2)]}{' and '.join(map(str, after))}"
        for type, after in leaves.items()
    ]
    if len(shown) > 6:
        shown[6:] = [f"so on for {len(shown) - 6} more types"]
    *first, last = shown
    start = f"{', '.join(first)}{',' if len(first) > 1 else ''} and " if first else ""
    return f"rules in which {start}{last}; endless_types(rules)"


@pytest.mark.exercise("B4.7", asks="the types of firework that light themselves again", read=READ)
def test_rules_that_end_have_no_endless_types() -> None:
    for leaves in (
        {1: []},
        {1: [2], 2: [3], 3: []},
        {1: [2, 3], 2: [4], 3: [4], 4: []},  # type 4 is reached twice but never leads back
        {4: [], 3: [4], 2: [4], 1: [3, 2]},
    ):
        cause = "No type is endless here, because each chain ends. Return an empty list."
        with calls(cause, words(leaves)):
            got = probes.endless(leaves)
        if isinstance(got, str):
            cause = "Your search never ends, although every chain does. Check when your loop stops."
        elif not isinstance(got, list):
            cause = "Return a list of the types in ascending order. It is empty here."
        elif got == [*leaves]:
            cause = "You return every type. Mark the start only if a payload leads back to it."
        elif got == [1]:
            cause = "Type 1 reaches type 4 twice but never itself, so it is not endless."
        expect_exactly(got, [], cause=cause)


def why_wrong(got: Any, wanted: list[int], cause: str) -> str:
    """Return why these are not the types that lead back to themselves."""
    if isinstance(got, str):
        return ROUND
    if not isinstance(got, list):
        return cause
    if not got:
        return "Follow the payloads until they lead back to the start or no new types are left."
    if not all(isinstance(type, int) for type in got):
        return "Return the numbers of the types, such as rule.type, not the rules."
    if got != wanted and {*got} == {*wanted}:
        return "You don't sort the types. Return them in ascending order."
    if all(type in wanted for type in got):
        missed = " and ".join(f"type {type}" for type in wanted if type not in got)
        return (
            f"You miss {missed if len(wanted) < 9 else 'some types'}. From each type, follow the "
            "payloads as far as they lead, and see whether you come back to it."
        )
    return cause


@pytest.mark.exercise("B4.7", asks="light themselves again, directly", read=READ)
def test_a_type_that_lights_itself_is_endless(rng: Random) -> None:
    type = rng.randrange(2, 9)
    cause = f"Type {type} lights itself, so it is endless. Include it in the result."
    with calls(cause, words({1: [], type: [1, type]})):
        got = probes.endless({1: [], type: [1, type]})
    expect_exactly(got, [type], cause=why_wrong(got, [type], cause) if got else cause)


@pytest.mark.exercise("B4.7", asks="Return the types in ascending order", read=READ)
def test_all_types_of_a_cycle_are_endless(rng: Random) -> None:
    ring = rng.sample(range(1, 90), 40)
    for leaves, wanted, cause in (
        ({2: [1], 1: [2]}, [1, 2],
         "Types 1 and 2 light each other, so both are endless. Return both, in ascending order."),
        ({9: [1], 1: [2, 3], 2: [3], 3: [1], 4: [9], 5: []}, [1, 2, 3],
         "Types 1, 2 and 3 form a cycle. Types 4 and 9 only lead into this cycle, and nothing in "
         "it leads back to them, so leave them out."),
        ({1: [2], 2: [2, 3], 3: []}, [2],
         "Type 2 lights itself. Type 1 only leads to type 2, so leave it out."),
        ({1: [2], 2: [1], 3: [4], 4: [3], 5: [1, 3]}, [1, 2, 3, 4],
         "Types 1 and 2 form one cycle, and types 3 and 4 form another, so all four lead back to "
         "themselves. Type 5 only leads into both cycles."),
        ({type: [ring[(i + 1) % 40]] for i, type in enumerate(ring)}, sorted(ring),
         "The 40 types form one long cycle, so each type leads back to itself through all the "
         "others. Return all of them, in ascending order."),
    ):  # fmt: skip
        with calls(cause, words(leaves)):
            got = probes.endless(leaves)
        expect_exactly(got, wanted, cause=why_wrong(got, wanted, cause))


@pytest.mark.exercise("B4.7", asks="remember which types you have visited", read=READ)
def test_many_ways_to_the_same_types_are_not_followed_one_by_one() -> None:
    """Code that follows every path passes the other checks, but would need hours for this one."""
    leaves = {i: [i + 2 - i % 2, i + 3 - i % 2] for i in range(60)} | {60: [], 61: []}
    with calls(
        "There are 2^30 different paths through these rules, which is too many to follow one by "
        "one. Remember which types you have already reached, and skip them.",
        "31 pairs of types, each of which lights both types of the next pair; endless_types(rules)",
    ):
        got = probes.endless(leaves)
    expect_exactly(got, [])


# 4.2 Two types of your own


@pytest.mark.exercise("4.2", asks="must have payloads, of types 1 to 11", read=OWN)
def test_your_types_are_10_and_11_and_one_has_a_payload() -> None:
    with calls(
        "Return a list of exactly two rules, one for type 10 and one for type 11.",
        "own_types(); the types of the rules that it returns",
    ):
        rules = probes.own_rules()
    expect_exactly(sorted(rule[0] for rule in rules), [10, 11])
    left = [type for rule in rules for type, _ in rule[-1]]
    with calls(
        "Neither of your two types has a payload. At least one of them must light other fireworks "
        "when it burns out, so add a payload to its rule.",
        "own_types(); the payloads of its two rules",
    ):
        expect_that(len(left) > 0, "no payload", "at least one payload")
    unknown, then = [type for type in left if not 1 <= type <= 11], " whose types are not 1 to 11"
    without = "One of your payloads has a type without a rule. Use only types from 1 to 11."
    expect_exactly(unknown, [], then=then, cause=without)


@pytest.mark.exercise("4.2", asks="The two rules must differ from each other", read=OWN)
def test_your_types_differ_from_all_others() -> None:
    change = "Also change its ages, velocities, damping or payloads."
    cause = f"One of your rules is a copy of another rule with a different type. {change}"
    with calls(
        cause,
        "the two rules of own_types() and the nine in FIREWORK_TYPES; the pairs of types whose "
        "rules are equal except for the type",
    ):
        own, nine = probes.own_rules(), probes.nine_rules()
    expect_exactly(len(own), 2, call="own_types(); the number of rules")
    all_of = [*own, *nine]
    same = [
        (own[i][0], all_of[j][0])
        for i in range(2)
        for j in range(i + 1, len(all_of))
        if own[i][1:] == all_of[j][1:]
    ]
    for type, copied in same[:1]:
        cause = f"Your rule for type {type} is a copy of the rule for type {copied}. {change}"
    expect_exactly(same, [], cause=cause)


@pytest.mark.exercise("4.2", asks="comes from it must burn out within 40 s", read=OWN)
def test_your_types_burn_and_come_to_an_end() -> None:
    with calls(
        "Your types lead back to themselves through their payloads, so a show with them never "
        "ends. Remove a payload to break the cycle.",
        "own_types(); the types whose payloads lead back to the same type",
    ):
        rules = probes.own_rules()
    leaves = {rule[0]: {type for type, _ in rule[-1]} for rule in rules}
    lights = {type: leaves.get(type, set()) for type in (10, 11)}
    both = 11 in lights[10] and 10 in lights[11]
    expect_exactly([type for type in (10, 11) if both or type in lights[type]], [])
    for type in (10, 11):
        # The show is always the same, so that a type with short enough fuses never fails by chance.
        with calls(
            f"Your fireworks of type {type} don't always burn for at least 0.1 s. Set min_age to "
            "0.1 or more in their rule.",
            f"a show with all eleven types and the seed 5; one firework of type {type} is lit at a "
            "height of 50 m; show.update(0.05), called 800 times; the number of fireworks",
        ):
            counts = probes.own_show(type, 5, 0.05, 800)
        (least,) = (rule[1] for rule in rules if rule[0] == type)
        expect_between(least, 0.1, math.inf, call=f"own_types(); min_age of type {type}", unit="s")
        expect_between(counts[0], 1, math.inf, then=", after 0.05 s")
        sooner = "Some fireworks still burn after 40 s. Lower max_age in your rules."
        expect_exactly(counts[-1], 0, then=", after 40 s", cause=sooner)
