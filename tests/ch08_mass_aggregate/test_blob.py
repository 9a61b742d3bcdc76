"""The blob: its bonds, and how spread out it is, B8.8 and B8.9."""

from __future__ import annotations

import math
from random import Random

import pytest

from ch08_mass_aggregate.blob import spread
from ch08_mass_aggregate.scene_probes import bonded, settled_blob, spread_of
from draw import Components, components, direction, positive_number
from expect import about, blame, expect_close, expect_error, expect_exactly, scoped

BOND = "the docstring of Bond, and of Bond.update_force"
SPREAD = "the docstring of spread"
ZERO = (0.0, 0.0, 0.0)


def draw_bond(rng: Random) -> tuple[float, float, float, float, float]:
    """Draw stiffness, rest length, limit, share and break length."""
    rest = positive_number(rng, 0.5, 2.0)
    limit = rest + positive_number(rng, 0.2, 1.0)
    return positive_number(rng), rest, limit, positive_number(rng, 0.1, 0.9), limit + 1.0


def pull(length: float, k: float, rest: float, limit: float, share: float) -> float:
    """Return the force that pulls the ends together; negative where it pushes."""
    return k * (min(length, limit) - rest) + share * k * max(0.0, length - limit)


@scoped
def expect_forces(call: str, seen: tuple, force: float, way: Components) -> None:
    about.call = call
    on_a = tuple(force * w for w in way)
    on_b = tuple(-force * w for w in way)
    if force:
        name = "b gets the force of a once more: the spring to a acts on b"
        on_both = [((*ZERO, *ZERO), f"no force at all: {about.cause}")]
        blame((*seen[0], *seen[1]), on_both)
        blame(seen[1], [(on_a, name)])
    # Rounding of forces of some tens of N.
    expect_close(seen[0], on_a, then=": force on a", tolerance=1e-11)
    expect_close(seen[1], on_b, then=": force on b", tolerance=1e-11)


@pytest.mark.exercise("B8.8")
def test_a_bond_is_a_spring_with_a_limit(rng: Random) -> None:
    about.read = BOND
    k, rest, limit, share, most = draw_bond(rng)
    way = direction(rng)
    lengths = [0.5 * rest, rest, 0.5 * (rest + limit), limit, 0.5 * (limit + most)]
    about.call = f"Bond(a, b, {k}, {rest}, {limit}, {share}, {most}) of length "
    about.cause = "while it holds, the spring to b acts on a, and the spring to a acts on b"
    for length, seen in zip(
        lengths, bonded(lengths, k, rest, limit, share, most, way), strict=True
    ):
        force = pull(length, k, rest, limit, share)
        expect_forces(f"{about.call}{length}", seen, force, way)
        expect_exactly(seen[2], True, then=f"{length}: holds")


@pytest.mark.exercise("B8.8")
@pytest.mark.parametrize("swap", [False, True], ids=["a first", "b first"])
def test_a_bond_breaks_and_heals(rng: Random, swap: bool) -> None:
    about.read = BOND
    k, rest, limit, share, most = draw_bond(rng)
    way = direction(rng)
    about.call = f"Bond(a, b, {k}, {rest}, {limit}, {share}, {most})"
    causes = {
        "breaks": "longer than break_length it breaks, and does nothing, in this very frame, "
        "whichever of its ends it is asked for",
        "broken": "once broken it stays so until its ends are rest_length or less apart",
        "heals": "it holds again from rest_length on, and acts in this very frame",
        "holds": "it has healed, and holds up to break_length",
    }
    story = [
        (most, True, "holds"),
        (1.001 * most, False, "breaks"),
        (0.5 * (limit + most), False, "broken"),
        (1.001 * rest, False, "broken"),
        (0.999 * rest, True, "heals"),
        (0.5 * (limit + most), True, "holds"),
        (2.0 * most, False, "breaks"),
        (0.5 * rest, True, "heals"),
    ]
    lengths = [length for length, _, _ in story]
    about.cause = causes["holds"]
    seen = bonded(lengths, k, rest, limit, share, most, way, swap)
    for i, (length, holds, what) in enumerate(story):
        if what == "holds" and i == 0:
            continue  # rounding may have made it a little longer
        name = f"{about.call}, pulled to {lengths[: i + 1]} in turn"
        about.cause = causes[what]
        expect_exactly(seen[i][2], holds, call=f"{name}: holds")
        force = pull(length, k, rest, limit, share) if holds else 0.0
        expect_forces(name, seen[i], force, way)


