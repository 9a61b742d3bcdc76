"""The rope bridge: its links, B8.4."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import pytest

from ch08_mass_aggregate.scene_probes import bridge_links, hung_bridge
from draw import Components, positive_number
from expect import about, blame, cause_of, expect_between, expect_close, expect_exactly

LINKS = "the docstring of links_of"
# The bridge of bridge_plan.py: six rows of two ends, 2 m apart, at a height of 4 m.
START = [(2.0 * (i // 2) - 5.0, 4.0, 2.0 * (i % 2) - 1.0) for i in range(12)]
SUPPORTS = (3.0, 3.5, 4.0, 4.0, 3.5, 3.0)  # m


def wanted_links(places: list[Components]) -> list[tuple[int, int, float]]:
    """Return the ends and the penetration of each link's contact, computed from the docstring."""
    joined = [(2 * i, 2 * i + 1, 2.0) for i in range(6)]
    joined += [(i, i + 2, 1.9) for i in range(10)]
    wanted = []
    for i, j, length in joined:
        depth = math.dist(places[i], places[j]) - length
        is_rod = j == i + 1
        if depth >= 0.0 or is_rod:
            wanted.append((i, j, abs(depth)))
    for i, (x, _, z) in enumerate(START):
        depth = math.dist((1.1 * x, 6.0, 0.8 * z), places[i]) - SUPPORTS[i // 2]
        if depth >= 0.0:
            wanted.append((i, -1, depth))
    return wanted


@pytest.mark.exercise("B8.4", asks="joins each end to the end on the same side")
@pytest.mark.parametrize("which", ["rod", "cable", "anchored cable"])
def test_links_join_the_right_ends(rng: Random, which: str) -> None:
    about.read = LINKS
    wide, low, long = (positive_number(rng, a, b) for a, b in ((1.2, 1.6), (2, 4), (1.2, 1.6)))
    places = [(long * x, y - low - 0.1 * x, wide * z) for x, y, z in START]
    about.call = "links_of(make_rows()), where ends 0 and 1 belong to row 0, ends 2 and 3 to row "
    about.call += "1, and so on; the ends are moved so far apart that every link is stretched"
    about.cause = "Return a list of all links. The last row has no next row, so a loop over rows i "
    about.cause += "and i + 1 must stop one row earlier, as itertools.pairwise(rows) does."
    links = [(i, j, depth) for i, j, _, _, depth in bridge_links(places)]
    about.cause = {
        "rod": "Join the two ends of each row with one Rod of length WIDTH.",
        "cable": "Join each end to the end of the next row on the same side, with a Cable of "
        "length CABLE_LENGTH.",
        "anchored cable": "Hang each end of each row from anchor_of(end). Use an AnchoredCable of "
        "length support_length(row number).",
    }[which]

    def picked(links: Any) -> list[Any]:
        kinds = {"rod": 1, "cable": 2}
        return sorted(
            (i, j, depth)
            for i, j, depth in links
            if (j < 0) == (which == "anchored cable") and (j < 0 or j - i == kinds.get(which))
        )

    got, wanted = picked(links), picked(wanted_links(places))
    ends, right = ([(i, j) for i, j, _ in some] for some in (got, wanted))
    missing = [pair for pair in right if pair not in ends]
    extra = [pair for n, pair in enumerate(ends) if pair not in right or pair in ends[:n]]
    why = about.cause
    if missing:
        made, late = len(right) - len(missing), ", or the others are too long"
        seen = f"only {made} of the {len(right)} {which}s" if made else f"no {which}s"
        if which == "rod":
            late = ""
        elif not made:
            late = ", or they are too long"
        elif 2 * made == len(right) and len({i % 2 for i, _ in missing}) == 1:
            seen, late = f"{which}s on one side of the bridge only", ""
        why = f"You create {seen}{late}. {about.cause}"
    elif extra:
        i, j = extra[0]
        both = f"join ends {i} and {j}" if j >= 0 else f"hang end {i}"
        why = f"You {both} with two links. {about.cause}"
        if extra[0] not in right:
            why = f"You join ends {i} and {j}, which are in different rows and on different sides. "
            why += f"Join ends on the same side, such as {i} and {i + 2}."
    name = {"rod": "pairs (i, i + 1) of ends", "cable": "pairs (i, i + 2) of ends"}
    name = f"; the {name.get(which, 'ends and anchors, as (end, -1),')} that links join"
    expect_exactly(ends, right, then=name, cause=why)
    length = {"rod": "WIDTH", "cable": "CABLE_LENGTH"}.get(which, "support_length(row number)")
    about.cause = f"The length of your {which} is wrong. It should be {length}."
    if "anchor" in which:
        about.cause = "The length or the anchor of your anchored cable is wrong. They should be "
        about.cause += f"{length} and anchor_of(end)."
    first = "This cable has the length for row 0. Pass its own row number to support_length."
    for (i, j, depth), (_, _, deeper) in zip(got, wanted, strict=True):
        x, _, z = START[i]
        apart = math.dist(places[i], places[j] if j >= 0 else (1.1 * x, 6.0, 0.8 * z))
        name = f"; the length of the {which} at end {i}"
        # Lengths of some meters, rounded a few times.
        size, right = apart - depth, apart - deeper
        seen = cause_of(size, [(SUPPORTS[0], first)], about.cause)
        expect_close(size, right, then=name, cause=seen, unit="m", tolerance=1e-12)


@pytest.mark.exercise("B8.4", asks="All cables have a restitution of 0")
def test_links_act_at_the_right_lengths() -> None:
    about.read = LINKS
    about.call = "links_of(make_rows()), with the planks where they start; the ends of all contacts"
    about.cause = "At the start only the cables from row to row should report a contact, because "
    about.cause += "they are stretched by 0.1 m. The rods have the right length, and the anchored "
    about.cause += "cables are slack."
    links = sorted((i, j) for i, j, *_ in bridge_links(START))
    if sorted(pair for pair in links if pair[1] == pair[0] + 1) == [
        (i, i + 1) for i in range(0, 12, 2)
    ]:
        about.cause = "You join the two ends of each row with a Cable, which only pulls. A plank "
        about.cause += "must also keep its ends apart, so use a Rod."
    expect_exactly(links, [(i, i + 2) for i in range(10)])
    places = [(0.8 * x, 4.5, z) for x, _, z in START]
    about.call = "links_of(make_rows()); all planks are pushed together along X; the number of "
    about.call += "contacts"
    about.cause = "The cables are slack here, and the rods have exactly the right length, so there "
    about.cause += "should be no contacts. Check the lengths that you pass to the links."
    count = len(bridge_links(places))
    mistakes = [
        (10, "Your links from row to row push the planks apart. Use Cables, which can only pull, "
             "instead of rods."),
        (12, "Your links to the anchors push the planks away. Make them AnchoredCables, which can "
             "only pull, instead of rods."),
        (22, "Your links from row to row and to the anchors push the planks. Make them cables, "
             "which can only pull, instead of rods."),
    ]  # fmt: skip
    blame(count, mistakes)
    expect_exactly(count, 0, unit="contacts")
    places = [(1.5 * x, 1.0, 1.5 * z) for x, _, z in START]
    about.call = "links_of(make_rows()); all planks are pulled apart; the "
    about.cause = "Every link is too long here, so each one should have a contact: 6 for the rods, "
    about.cause += "10 for the cables and 12 for the anchored cables."
    found = bridge_links(places)
    expect_exactly(len(found), 28, then="number of contacts", unit="contacts")
    about.cause = "You give some links a restitution. Leave this argument out, so that they don't "
    about.cause += "bounce."
    got = sorted({c for _, _, _, c, _ in found})
    expect_close(got, (0.0,), then="restitutions of the contacts", tolerance=0.0)


@pytest.mark.exercise("B8.4", asks="joins each end to its anchor")
def test_a_bridge_that_hangs_keeps_its_lengths() -> None:
    about("the bridge, 1.5 s after it was released, at 60 steps per second", read=LINKS)
    about.cause = "The anchored cables have to carry the bridge. Give each end of each row an "
    about.cause += "AnchoredCable of length support_length(row number)."
    places = hung_bridge(90, 1.0 / 60.0)
    lowest = min(y for _, y, _ in places)
    expect_between(lowest, 0.01, math.inf, then="; the height of its lowest end", unit="m")
    over = [math.dist(places[i], places[i + 2]) / 1.9 - 1.0 for i in range(10)]
    for i, (x, _, z) in enumerate(START):
        anchor = (1.1 * x, 6.0, 0.8 * z)
        over.append(math.dist(anchor, places[i]) / SUPPORTS[i // 2] - 1.0)
    # The resolver's default leaves 0.4 % at 60 steps per second.
    name = ": the largest extension of a cable, as a fraction of its length"
    expect_between(max(over), -math.inf, 0.02, then=name)
