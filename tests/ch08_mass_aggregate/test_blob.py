"""The blob: its bonds and its spread, B8.8 and B8.9."""

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
    """Return the force that pulls the ends together. It is negative if it pushes."""
    return k * (min(length, limit) - rest) + share * k * max(0.0, length - limit)


@scoped
def expect_forces(call: str, seen: tuple, force: float, way: Components) -> None:
    about.call = call
    on_a = tuple(force * w for w in way)
    on_b = tuple(-force * w for w in way)
    if force:
        mistakes = [
            ((*ZERO, *ZERO), f"There is no force at all. {about.cause}"),
            ((*on_a, *ZERO), "b gets no force. Use self._to_a for b, and self._to_b for a."),
            ((*on_a, *on_a), "b gets the same force as a. Use self._to_a for b."),
        ]
        blame((*seen[0], *seen[1]), mistakes)
    # Rounding of forces of some tens of N.
    expect_close(seen[0], on_a, then=": force on a", tolerance=1e-11)
    expect_close(seen[1], on_b, then=": force on b", tolerance=1e-11)


@pytest.mark.exercise("B8.8")
def test_a_bond_is_a_spring_with_a_limit(rng: Random) -> None:
    k, rest, limit, share, most = draw_bond(rng)
    way = direction(rng)
    lengths = [0.5 * rest, rest, 0.5 * (rest + limit), limit, 0.5 * (limit + most)]
    about(f"Bond(a, b, {k}, {rest}, {limit}, {share}, {most}) of length ", read=BOND)
    about.cause = "While the bond holds, self._to_b acts on a, and self._to_a acts on b."
    for length, seen in zip(
        lengths, bonded(lengths, k, rest, limit, share, most, way), strict=True
    ):
        force = pull(length, k, rest, limit, share)
        expect_forces(f"{about.call}{length}", seen, force, way)
        expect_exactly(seen[2], True, then=f"{length}: holds")