@pytest.mark.exercise("B8.8")
def test_a_bond_at_its_very_limits(rng: Random) -> None:
    about.read = BOND
    rest = 0.25 * rng.randint(3, 6)
    most = rest + 0.25 * rng.randint(2, 5)
    lengths = [most, most + 1e-6, rest + 1e-6, rest]
    about.call = f"Bond(a, b, 30, {rest}, {rest}, 0.5, {most}) along X, pulled to {lengths} in "
    about.call += "turn: whether it holds at each"
    about.cause = "longer than break_length it breaks, and holds again from rest_length on: at the "
    about.cause += "very lengths it holds"
    # These lengths are told exactly: quarters of a metre, from the origin.
    seen = bonded(lengths, 30.0, rest, rest, 0.5, most, (1.0, 0.0, 0.0), origin=ZERO)
    got = [holds for _, _, holds in seen]
    expect_exactly(got, [True, False, False, True])


@pytest.mark.exercise("B8.8")
def test_bonds_keep_a_blob_together() -> None:
    about.read = BOND
    about.call = "seven particles with bonds between all of them, let go over the ground, after 3 s"
    about.cause = "bonds push as well as pull: the blob stands on the ground, and is neither flat "
    about.cause += "nor gone"
    before, after = settled_blob(180, 1.0 / 60.0)
    # By its own weight a blob of these bonds spreads by 1 to 2 %: 10 % is a limp one.
    share = _spread(after) / _spread(before)
    expect_exactly(0.9 < share < 1.1, True, then=": has its spread changed by less than 10 %")


def _spread(places: list[Components]) -> float:
    middle = [math.fsum(place[k] for place in places) / len(places) for k in range(3)]
    return math.sqrt(math.fsum(math.dist(place, middle) ** 2 for place in places) / len(places))


@pytest.mark.exercise("B8.9")
def test_the_spread_is_the_root_of_the_mean_square(rng: Random) -> None:
    about("spread of four particles of equal mass at the corners of a square of 2 m", read=SPREAD)
    about.cause = "each is sqrt(2) m from the middle"
    x, y, z = components(rng)
    square = [(x + i, y + j, z) for i in (0.0, 2.0) for j in (0.0, 2.0)]
    got, after = spread_of(square, [3.0] * 4)
    mistakes = [
        (2.0, "that is the mean of the squares: its root is left out"),
        (math.sqrt(8.0), "that is the root of the sum: the mean is the sum over the mass of all"),
        (math.sqrt(24.0), "that is the root of the sum: the mean is the sum over the mass of all"),
        (math.sqrt(2.0 + math.hypot(x + 1.0, y + 1.0, z) ** 2), "that is from the origin: "
         "distances are from the centre of mass"),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, math.sqrt(2.0), tolerance=1e-12)
    numbers = [number for place in square for number in place]
    got = [number for place in after for number in place]
    about.cause = "to look at them moves none: work on new vectors"
    expect_close(got, numbers, then=": where they are", tolerance=0.0)
    m, n = positive_number(rng), positive_number(rng)
    p, q = components(rng), components(rng)
    about.call = f"spread of a mass {m} at {p} and a mass {n} at {q}"
    about.cause = "the distances are those from the centre of mass, and each counts by its mass: "
    about.cause += "here sqrt(m n) / (m + n) times the distance of the two"
    wanted = math.sqrt(m * n) / (m + n) * math.dist(p, q)
    got = spread_of([p, q], [m, n])[0]
    apart, total = math.dist(p, q), m + n
    ways = (n / total * apart, m / total * apart)  # of both from their centre of mass
    mistakes = [
        ((m * ways[0] + n * ways[1]) / total, "that is the mean of the distances: take the root of "
         "the mean of their squares"),
        (0.5 * apart, "that is from the middle of the places: the centre of mass is nearer to the "
         "heavier one"),
        (math.hypot(*ways) / math.sqrt(2.0), "each counts the same there: it counts by its mass"),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, wanted, tolerance=1e-12)
    about.call, about.cause = f"spread of one particle at {p}", "it is where its centre is"
    expect_close(spread_of([p], [m])[0], 0.0, tolerance=1e-12)


@pytest.mark.exercise("B8.9")
@pytest.mark.robust
def test_a_spread_of_nothing_is_refused() -> None:
    about.read = SPREAD

    def allowed() -> None:
        spread_of([ZERO], [1.0])

    about.cause = "without particles there is no mean"
    expect_error(lambda: spread([]), ValueError, call="spread([])", allowed=allowed)
    about.cause = "what is immovable has no share: its mass is infinite"
    for masses in ([1.0, math.inf], [math.inf, 1.0]):
        expect_error(
            lambda masses=masses: spread_of([ZERO, (1.0, 0.0, 0.0)], masses),
            ValueError,
            call=f"spread of two particles of {masses} kg",
            allowed=allowed,
        )
