"""The slots of a show, and what happens when they are full, build task B4.5."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine import probes
from ch04_particle_engine.probes import FIRST, fixed, types
from draw import vector
from expect import about, expect_close, expect_error, expect_exactly, expect_that, named

SHOW = "the docstring of FireworksShow"
LIGHT, LAUNCH = "the docstring of light", "the docstring of launch"
TYPES, DROPPED = "; the types of show.fireworks", "; show.dropped"


def launched(capacity: int, when_full: str, *order: int) -> Any:
    """Return a show with rules of types 1 to 4 without payloads, in which these were launched."""
    show = probes.show_of([fixed(type, 2.0) for type in (1, 2, 3, 4)], capacity, when_full, 1)
    for type in order:
        show.launch(type)
    return show


@pytest.mark.exercise("B4.5", asks="Light one firework of the type", read=LAUNCH)
def test_a_launch_lights_one_firework_on_the_ground(rng: Random) -> None:
    type = rng.randrange(1, 5)
    with calls(
        "Your launch does not light exactly one firework of the given type. Call light with a "
        "single item: that type, a count of 1 and None as the parent.",
        f"a show with 9 slots; show.launch({type}); the types of show.fireworks",
    ):
        show = launched(9, "keep_old")
        try:
            show.launch(type)
        except (TypeError, ValueError) as error:
            if "unpack" in str(error):
                why = "light takes a list of tuples. Put your tuple into a list: [(type, 1, None)]."
                about(cause=why)
            if "NoneType" in str(error):
                about(
                    cause="Each tuple in births contains (type, count, parent), in this order. "
                    "Here the parent is None. Check the order in which light unpacks the tuples."
                )
            raise
    if len(types(show)) > 1:
        about(cause=about.cause.replace("does not light exactly", "lights more than"))
    expect_exactly(types(show), [type])
    with calls(
        "A launched firework has no parent, so make_firework must choose one of the three "
        "LAUNCH_PLACES for it. Pass None as the parent.",
        f"show.launch({type}) 80 times; the different positions (x, y) at which fireworks start",
    ):
        lit = probes.played([fixed(type, 2.0)], [type] * 80, 1.0, 0)[1]
    places = sorted({tuple(position[:2]) for _, _, position, _ in lit})
    if len(places) == 1:
        about(
            cause="All fireworks start at the same position. Pass self.random to make_firework "
            "without seeding it again, and pass None as the parent."
        )
    expect_exactly(places, [(-5.0, 0.0), (0.0, 0.0), (5.0, 0.0)])


@pytest.mark.exercise(
    "B4.5",
    asks="in the order in which they were lit",
    read="the docstrings of FireworksShow and launch",
)
def test_launched_fireworks_burn_in_the_order_of_their_launches(rng: Random) -> None:
    order = rng.sample([1, 2, 3, 4], 4)
    cause = "Append each new firework to the end of the list, so that the oldest one comes first."
    for when_full in ("keep_old", "drop_oldest"):
        with calls(
            cause,
            f"a show with 9 slots; launches of types {', '.join(map(str, order))} in this order",
        ):
            show = launched(9, when_full, *order)
        slips = {"You add new fireworks at the front of the list.": order[::-1]}
        expect_exactly(types(show), order, then=TYPES, cause=named(types(show), cause, slips))
        nobody = "Every firework found a free slot, so none was dropped. Leave dropped at 0."
        expect_exactly(show.dropped, 0, then=DROPPED, cause=nobody)


@pytest.mark.exercise("B4.5", asks="no new fireworks are lit", read=f"{SHOW}; docs/errata.md")
def test_keep_old_lights_none_when_all_slots_are_taken() -> None:
    with calls(
        "With keep_old, burning fireworks keep their slots, as in the book's text (E-20). If all "
        "slots are taken, don't light a new firework.",
        'a show with 3 slots and the policy "keep_old"; fireworks of types 1, 2, 3, 4 and 1 are '
        "launched in this order",
    ):
        show = launched(3, "keep_old", 1, 2, 3, 4, 1)
    slips = {
        "You remove the oldest fireworks, as in the book's listing (E-20). With keep_old they keep "
        "their slots, so don't light a new firework if all slots are taken.": [3, 4, 1],
        "You leave one slot empty. A show may have as many fireworks as its capacity.": [1, 2],
        "More fireworks burn than the show has slots. Check in light how much room there is, and "
        "let launch call light.": [1, 2, 3, 4, 1],
    }
    why = named(types(show), about.cause, slips)
    expect_exactly(types(show), [1, 2, 3], then=TYPES, cause=why)
    why = "You don't count the last two fireworks, which found no free slot. Add them to dropped."
    if show.dropped == 1:
        why = "Each call of light must add to dropped instead of replacing it."
    expect_exactly(show.dropped, 2, then=DROPPED, cause=why)


@pytest.mark.exercise(
    "B4.5", asks="the oldest fireworks are put out to make room", read=f"{SHOW}; docs/errata.md"
)
def test_drop_oldest_puts_out_the_oldest() -> None:
    with calls(
        "If all slots are taken, drop_oldest must put out the oldest firework to make room for a "
        "new one, as in the book's listing (E-20).",
        'a show with 3 slots and the policy "drop_oldest"; fireworks of types 1, 2, 3, 4 and 1 are '
        "launched in this order",
    ):
        show = launched(3, "drop_oldest", 1, 2, 3, 4, 1)
    kept = (
        "You keep the oldest fireworks when all slots are taken. With drop_oldest, put out the "
        "oldest firework to make room for a new one (E-20). If you do this, check the spelling of "
        'the name, self.when_full == "drop_oldest", and light new fireworks even if no slot is '
        "free."
    )
    why = kept if types(show)[:3] == [1, 2, 3] else about.cause
    expect_exactly(types(show), [3, 4, 1], then=TYPES, cause=why)
    why = "You don't count the two oldest fireworks, which were put out. Add them to dropped."
    expect_exactly(show.dropped, 2, then=DROPPED, cause=why)


@pytest.mark.exercise("B4.5", asks="lights only as many as fit", read=LIGHT)
@pytest.mark.parametrize("when_full", ["keep_old", "drop_oldest"])
def test_more_births_than_there_is_room_for(when_full: str) -> None:
    wanted, cause = {
        "keep_old": (
            [1, 2, 2, 3],
            "One of the 4 slots is taken. With keep_old, light only the first three new fireworks.",
        ),
        "drop_oldest": (
            [3, 3, 3, 4],
            "There are 4 slots for 8 fireworks. With drop_oldest, only the four newest may burn.",
        ),
    }[when_full]
    births = [(2, 2, None), (3, 4, None), (4, 1, None)]
    with calls(
        cause,
        f'a show with 4 slots and the policy "{when_full}"; show.launch(1); show.light({births})',
    ):
        show = launched(4, when_full, 1)
        show.light(births)
    slips = {
        "You light only one firework for each item of births. Light as many of them as its count "
        "says.": [1, 2, 3, 4],
        "You light the first four of the new fireworks. With drop_oldest, only the last four may "
        "burn, so skip the first three of them.": [2, 2, 3, 3],
        "You work out the room only once and use it for every item of births. The fireworks of "
        "each item leave less room for the next one.": [3, 3, 3, 4],
    }
    lit = types(show)
    expect_exactly(lit, wanted, then=TYPES, cause=named(lit, cause, slips))
    why = "Only 4 of the 8 fireworks burn in the end. Add the other 4 to dropped, lit or not."
    expect_exactly(show.dropped, 4, then=DROPPED, cause=why)


@pytest.mark.exercise("B4.5", asks="the new fireworks as tuples (type, count, parent)", read=LIGHT)
def test_births_have_their_own_parents(rng: Random) -> None:
    x, v = vector(rng), vector(rng)
    show = launched(9, "keep_old")
    with calls("Light as many fireworks of each type as its count says, in the order of births."):
        parent = Particle(position=Vector3(*x), velocity=Vector3(*v))
        show.light([(1, 2, parent), (2, 1, None)])
    expect_exactly(types(show), [1, 1, 2], then=TYPES)
    first, second, third = (firework.particle.position for firework in show.fireworks)
    expect_close(
        (first.x, first.y, second.x, second.y, third.y),
        (*x[:2], *x[:2], 0.0),
        then="; (x1, y1, x2, y2, y3), the coordinates of the three fireworks in order",
        unit="m",
        cause="Your fireworks don't start at the position of their parent. Pass the parent, which "
        "is the third value of each tuple in births, to make_firework.",
    )
    with calls(
        "You add the same firework to the list twice. Call make_firework once for each new "
        "firework.",
        "show.fireworks[0].particle.position.x = 99; show.fireworks[1].particle.position.x",
        more=True,
    ):
        first.x = 99.0
    expect_close(second.x, x[0])
    for when_full in ("keep_old", "drop_oldest"):
        with calls(
            "Your light changes the list of births, which belongs to the caller. Only read the "
            "list, or work on a copy.",
            "births = [(1, 2, None), (2, 3, None)]; show.light(births); births",
        ):
            left = probes.births_after(launched(4, when_full))
        expect_exactly(left, [(1, 2), (2, 3)])


@pytest.mark.exercise("B4.5", asks="never creates more fireworks than the capacity", read=LIGHT)
@pytest.mark.parametrize("when_full", ["keep_old", "drop_oldest"])
def test_light_creates_no_more_fireworks_than_the_capacity(when_full: str) -> None:
    with calls(
        "You create fireworks that never get a slot. First work out how many fireworks will burn "
        "in the end, and then create only that many.",
        f'a show with 2000 slots and the policy "{when_full}"; show.light(births), with 500 births '
        "of type 1 and then 500 of type 2, each of 50 fireworks",
    ):
        show = launched(2000, when_full)
        lit, made = probes.many_births(show, 1000, 50)
    name = "; the calls to make_firework beyond the 2000 that are needed"
    expect_exactly(max(0, made - 2000), 0, then=name)
    expect_exactly(
        [lit.count(1), lit.count(2)],
        [2000, 0] if when_full == "keep_old" else [0, 2000],
        then="; how many fireworks of type 1 and of type 2 burn",
        cause="The wrong fireworks burn. With keep_old, the first 2000 births get the slots. With "
        "drop_oldest, the last 2000 of them do.",
    )
    uncounted = "Count all fireworks that find no slot in dropped, even those of skipped births."
    expect_exactly(show.dropped, 1000 * 50 - 2000, then=DROPPED, cause=uncounted)


@pytest.mark.exercise("B4.5", asks="seed always gives the same show", read=SHOW)
def test_the_same_seed_launches_the_same_fireworks(rng: Random) -> None:
    seed = rng.randrange(10**6)
    draw = "Draw all random numbers from self.random, which is created from the seed."
    with calls(
        f"Two shows with the same seed launched different fireworks. {draw}",
        f"two shows with the seed {seed}; show.launch(1) three times in each",
    ):
        once, again, other = (
            probes.played([FIRST], [1, 1, 1], 0.01, 0, seed=s)[1] for s in (seed, seed, seed + 1)
        )
    expect_exactly(len(once), 3, then="; the number of fireworks in the first show")
    differ = sum(a != b for a, b in zip(once, again, strict=True))
    expect_exactly(differ, 0, then="; how many fireworks differ between the shows")
    expect_exactly(
        sum(a == b for a, b in zip(once, other, strict=True)),
        0,
        call=f"two shows with the seeds {seed} and {seed + 1}; show.launch(1) three times in each; "
        "how many fireworks are equal",
        cause=f"Two shows with different seeds launched the same fireworks. {draw}",
    )


@pytest.mark.exercise("B4.5", asks="In that case nothing is lit", read=LAUNCH)
@pytest.mark.robust
def test_rejects_births_with_an_unknown_type_or_a_negative_count() -> None:
    show = launched(9, "keep_old")
    about(
        "a show with rules for the types 1 to 4; show.launch(7)",
        cause="The show has no rule for type 7. Raise a ValueError that mentions the type.",
    )
    expect_error(
        lambda: show.launch(7), ValueError, allowed=lambda: launched(9, "keep_old").launch(4)
    )
    expect_exactly(len(show.fireworks), 0, then="; the number of burning fireworks")
    first = "You light the first item before you check the second. Check all items first."
    for bad, second in (
        ("a type without a rule", (7, 1, None)),
        ("a negative count", (2, -3, None)),
        ("a negative count", (2, -1, None)),
    ):
        births = [(1, 2, None), second]
        about(
            f"rules for the types 1 to 4; show.light({births}), whose second item has {bad}",
            cause=f"The second item of births has {bad}. Raise ValueError before you light any.",
        )
        expect_error(
            lambda births=births: show.light(births),
            ValueError,
            allowed=lambda: launched(9, "keep_old").light([(4, 0, None), (4, 1, None)]),
            read=LIGHT,
        )
        lit, dropped = len(show.fireworks), show.dropped
        got = f"{lit} burning fireworks, {dropped} dropped"
        none = "0 burning fireworks, 0 dropped"
        expect_that((lit, dropped) == (0, 0), got, none, then="; the state of show", cause=first)
