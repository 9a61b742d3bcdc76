"""The show over many updates, build task B4.6."""

from __future__ import annotations

from random import Random

import pytest

from ch04_particle_engine import probes
from expect import about, expect_exactly

READ = "the docstring of update; book 4.2.3"
UP = (0.0, 9.0, 0.0)


@pytest.mark.exercise("B4.6", asks="is the number of fireworks")
def test_the_count_of_sparks_is_that_of_the_rules(rng: Random) -> None:
    many, about.read = rng.randrange(3, 7), READ
    rules = [
        (1, 0.5, 1.4, (-5.0, 25.0, -5.0), (5.0, 28.0, 5.0), 0.1, ((3, many), (5, 2))),
        (3, 0.5, 1.5, (-1.0, 5.0, -1.0), (1.0, 9.0, 1.0), 0.1, ((5, 3),)),
        (5, 4.5, 4.5, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.001, ()),
    ]
    about.call = (
        f"type 1 has payloads of {many} fireworks of type 3 and 2 of type 5; type 3 has a payload "
        "of 3 of type 5; show.launch(1) twice; show.update(0.05), called 80 times; how many "
        "of each type burn"
    )
    about.cause = (
        "The number of fireworks is wrong after several generations. Check that update lights "
        "each payload of a burned-out firework exactly once."
    )
    last = probes.show_after(rules, [1, 1], rng.randrange(10**6), 0.05, 80)
    types = [firework[0] for firework in last]
    got = {type: types.count(type) for type in (1, 3, 5)}
    wanted = {1: 0, 3: 0, 5: 2 * (2 + 3 * many)}
    expect_exactly(got, wanted)


@pytest.mark.exercise("B4.6", asks="even if their types light each other forever")
def test_rules_without_an_end_stay_within_the_capacity() -> None:
    rules = [(1, 0.1, 0.1, UP, UP, 1.0, ((1, 10),))]
    about.cause = (
        "Each firework lights ten others of its own type, so without a limit their number grows "
        "forever. Call self.light, which keeps it within the capacity."
    )
    about.read = "the docstring of FireworksShow"
    for when_full in ("keep_old", "drop_oldest"):
        about.call = (
            f'a show with 50 slots and the policy "{when_full}", where type 1 has a payload of 10 '
            "fireworks of type 1; show.launch(1); show.update(0.2), called 30 times"
        )
        seen = probes.sparks(rules, [1], 50, when_full, 1, 0.2, 30)
        counts = [len(types) for types in seen]
        most = max(counts)
        expect_exactly(most, 50, then="; the largest number of fireworks that burn at once")
        expect_exactly(
            counts[:3], [10, 50, 50], then="; how many burn after each of the first 3 updates"
        )


@pytest.mark.exercise("B4.6", asks="seed always gives the same show")
def test_a_show_is_the_same_whenever_its_seed_is(rng: Random) -> None:
    seed = rng.randrange(10**6)
    rules = [
        (1, 0.1, 0.4, (-5.0, 5.0, -5.0), (5.0, 8.0, 5.0), 0.1, ((3, 5),)),
        (3, 0.7, 2.5, (-5.0, 5.0, -5.0), (5.0, 9.0, 5.0), 0.1, ()),
    ]
    about.call = (
        f"two shows with the seed {seed}; in each, fireworks of types 1, 1 and 3 are launched; "
        "show.update(0.05), called 12 times"
    )
    about.cause = (
        "Two shows with the same seed differ. Draw all random numbers from self.random, and "
        "always in the same order."
    )
    about.read = "the docstring of FireworksShow"
    once, again, other = (
        probes.show_after(rules, [1, 1, 3], s, 0.05, 12) for s in (seed, seed, seed + 1)
    )
    many = len(once) > 0
    expect_exactly(many, True, then="; does anything still burn?")
    differ = abs(len(once) - len(again)) + sum(a != b for a, b in zip(once, again, strict=False))
    expect_exactly(differ, 0, then="; how many fireworks differ between the shows")
    about.cause = (
        "Two shows with different seeds have equal fireworks. Draw all random numbers from "
        "self.random, which is created from the seed."
    )
    same = sum(firework in once for firework in other)
    about.call = (
        f"two shows with the seeds {seed} and {seed + 1}, run in the same way; how many fireworks "
        "are equal"
    )
    expect_exactly(same, 0)
