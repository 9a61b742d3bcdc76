"""The pictures of chapter 7 agree with theory, and show a wrong or unfinished engine."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import drawn_plots
from drawn_plots import engine_with, plot_of_stubs

CHAPTER = "ch07_constraints"
PLOTS = 8
# All but the plots of rods, which simulate longest.
QUICK = ("bounce_heights", "resting_jitter", "resolver_convergence", "stack_height")
QUICK += ("pendulum_energy", "restitution_of_materials")


def table(out: Path, name: str) -> list[list[str]]:
    return drawn_plots.table(out, name, CHAPTER)[1:]


def test_bounces_end_when_theory_says(reference: Path) -> None:
    rows = table(reference, "bounce_heights")
    heights = {
        (name, float(c)): [(float(row[2]), float(row[3])) for row in rows if row[:2] == [name, c]]
        for name, c, *_ in rows
    }
    # The fall takes sqrt(2 h / g), and then each flight takes half as long as the one before.
    end = math.sqrt(0.4) * 3.0
    assert heights["time division", 0.5][-1][0] == pytest.approx(end, rel=1e-9)
    last = {
        name: max(y for time, y in seen if time > 18.0)
        for (name, c), seen in heights.items()
        if c == 1.0
    }
    # A frame may miss the top by at most a h^2 / 8.
    assert last["time division"] == pytest.approx(2.0, abs=10.0 / 60.0**2 / 8.0)
    assert last["explicit Euler"] == pytest.approx(2.75, abs=1e-6)
    assert last["semi-implicit Euler"] < 0.01


def test_what_rests_jitters_by_the_book_s_step_alone(reference: Path) -> None:
    rows = table(reference, "resting_jitter")
    highest: dict[tuple[str, str], float] = {}
    for c, name, _, height in rows:
        highest[c, name] = max(highest.get((c, name), 0.0), float(height))
    for made in ("built-in", "generated"):
        for c, wanted in (("0.5", 1.389e-3), ("0.9", 2.75e-3)):
            book = highest[c, f"explicit Euler, resting rule, {made}"]
            assert book == pytest.approx(wanted, abs=1e-6)
            assert highest[c, f"explicit Euler, no rule, {made}"] > 2.0 * book
            assert (
                highest[c, f"semi-implicit Euler, resting rule, {made}"] == 1e-6
            )  # the start height


def test_a_rule_that_goes_too_far_kills_a_bounce(reference: Path) -> None:
    rows = table(reference, "resting_jitter")
    late: dict[str, float] = {}
    for _, name, time, height in rows:
        if float(time) > 0.1:
            late[name] = max(late.get(name, 0.0), float(height))
    assert late["fall of 0.04 m, semi-implicit Euler, no bounce below 1 m/s"] == 0.0
    assert late["fall of 0.04 m, time division"] == pytest.approx(0.04 * 0.81, abs=4e-4)
    assert late["fall of 0.04 m, semi-implicit Euler, resting rule"] > 0.01


def test_the_resolver_converges(reference: Path) -> None:
    rows = table(reference, "resolver_convergence")
    first = {int(row[1]): [float(v) for v in row[2:]] for row in rows if "first" in row[0]}
    assert first[0] == pytest.approx([1.0, 0.01])
    for before, after in ((0, 100), (100, 200), (200, 400)):
        assert all(b < a / 5.0 for a, b in zip(first[before], first[after], strict=True))


def test_a_stack_of_ten_wants_more_iterations(reference: Path) -> None:
    rows = table(reference, "stack_height")
    overlaps: dict[tuple[str, str], float] = {}
    for count, iterations, _, _, overlap in rows:
        key = count, iterations
        overlaps[key] = max(overlaps.get(key, 0.0), float(overlap))
    assert overlaps["3", "default"] == overlaps["3", "2"] < 0.02
    assert overlaps["10", "default"] > 0.3
    assert overlaps["10", "50"] < 0.06


def test_rods_hold_by_substeps_and_a_direct_solve(reference: Path) -> None:
    rows = table(reference, "rope_by_method")
    long: dict[str, float] = {}
    for name, _, excess, _ in rows:
        long[name] = max(long.get(name, 0.0), abs(float(excess)))
    assert long["DirectChain"] < 1e-4
    assert 5.0 * long["Rod, 8 substeps"] < long["Rod"]
    assert 5.0 * long["TwoSidedRod, 8 substeps"] < long["Rod, 8 substeps"]
    off = {(*row[:2], int(row[2])): float(row[3]) for row in table(reference, "rods_hold")}
    for count in (3, 10):
        assert off["TwoSidedRod", "16 substeps", count] < off["Rod", "16 substeps", count]
        assert off["Rod", "16 substeps", count] < off["Rod", "4 substeps", count]
        assert off["Rod", "4 substeps", count] < off["Rod", "default iterations", count]


def test_the_pendulum_keeps_the_more_the_shorter_the_frames(reference: Path) -> None:
    rows = table(reference, "pendulum_energy")
    last = {(row[0], int(row[1])): float(row[3]) for row in rows}
    kept = [last["semi-implicit Euler", rate] for rate in (60, 240, 960)]
    assert kept == sorted(kept)
    assert kept[-1] < 9.0
    assert last["DirectChain", 60] == pytest.approx(10.0, abs=0.02)


def test_the_table_of_drops_is_the_reference_s(reference: Path) -> None:
    rows = table(reference, "restitution_of_materials")
    means = {row[1]: [float(v) for v in row[2:]] for row in rows if row[0] == "mean"}
    count, mean, error, printed = means["golf ball on stone"]
    values = [math.sqrt(share) for share in (0.72, 0.66, 1.04 / 1.5)]
    assert (count, mean) == (3.0, pytest.approx(math.fsum(values) / 3.0, rel=1e-12))
    assert error == pytest.approx(
        math.sqrt(math.fsum((v - mean) ** 2 for v in values) / 6.0), rel=1e-9
    )
    assert printed == pytest.approx((0.72 + 0.66 + 1.04 / 1.5) / 3.0, rel=1e-12)


def test_stubs_are_said(tmp_path: Path) -> None:
    printed = plot_of_stubs(CHAPTER, tmp_path)
    # The direct solve is given, so a rope and a pendulum are drawn with it.
    assert printed.count("not drawn, not written yet: Exercise ") == PLOTS - 2, printed
    assert (tmp_path / CHAPTER / "rope_by_method.png").exists()
    assert (tmp_path / CHAPTER / "pendulum_energy.png").exists()


def test_without_drops_of_one_s_own_the_sample_is_drawn(tmp_path: Path) -> None:
    engine = engine_with(CHAPTER, {}, tmp_path)
    (engine / CHAPTER / "drops.csv").write_text(
        "material,initial_height,bounce_height\n", encoding="utf-8"
    )
    done = drawn_plots.plot(engine, tmp_path, "7", only=("restitution_of_materials",))
    assert done.returncode == 0, done.stdout
    rows = table(tmp_path, "restitution_of_materials")
    assert sum(row[0] == "drop" for row in rows) == 13


@pytest.mark.parametrize(
    ("wrong", "only"),
    [
        ({"contacts.py": "Contact.separating_velocity = lambda *_: float('nan')"}, ()),
        ({"contacts.py": "Contact.velocity_after = lambda *_: 1e3"}, QUICK),
        (
            {
                "contacts.py": "Contact.resolve_velocity = lambda *_: None",
                "detectors.py": "GroundPlane.next_impact = lambda *_: None",
                "exercises.py": "def restitution_of_drop(a, b): return b / a",
            },
            QUICK,
        ),
        (
            {
                "detectors.py": "GroundPlane.contacts = ParticlePairs.contacts = lambda *_: []",
                "links.py": "Rod.contacts = AnchoredRod.contacts = lambda _: []\n"
                "TwoSidedRod.contacts = lambda _: []",
                "time_division.py": "def time_division_step(*_): pass",
                "exercises.py": "def table_of_drops(drops): return []",
            },
            (),
        ),
    ],
)
def test_a_wrong_engine_gives_pictures_all_the_same(
    wrong: dict[str, str], only: tuple[str, ...], tmp_path: Path
) -> None:
    done = drawn_plots.plot(engine_with(CHAPTER, wrong, tmp_path), tmp_path, "7", only=only)
    assert done.returncode == 0, done.stdout + done.stderr
    assert not done.stderr