@pytest.mark.exercise("B8.8")
@pytest.mark.parametrize("swap", [False, True], ids=["a first", "b first"])
def test_a_bond_breaks_and_heals(rng: Random, swap: bool) -> None:
    k, rest, limit, share, most = draw_bond(rng)
    way = direction(rng)
    about(f"Bond(a, b, {k}, {rest}, {limit}, {share}, {most})", read=BOND)
    causes = {
        "breaks": "The bond is longer than break_length. It must break and stop acting in the same "
        "call, whichever end it is called for.",
        "broken": "A broken bond stays broken until its ends are rest_length or less apart.",
        "heals": "The ends are less than rest_length apart. The bond must hold again, and act in "
        "the same call.",
        "holds": "The bond has healed, so it holds up to break_length again.",
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
            continue  # rounding may have made it slightly longer
        shown = ", ".join(f"{one:.6g}" for one in lengths[: i + 1])
        name = f"{about.call}; its length is {shown} m in turn"
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
    about.call = f"Bond(a, b, 30, {rest}, {rest}, 0.5, {most}) along X, set to the lengths "
    about.call += f"{lengths} in turn: whether it holds at each"
    about.cause = "At exactly break_length the bond still holds. A longer bond breaks, and it "
    about.cause += "holds again at rest_length or less."
    # Quarters of a meter from the origin are not rounded.
    seen = bonded(lengths, 30.0, rest, rest, 0.5, most, (1.0, 0.0, 0.0), origin=ZERO)
    got = [holds for _, _, holds in seen]
    if got == [True] * 4:
        about.cause = "The bond never breaks. It must break when it is longer than break_length."
    elif got == [True, False, False, False]:
        about.cause = "The bond does not heal. It must hold again at rest_length or less."
    elif got == [True, False, True, True]:
        about.cause = (
            "The bond heals too early. It stays broken until its length is rest_length or less."
        )
    expect_exactly(got, [True, False, False, True])


@pytest.mark.exercise("B8.8")
def test_bonds_keep_a_blob_together() -> None:
    about("seven particles with bonds between all of them, 3 s after they were dropped", read=BOND)
    about.cause = "Bonds must push as well as pull, so that the blob neither collapses nor flies "
    about.cause += "apart."
    before, after = settled_blob(180, 1.0 / 60.0)
    # Under its own weight, such a blob spreads by 1 to 2 %.
    share = _spread(after) / _spread(before)
    expect_exactly(0.9 < share < 1.1, True, then=": has its spread changed by less than 10 %")


def _spread(places: list[Components]) -> float:
    middle = [math.fsum(place[k] for place in places) / len(places) for k in range(3)]
    return math.sqrt(math.fsum(math.dist(place, middle) ** 2 for place in places) / len(places))


@pytest.mark.exercise("B8.9")
def test_the_spread_is_the_root_of_the_mean_square(rng: Random) -> None:
    about("spread of four particles of equal mass at the corners of a square of 2 m", read=SPREAD)
    about.cause = "Every corner is sqrt(2) m from the center of mass."
    x, y, z = components(rng)
    square = [(x + i, y + j, z) for i in (0.0, 2.0) for j in (0.0, 2.0)]
    got, after = spread_of(square, [3.0] * 4)
    mistakes = [
        (2.0, "The result is the mean of the squared distances. Take its square root."),
        (math.sqrt(8.0),
         "The result is the root of the sum. Divide the sum by the total mass first."),
        (math.sqrt(24.0),
         "The result is the root of the sum. Divide the sum by the total mass first."),
        (math.sqrt(2.0 + math.hypot(x + 1.0, y + 1.0, z) ** 2),
         "The distances are those from the origin. Use the distances from the center of mass."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, math.sqrt(2.0), tolerance=1e-12)
    numbers = [number for place in square for number in place]
    got = [number for place in after for number in place]
    about.cause = "spread must not move the particles. Compute with new vectors."
    expect_close(got, numbers, then=": the positions afterward", tolerance=0.0)
    m, n = positive_number(rng), positive_number(rng)
    p, q = components(rng), components(rng)
    about.call = f"spread of a mass {m} at {p} and a mass {n} at {q}"
    about.cause = "Weight the squared distances from the center of mass by the masses. For two "
    about.cause += "particles this gives sqrt(m n) / (m + n) times their distance."
    wanted = math.sqrt(m * n) / (m + n) * math.dist(p, q)
    got = spread_of([p, q], [m, n])[0]
    apart, total = math.dist(p, q), m + n
    ways = (n / total * apart, m / total * apart)  # of both from their center of mass
    mistakes = [
        ((m * ways[0] + n * ways[1]) / total,
         "The result is the mean of the distances. Take the root of the mean of their squares."),
        (0.5 * apart,
         "The distances are those from the midpoint. The center of mass is nearer to the "
         "heavier particle."),
        (math.hypot(*ways) / math.sqrt(2.0), "The masses do not count here. Weight each squared "
                                             "distance by the mass."),
    ]  # fmt: skip
    blame(got, mistakes)
    expect_close(got, wanted, tolerance=1e-12)
    about(
        f"spread of one particle at {p}",
        cause="A single particle is at its own center of mass, so return 0.",
    )
    expect_close(spread_of([p], [m])[0], 0.0, tolerance=1e-12)


@pytest.mark.exercise("B8.9")
@pytest.mark.robust
def test_a_spread_of_nothing_is_refused() -> None:
    about.read = SPREAD

    def allowed() -> None:
        spread_of([ZERO], [1.0])

    about.cause = "Without particles there is no mean. Raise ValueError."
    expect_error(lambda: spread([]), ValueError, call="spread([])", allowed=allowed)
    about.cause = "An immovable particle has an infinite mass. Raise ValueError."
    for masses in ([1.0, math.inf], [math.inf, 1.0]):
        expect_error(
            lambda masses=masses: spread_of([ZERO, (1.0, 0.0, 0.0)], masses),
            ValueError,
            call=f"spread of two particles of {masses} kg",
            allowed=allowed,
        )
