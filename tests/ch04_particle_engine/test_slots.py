"""The slots of a show, and what happens when they are full, build task B4.5."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import probes
from draw import components
from expect import about, expect_close, expect_error, expect_exactly, expect_that

# The book's first rule, without its payload.
FIRST: probes.RuleData = (
    1, 0.5, 1.4, (-5.0, 25.0, -5.0), (5.0, 28.0, 5.0), 0.1, ()
)  # fmt: skip


def simple(type: int, *payloads: tuple[int, int]) -> probes.RuleData:
    """Return a rule without randomness: 2 s, straight up."""
    return (type, 2.0, 2.0, (0.0, 9.0, 0.0), (0.0, 9.0, 0.0), 1.0, payloads)


def show(capacity: int, when_full: str, types: int = 4) -> Any:
    """Return a show with rules of the types 1 to 4 without payloads."""
    rules = [simple(type) for type in range(1, types + 1)]
    return probes.show_of(rules, capacity, when_full, 1)


def burning(a_show: Any) -> list[int]:
    """Return the types that burn, oldest first."""
    return [firework.type for firework in a_show.fireworks]


@pytest.mark.exercise("B4.5", asks="Light one firework of the type")
def test_a_launch_lights_one_firework_on_the_ground(rng: Random) -> None:
    type = rng.randrange(1, 5)
    about.call = f"a show with 9 slots; show.launch({type}); the types of show.fireworks"
    about(
        cause="Your launch does not light exactly one firework of the given type. Call light "
        "with a single item: that type, a count of 1 and None as the parent.",
        read="the docstring of launch",
    )
    a_show = show(9, "keep_old")
    try:
        a_show.launch(type)
    except (TypeError, ValueError) as error:
        if "unpack" in str(error):
            about.cause = (
                "light takes a list of tuples. Put your tuple into a list: [(type, 1, None)]."
            )
        if "NoneType" in str(error):
            about.cause = (
                "Each tuple in births contains (type, count, parent), in this order. Here the "
                "parent is None. Check the order in which light unpacks the tuples."
            )
        raise
    if len(burning(a_show)) > 1:
        about.cause = about.cause.replace("does not light exactly", "lights more than")
    expect_exactly(burning(a_show), [type])
    about.call = (
        f"show.launch({type}), called 80 times; the different positions (x, y) at which fireworks "
        "start"
    )
    about.cause = (
        "A launched firework has no parent, so make_firework must choose one of the three "
        "LAUNCH_PLACES for it. Pass None as the parent."
    )
    places = probes.places_of_launches(simple(type), type, 80)
    if len(places) == 1:
        about.cause = (
            "All fireworks start at the same position. Pass self.random to make_firework without "
            "seeding it again, and pass None as the parent."
        )
    wanted = [(-5.0, 0.0), (0.0, 0.0), (5.0, 0.0)]
    expect_exactly(places, wanted)


@pytest.mark.exercise("B4.5", asks="in the order in which they were lit")
def test_launched_fireworks_burn_in_the_order_of_their_launches(rng: Random) -> None:
    order = rng.sample([1, 2, 3, 4], 4)
    about.call = (
        f"a show with 9 slots; fireworks of types {', '.join(map(str, order))} are launched in "
        "this order"
    )
    about.read = "the docstrings of FireworksShow and launch"
    for when_full in ("keep_old", "drop_oldest"):
        about.cause = "Append each new firework to the end of the list, so that the oldest one "
        about.cause += "comes first and the newest one last."
        a_show = show(9, when_full)
        for type in order:
            a_show.launch(type)
        if burning(a_show) == order[::-1]:
            about.cause = (
                "You add new fireworks at the front of the list. Append each new firework to the "
                "end, so that the oldest one comes first."
            )
        expect_exactly(burning(a_show), order, then="; the types of show.fireworks")
        nobody = "Every firework found a free slot, so none was dropped. Leave dropped at 0."
        expect_exactly(a_show.dropped, 0, then="; show.dropped", cause=nobody)


@pytest.mark.exercise("B4.5", asks="no new fireworks are lit")
def test_keep_old_lights_none_when_all_slots_are_taken() -> None:
    about.call = (
        'a show with 3 slots and the policy "keep_old"; fireworks of types 1, 2, 3, 4 and 1 are '
        "launched in this order"
    )
    about.cause = (
        "With keep_old, burning fireworks keep their slots, as in the book's text (E-20). If all "
        "slots are taken, don't light a new firework."
    )
    about.read = "the docstring of FireworksShow; errata.md"
    a_show = show(3, "keep_old")
    for type in (1, 2, 3, 4, 1):
        a_show.launch(type)
    lit = burning(a_show)
    if len(lit) == 3 and 4 in lit:
        about.cause = (
            "You remove the oldest fireworks, as in the book's listing (E-20). With keep_old they "
            "keep their slots, so don't light a new firework if all slots are taken."
        )
    if len(lit) == 2:
        about.cause = "You leave one slot empty. A show may have as many fireworks as its capacity."
    if len(lit) > 3:
        about.cause = (
            "More fireworks burn than the show has slots. Check in light how much room there is, "
            "and let launch call light."
        )
    expect_exactly(lit, [1, 2, 3], then="; the types of show.fireworks")
    about.cause = (
        "You don't count the last two fireworks, which found no free slot. Add them to dropped."
    )
    if a_show.dropped == 1:
        about.cause = (
            "You count only the last firework. Each call of light must add to dropped instead of "
            "replacing it."
        )
    expect_exactly(a_show.dropped, 2, then="; show.dropped")


@pytest.mark.exercise("B4.5", asks="the oldest fireworks are put out to make room")
def test_drop_oldest_puts_out_the_oldest() -> None:
    about.call = (
        'a show with 3 slots and the policy "drop_oldest"; fireworks of types 1, 2, 3, 4 and 1 are '
        "launched in this order"
    )
    about.cause = (
        "If all slots are taken, drop_oldest must put out the oldest firework to make room for a "
        "new one, as in the book's listing (E-20)."
    )
    about.read = "the docstring of FireworksShow; errata.md"
    a_show = show(3, "drop_oldest")
    for type in (1, 2, 3, 4, 1):
        a_show.launch(type)
    if burning(a_show)[:3] == [1, 2, 3]:
        about.cause = (
            "You keep the oldest fireworks when all slots are taken. With drop_oldest, put out the "
            "oldest firework to make room for a new one (E-20). If you do this, check the spelling "
            'of the name, self.when_full == "drop_oldest", and light new fireworks even if no slot '
            "is free."
        )
    expect_exactly(burning(a_show), [3, 4, 1], then="; the types of show.fireworks")
    about.cause = (
        "You don't count the two oldest fireworks, which were put out to make room. Add them to "
        "dropped."
    )
    expect_exactly(a_show.dropped, 2, then="; show.dropped")


@pytest.mark.exercise("B4.5", asks="lights only as many as fit")
@pytest.mark.parametrize(
    ("when_full", "wanted", "cause"),
    [
        (
            "keep_old",
            [1, 2, 2, 3],
            "One of the 4 slots is taken, so there is room for three new fireworks. With "
            "keep_old, light only the first three new fireworks.",
        ),
        (
            "drop_oldest",
            [3, 3, 3, 4],
            "There are 4 slots for 8 fireworks. With drop_oldest, only the four newest fireworks "
            "may burn in the end.",
        ),
    ],
)
def test_more_births_than_there_is_room_for(when_full: str, wanted: list[int], cause: str) -> None:
    about.cause = cause
    births = [(2, 2, None), (3, 4, None), (4, 1, None)]
    about.call = (
        f'a show with 4 slots and the policy "{when_full}"; show.launch(1); show.light({births})'
    )
    about.read = "the docstring of light"
    a_show = show(4, when_full)
    a_show.launch(1)
    a_show.light(births)
    lit = burning(a_show)
    if lit in ([1, 2, 3], [1, 2, 3, 4], [2, 3, 4]):
        about.cause = (
            "You light only one firework for each item of births. Light as many of them as its "
            "count says."
        )
    elif when_full == "drop_oldest" and lit == [2, 2, 3, 3]:
        about.cause = (
            "You light the first four of the new fireworks. With drop_oldest, only the last four "
            "may burn, so skip the first three of them."
        )
    elif when_full == "keep_old" and lit == [3, 3, 3, 4]:
        about.cause = (
            "You work out the room only once and use it for every item of births. The fireworks "
            "of each item leave less room for the next one."
        )
    expect_exactly(lit, wanted, then="; the types of show.fireworks")
    about.cause = (
        "Only 4 of the 8 fireworks burn in the end. Add the other 4 to dropped, whether you lit "
        "them first or not."
    )
    expect_exactly(a_show.dropped, 4, then="; show.dropped")


@pytest.mark.exercise("B4.5", asks="the new fireworks as tuples (type, count, parent)")
def test_births_have_their_own_parents(rng: Random) -> None:
    x, v = components(rng), components(rng)
    about.call = (
        f"parent = Particle(position=Vector3{x}, velocity=Vector3{v}); show.light([(1, 2, parent), "
        "(2, 1, None)])"
    )
    about(
        cause=(
            "For each item of births, light as many fireworks of its type as its count says. Keep "
            "the order of the items."
        ),
        read="the docstring of light",
    )
    a_show = show(9, "keep_old")
    a_show.light([(1, 2, Particle(Vector3(*x), Vector3(*v))), (2, 1, None)])
    expect_exactly(burning(a_show), [1, 1, 2], then="; the types of show.fireworks")
    about.cause = (
        "Your fireworks don't start at the position of their parent. Pass the parent, which is "
        "the third value of each tuple in births, to make_firework."
    )
    lit = a_show.fireworks
    places = [lit[i].particle.position for i in (0, 1, 2)]
    got = [n for place in places[:2] for n in (place.x, place.y)] + [places[2].y]
    wanted = [*x[:2], *x[:2], 0.0]
    name = "; (x1, y1, x2, y2, y3), the coordinates of the three fireworks in order"
    expect_close(got, wanted, then=name, unit="m")
    places[0].x = 99.0
    about.cause = (
        "You add the same firework to the list twice. Call make_firework once for each new "
        "firework."
    )
    expect_close(
        places[1].x,
        x[0],
        then="; show.fireworks[0].particle.position.x = 99; show.fireworks[1].particle.position.x",
    )
    about.call = (
        "a show with 4 slots; births = [(1, 2, None), (2, 3, None)]; show.light(births); births"
    )
    about.cause = (
        "Your light changes the list of births, which belongs to the caller. Only read the list, "
        "or work on a copy."
    )
    for when_full in ("keep_old", "drop_oldest"):
        left = probes.births_after(simple(1), simple(2), when_full)
        expect_exactly(left, [(1, 2), (2, 3)])


@pytest.mark.exercise("B4.5", asks="never creates more fireworks than the capacity")
@pytest.mark.parametrize("when_full", ["keep_old", "drop_oldest"])
def test_light_creates_no_more_fireworks_than_the_capacity(when_full: str) -> None:
    about.call = (
        f'a show with 2000 slots and the policy "{when_full}"; show.light(births), with 500 births '
        "of type 1 and then 500 of type 2, each of 50 fireworks"
    )
    about.cause = (
        "You create fireworks that never get a slot. First work out how many fireworks will burn "
        "in the end, and then create only that many."
    )
    about.read = "the docstring of light"
    lit, dropped, made = probes.many_births(simple(1), simple(2), 2000, when_full, 1000, 50)
    name = "; the calls to make_firework beyond the 2000 that are needed"
    expect_exactly(max(0, made - 2000), 0, then=name)
    about.cause = (
        "The wrong fireworks burn. With keep_old, the first 2000 births get the slots. With "
        "drop_oldest, the last 2000 of them do."
    )
    wanted = [2000, 0] if when_full == "keep_old" else [0, 2000]
    expect_exactly(lit, wanted, then="; how many fireworks of type 1 and of type 2 burn")
    about.cause = (
        "Most of these fireworks find no free slot. Count all of those in dropped, even if you "
        "skip some items of births altogether."
    )
    expect_exactly(dropped, 1000 * 50 - 2000, then="; show.dropped")


@pytest.mark.exercise("B4.5", asks="seed always gives the same show")
def test_the_same_seed_launches_the_same_fireworks(rng: Random) -> None:
    seed = rng.randrange(10**6)
    rules = [FIRST]
    about.call = f"two shows with the seed {seed}; show.launch(1) three times in each"
    about.cause = (
        "Two shows with the same seed launched different fireworks. Draw all random numbers from "
        "self.random, which is created from the seed."
    )
    about.read = "the docstring of FireworksShow"
    runs = [probes.show_after(rules, [1, 1, 1], s, 0.01, 0) for s in (seed, seed, seed + 1)]
    expect_exactly(len(runs[0]), 3, then="; the number of fireworks in the first show")
    differ = sum(a != b for a, b in zip(runs[0], runs[1], strict=True))
    expect_exactly(differ, 0, then="; how many fireworks differ between the shows")
    about.cause = (
        "Two shows with different seeds launched the same fireworks. Draw all random numbers from "
        "self.random, which is created from the seed."
    )
    same = sum(a == b for a, b in zip(runs[0], runs[2], strict=True))
    about.call = (
        f"two shows with the seeds {seed} and {seed + 1}; show.launch(1) three times in each; how "
        "many fireworks are equal"
    )
    expect_exactly(same, 0)


@pytest.mark.exercise("B4.5", asks="In that case nothing is lit")
@pytest.mark.robust
def test_rejects_births_with_an_unknown_type_or_a_negative_count() -> None:
    about.call = "a show with rules for the types 1 to 4; show.launch(7)"
    about.cause = (
        "The show has no rule for type 7, so launch cannot light such a firework. Raise a "
        "ValueError that mentions the type."
    )
    about.read = "the docstring of launch"
    a_show = show(9, "keep_old")
    expect_error(
        lambda: a_show.launch(7), ValueError, allowed=lambda: show(9, "keep_old").launch(4)
    )
    expect_exactly(len(a_show.fireworks), 0, then="; the number of burning fireworks")
    first = (
        "You light the first item of births before you check the second one, which is not valid. "
        "Check all items before you light any fireworks."
    )
    for bad, births in (
        ("a type without a rule", [(1, 2, None), (7, 1, None)]),
        ("a negative count", [(1, 2, None), (2, -3, None)]),
        ("a negative count", [(1, 2, None), (2, -1, None)]),
    ):
        about.call = (
            f"a show with rules for the types 1 to 4; show.light({births}), where the second item "
            f"has {bad}"
        )
        about.cause = (
            f"The second item of births has {bad}. Raise ValueError before you light any fireworks."
        )
        expect_error(
            lambda births=births: a_show.light(births),
            ValueError,
            allowed=lambda: show(9, "keep_old").light([(4, 0, None), (4, 1, None)]),
            read="the docstring of light",
        )
        lit, dropped = len(a_show.fireworks), a_show.dropped
        got = f"{lit} burning fireworks, {dropped} dropped"
        none = "0 burning fireworks, 0 dropped"
        expect_that((lit, dropped) == (0, 0), got, none, then="; the state of show", cause=first)
