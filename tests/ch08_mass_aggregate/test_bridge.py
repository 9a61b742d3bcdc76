"""The rope bridge: its links, B8.4."""

from __future__ import annotations

import math
from random import Random

import pytest

from calls import calls
from ch02_vectors.vector import Vector3
from ch08_mass_aggregate.bridge import links_of
from ch08_mass_aggregate.bridge_plan import make_rows
from ch08_mass_aggregate.scene_probes import told
from draw import Components, positive_number
from expect import expect_close, expect_exactly, named

LINKS = "the docstring of links_of"
# The bridge of bridge_plan.py: six rows of two ends, 2 m apart, at a height of 4 m.
START = [(2.0 * (i // 2) - 5.0, 4.0, 2.0 * (i % 2) - 1.0) for i in range(12)]
ANCHORS = [(1.1 * x, 6.0, 0.8 * z) for x, _, z in START]
SUPPORTS = (3.0, 3.5, 4.0, 4.0, 3.5, 3.0)  # m
# The ends of each link, of which -1 is the anchor, and the link's length
JOINED = {
    "rod": [(2 * i, 2 * i + 1, 2.0) for i in range(6)],
    "cable": [(i, i + 2, 1.9) for i in range(10)],
    "anchored cable": [(i, -1, SUPPORTS[i // 2]) for i in range(12)],
}


def span(places: list[Components], i: int, j: int) -> float:
    """Return the distance between two ends, or between an end and its anchor."""
    return math.dist(places[i], places[j] if j >= 0 else ANCHORS[i])


def links_at(places: list[Components]) -> list[tuple[int, int, float, float]]:
    """Return the ends, restitution and penetration of each contact with the planks there."""
    rows = make_rows()
    planks = [end for row in rows for end in row]
    links = links_of(rows)
    for plank, place in zip(planks, places, strict=True):
        plank.position = Vector3(*place)
    found = told([contact for link in links for contact in link.contacts()], planks)
    return [(*((b, a) if 0 <= b < a else (a, b)), c, depth) for a, b, _, c, depth in found]


@pytest.mark.exercise("B8.4", asks="joins each end to the end on the same side", read=LINKS)
@pytest.mark.parametrize("which", JOINED)
def test_links_join_the_right_ends(rng: Random, which: str) -> None:
    wide, low, long = (positive_number(rng, a, b) for a, b in ((1.2, 1.6), (2.2, 4.0), (1.2, 1.6)))
    places = [(long * x, y - low - 0.1 * x, wide * z) for x, y, z in START]
    with calls(
        "Return a list of all links. The last row has no next row, so a loop over rows i and i + 1 "
        "must stop one row earlier, as itertools.pairwise(rows) does.",
        "links_of(make_rows()), where ends 0 and 1 belong to row 0, ends 2 and 3 to row 1, and so "
        "on; the ends are moved so far apart that every link is stretched",
    ):
        links = [(i, j, depth) for i, j, _, depth in links_at(places)]
    join, name, length = {
        "rod": ("Join the two ends of each row with one Rod of length WIDTH.",
                "pairs (i, i + 1) of ends", "WIDTH"),
        "cable": ("Join each end to the end of the next row on the same side, with a Cable of "
                  "length CABLE_LENGTH.", "pairs (i, i + 2) of ends", "CABLE_LENGTH"),
        "anchored cable": ("Hang each end of each row from anchor_of(end). Use an AnchoredCable of "
                           "length support_length(row number).",
                           "ends and anchors, as (end, -1),", "support_length(row number)"),
    }[which]  # fmt: skip
    step = {"rod": 1, "cable": 2}.get(which)
    got = sorted(one for one in links if (one[1] - one[0] if one[1] >= 0 else None) == step)
    ends, right = ([(i, j) for i, j, _ in some] for some in (got, JOINED[which]))
    missing = [pair for pair in right if pair not in ends]
    extra = [pair for n, pair in enumerate(ends) if pair not in right or pair in ends[:n]]
    why = join
    if missing:
        made = len(right) - len(missing)
        seen, late = f"no {which}s", ", or they are too long"
        if made:
            seen, late = f"only {made} of the {len(right)} {which}s", ", or the others are too long"
        if 2 * made == len(right) and len({i % 2 for i, _ in missing}) == 1:
            seen, late = f"{which}s on one side of the bridge only", ""
        why = f"You create {seen}{late if which != 'rod' else ''}. {join}"
    elif extra:
        i, j = extra[0]
        twice = f"join ends {i} and {j}" if j >= 0 else f"hang end {i}"
        why = f"You {twice} with two links. {join}"
        if extra[0] not in right:
            why = f"You join ends {i} and {j}, which are on different sides. Join {i} and {i + 2}."
    expect_exactly(ends, right, then=f"; the {name} that links join", cause=why)
    why = f"The length of your {which} is wrong. It should be {length}."
    if "anchor" in which:
        why = "The length or the anchor of your anchored cable is wrong. They should be "
        why += f"{length} and anchor_of(end)."
    first = "This cable has the length for row 0. Pass its own row number to support_length."
    for (i, j, depth), (*_, wanted) in zip(got, JOINED[which], strict=True):
        # Lengths of some meters, rounded a few times.
        size, then = span(places, i, j) - depth, f"; the length of the {which} at end {i}"
        cause = named(size, why, {first: SUPPORTS[0]})
        expect_close(size, wanted, then=then, cause=cause, unit="m", tolerance=1e-12)


@pytest.mark.exercise("B8.4", asks="All cables have a restitution of 0", read=LINKS)
def test_links_act_at_the_right_lengths() -> None:
    why = "At the start only the cables from row to row should report a contact, because they are "
    why += "stretched by 0.1 m. The rods have the right length, and the anchored cables are slack."
    with calls(why, "links_of(make_rows()), with the planks where they start"):
        links = sorted((i, j) for i, j, *_ in links_at(START))
    if [pair for pair in links if pair[1] == pair[0] + 1] == [(i, i + 1) for i in range(0, 12, 2)]:
        why = "You join the ends of each row with a Cable, which is taut at this length. Use a Rod."
    wanted = [(i, i + 2) for i in range(10)]
    expect_exactly(links, wanted, then="; the ends of all contacts", cause=why)
    slack = "The cables are slack here, and the rods have the right length. Check your lengths."
    with calls(slack, "links_of(make_rows()); all planks are pushed together along X"):
        count = len(links_at([(0.8 * x, 4.5, z) for x, _, z in START]))
    only = "which can only pull, instead of rods."
    why = named(count, slack, {
        f"Your links from row to row push the planks apart. Use Cables, {only}": 10,
        f"Your links to the anchors push the planks away. Make them AnchoredCables, {only}": 12,
        f"Your links to other rows and anchors push the planks. Make them cables, {only}": 22,
    })  # fmt: skip
    expect_exactly(count, 0, then="; the number of contacts", unit="contacts", cause=why)
    likely = "Every link should have a contact here: 6 rods, 10 cables and 12 anchored cables."
    with calls(likely, "links_of(make_rows()); all planks are pulled apart"):
        found = links_at([(1.5 * x, 1.0, 1.5 * z) for x, _, z in START])
    expect_exactly(len(found), 28, then="; the number of contacts", unit="contacts")
    why = "You give some links a restitution. Leave this argument out, so that they don't bounce."
    got = sorted({c for _, _, c, _ in found})
    expect_close(got, (0.0,), then="; the restitutions of the contacts", cause=why, tolerance=0.0)
