"""Plots show the chosen engine: a wrong engine gives a wrong picture, and a stub gives none."""

from __future__ import annotations

import itertools
import math
from pathlib import Path

import pytest

from autograder.manifest import ROOT
from copies import copy_tree
from drawn_plots import plot, table
from made import made_stubs

NAMES = (
    "ch02_vectors/addition",
    "ch02_vectors/projection",
    "ch02_vectors/cross_product",
    "ch02_vectors/basis",
    "ch03_laws_of_motion/damping_comparison",
    "ch03_laws_of_motion/integration_error",
    "ch03_laws_of_motion/trajectories",
    "ch04_particle_engine/shots",
    "ch04_particle_engine/fireworks",
    "ch04_particle_engine/step_error",
    "ch05_forces/terminal_speeds",
    "ch05_forces/fall_with_drag",
    "ch05_forces/orbit",
    "ch05_forces/cost_of_a_generator",
    "ch06_springs/force_against_length",
    "ch06_springs/three_regimes",
    "ch06_springs/stability_map",
    "ch06_springs/fake_spring",
    "ch06_springs/energy_over_time",
    "ch06_springs/error_against_work",
    "ch06_springs/cloth_frame_rates",
    "ch06_springs/penalty_bounces",
    "ch07_constraints/bounce_heights",
    "ch07_constraints/resting_jitter",
    "ch07_constraints/resolver_convergence",
    "ch07_constraints/stack_height",
    "ch07_constraints/rope_by_method",
    "ch07_constraints/rods_hold",
    "ch07_constraints/pendulum_energy",
    "ch07_constraints/restitution_of_materials",
    "ch08_mass_aggregate/energy_of_bridge",
    "ch08_mass_aggregate/energy_of_platform",
    "ch08_mass_aggregate/mass_ratios",
    "ch08_mass_aggregate/hanging_rope",
    "ch08_mass_aggregate/variable_frames",
    "ch08_mass_aggregate/trebuchet_range",
    "ch08_mass_aggregate/wheel_deformation",
    "ch08_mass_aggregate/blob_bonds",
    "ch08_mass_aggregate/sleeping_balls",
    "ch09_rotations/turning_motion",
    "ch09_rotations/order_of_turns",
    "ch09_rotations/drift_of_first_order",
    "ch09_rotations/gimbal_lock",
    "ch09_rotations/balance_lines",
)


@pytest.fixture(scope="module")
def reference(drawn: tuple[Path, str]) -> Path:
    """Return the folder with the reference's plots."""
    out, told = drawn
    names = [name for name in NAMES if (out / Path(name).parent).exists()]  # for make test CH=6
    assert names
    assert all(f"{name}.png" in told and f"{name}.csv" in told for name in names)
    return out


@pytest.mark.parametrize("name", NAMES)
def test_every_plot_is_a_png_with_its_numbers_beside_it(reference: Path, name: str) -> None:
    png = (reference / f"{name}.png").read_bytes()
    assert png.startswith(b"\x89PNG")
    assert len(png) > 10_000, "an empty picture"
    chapter, _, plot_name = name.partition("/")
    assert len(table(reference, plot_name, chapter)) > 2


def test_the_numbers_are_the_engines(reference: Path) -> None:
    assert table(reference, "addition")[-1] == ["a + b", "5.0", "4.0", "0.0"]
    for angle, got, wanted in table(reference, "cross_product")[1:]:
        assert float(got) == pytest.approx(float(wanted), abs=1e-14), angle
    *_, left = table(reference, "projection")
    a = table(reference, "projection")[1]
    assert sum(float(p) * float(q) for p, q in zip(a[1:], left[1:], strict=True)) < 1e-14


def column(rows: list[list[str]], heading: str) -> list[float]:
    return [float(row[rows[0].index(heading)]) for row in rows[1:]]


def test_the_damping_comparison_brackets_the_exact_loss(reference: Path) -> None:
    rows = table(reference, "damping_comparison", "ch03_laws_of_motion")
    rates, exact = column(rows, "frame rate, Hz"), column(rows, "exact loss")
    by_frame, by_second, engine = (column(rows, heading) for heading in rows[0][1:4])
    # For d = 0.5, the exact loss of velocity is 1 - (1 - d) / -ln d.
    assert exact == pytest.approx([1.0 - 0.5 / math.log(2.0)] * len(rates), rel=1e-12)
    assert all(a < b < c for a, b, c in zip(by_second, exact, engine, strict=True))
    assert by_frame == sorted(by_frame)
    for rate, low, high in zip(rates, by_second, engine, strict=True):
        # They differ by a h (1 - d). Random frames add their variance, which is 3 % of h.
        assert high - low == pytest.approx(0.5 / rate, rel=0.05)


def test_the_integration_error_is_what_theory_says(reference: Path) -> None:
    rows = table(reference, "integration_error", "ch03_laws_of_motion")
    # The tolerance allows for 3000 roundings of numbers up to 125.
    wanted = pytest.approx(column(rows, "g t h / 2, m"), rel=1e-9)
    assert column(rows, "error, m") == wanted


def test_the_shots_land_where_they_are_known_to(reference: Path) -> None:
    rows = table(reference, "shots", "ch04_particle_engine")
    flights = {
        name: [[float(x) for x in row[2:]] for row in rows[1:] if row[0] == row[1] == name]
        for name in ("artillery", "laser", "grenade")
    }
    # At the end, the step is a t h / 2 = 0.5 m too high, so it lands at most 2 frames late.
    time, _, _, z, _ = flights["artillery"][-1]
    assert 3.0347583 - 1.0 / 60.0 < time < 3.0347583 + 2.0 / 60.0
    assert z == pytest.approx(119.557788, abs=1.5)
    time, _, _, _, kept = flights["laser"][-1]
    assert kept == pytest.approx(0.99 ** (2.0 * time), rel=1e-9)
    heights = [row[2] for row in flights["grenade"]]
    assert min(heights) == 0.0
    assert sum(row[1] == "fragment" for row in rows) > 100


def test_every_type_of_firework_is_seen_and_goes_out(reference: Path) -> None:
    rows = table(reference, "fireworks", "ch04_particle_engine")
    counts = {name: [int(row[2]) for row in rows[1:] if row[0] == name] for name, *_ in rows[1:]}
    assert [*counts] == [*map(str, range(1, 12)), "wheel"]
    assert all(max(of) > 0 for of in counts.values())
    # Type 2 leaves two fireworks of type 4, each of which leaves twelve of type 7.
    assert (counts["2"][0], max(counts["2"])) == (1, 24)


def test_the_step_comes_to_the_closed_form_in_the_first_order(reference: Path) -> None:
    rows = table(reference, "step_error", "ch04_particle_engine")
    for name in ("artillery", "fireball"):
        errors = [float(error) for shot, _, error in rows[1:] if shot == name]
        ratios = [a / b for a, b in itertools.pairwise(errors)]
        # The frame is halved. The next order changes the ratio by h / t, at most a fifteenth.
        assert ratios == pytest.approx([2.0] * len(ratios), abs=0.01)


def test_falls_end_at_the_terminal_speed(reference: Path) -> None:
    rows = table(reference, "terminal_speeds", "ch05_forces")[1:]
    ends = [[float(value) for value in row[1:]] for row in rows if row[0] == "end"]
    assert len(ends) == 3 * 17
    for k1, k2, mass, _, speed, formula in ends:
        assert k1 * formula + k2 * formula**2 == pytest.approx(mass * 9.81, rel=1e-12)
        # There are 600 frames, each of which removes at least a tenth of the difference.
        assert speed == pytest.approx(formula, rel=1e-9)


def test_the_fall_with_drag_comes_to_the_closed_form_in_the_first_order(reference: Path) -> None:
    rows = [
        [float(v) for v in row] for row in table(reference, "fall_with_drag", "ch05_forces")[1:]
    ]
    for column in (1, 3):
        off = [abs(row[column] - row[column + 1]) for row in rows]
        assert off[-2] / off[-1] == pytest.approx(2.0, abs=0.01)  # the next order is h = 0.003 s


def test_the_orbit_drifts_as_theory_says(reference: Path) -> None:
    rows = [[float(v) for v in row] for row in table(reference, "orbit", "ch05_forces")[1:]]
    for frames in (5_000, 10_000):
        seen = {row[1]: row[2:] for row in rows if row[0] == frames}
        assert seen[0.0] == pytest.approx([-0.5, math.sqrt(0.75)], rel=1e-12)
        # A step adds h^2 L / r^3, so a turn adds 2 pi h / (1 - e^2). The next order is 10 %.
        added = (2.0 * math.pi) ** 2 / frames / 0.75
        assert seen[1.0][1] - seen[0.0][1] == pytest.approx(added, rel=0.1)
        assert len(seen) == 20 * 40 + 1


def test_springs_push_where_the_page_pulls_and_ropes_are_slack(reference: Path) -> None:
    rows = table(reference, "force_against_length", "ch06_springs")[1:]
    forces = {(name, float(place)): float(force) for name, place, force in rows}
    assert forces["Spring", 1.0] == pytest.approx(10.0, rel=1e-12)  # k 10, rest 2
    assert forces["Bungee", 1.0] == 0.0
    assert forces["Bungee", 3.0] == pytest.approx(-10.0, rel=1e-12)
    assert forces["ElasticLimitSpring", 4.0] == pytest.approx(-13.0, rel=1e-12)  # 10 + 0.3 * 10
    assert forces["Buoyancy", 0.0] == pytest.approx(4.905, rel=1e-12)
    assert forces["LighterThanAir", 2.0] == pytest.approx(8.0 / math.e, rel=1e-12)


def test_the_three_regimes_are_those_of_the_formula(reference: Path) -> None:
    rows = [
        [float(v) for v in row] for row in table(reference, "three_regimes", "ch06_springs")[1:]
    ]
    exact = {(c, round(time, 6)): place for c, time, place, _ in rows}
    for c, place in ((2.0, 0.09855067), (20.0, 0.04042768), (40.0, 0.28217117)):
        assert exact[c, 0.5] == pytest.approx(place, abs=1e-8)
    assert max(abs(row[3] - row[2]) for row in rows) < 0.1


def test_each_step_explodes_where_theory_says(reference: Path) -> None:
    rows = table(reference, "stability_map", "ch06_springs")[1:]
    limits = {(row[0], float(row[1])): float(row[2]) for row in rows if row[0].endswith("limit")}
    assert len(limits) == 5 * 7 - 1
    for (name, kept), limit in limits.items():
        known = {
            "explicit Euler, limit": 1.0 / kept - 1.0,
            "semi-implicit Euler, limit": 2.0 * (1.0 + kept) / kept,
            "leapfrog, limit": 2.0 * (1.0 + kept) / kept,
            "velocity Verlet, limit": 4.0,
        }
        if name in known:
            assert limit == pytest.approx(known[name], rel=1e-9)
    assert limits["Runge-Kutta 4, limit", 1.0] == pytest.approx(8.0, rel=1e-9)
    for name in ("backward Euler", "trapezoidal rule"):
        assert all(float(row[3]) < 1.0 + 1e-12 for row in rows if row[0] == name)


def test_the_faked_spring_grows_in_windows_alone(reference: Path) -> None:
    rows = table(reference, "fake_spring", "ch06_springs")[1:]
    grown = [[float(v) for v in row[2:5]] for row in rows if row[0] == "growth"]
    assert max(value for share, _, value in grown if share == 0.0) == pytest.approx(1.13, abs=0.005)
    assert all(value < 1.0 for share, _, value in grown if share > 0.0)
    assert all(value < 1.0 + 1e-12 for share, angle, value in grown if angle < math.pi)


def test_the_energy_is_what_each_step_makes_of_it(reference: Path) -> None:
    rows = table(reference, "energy_over_time", "ch06_springs")[1:]
    energies = {name: [float(row[2]) for row in rows if row[0] == name] for name, *_ in rows}
    kappa = 100.0 / 60.0**2
    assert len(energies["explicit Euler"]) < 601  # it stops at 10,000 m/s
    for name, rate in (("explicit Euler", 1.0 + kappa), ("backward Euler", 1.0 / (1.0 + kappa))):
        steps = len(energies[name]) - 1
        assert energies[name][-1] == pytest.approx(rate**steps, rel=1e-9)
    assert energies["trapezoidal rule"][-1] == pytest.approx(1.0, rel=1e-12)
    assert energies["semi-implicit Euler"][-1] == pytest.approx(1.06, abs=0.005)  # E-17
    # From rest, leapfrog conserves kappa x^2 + (1 - kappa / 4) w^2, where w = v h, and velocity
    # Verlet conserves kappa (1 - kappa / 4) x^2 + w^2. So at x = 0 the energies are
    # 1 / (1 - kappa / 4) and 1 - kappa / 4. The step nearest to x = 0 is within 0.08 rad, where the
    # energy deviates by 0.7 % of the difference.
    most = 1.0 / (1.0 - kappa / 4.0)
    assert max(energies["leapfrog"]) - 1.0 == pytest.approx(most - 1.0, rel=0.007)
    assert min(energies["velocity Verlet"]) - 1.0 == pytest.approx(-kappa / 4.0, rel=0.007)


def test_errors_shrink_by_the_order_of_the_step(reference: Path) -> None:
    rows = table(reference, "error_against_work", "ch06_springs")[1:]
    orders = {"explicit Euler": 1, "semi-implicit Euler": 1, "leapfrog": 2, "velocity Verlet": 2}
    orders |= {"Runge-Kutta 4": 4, "backward Euler": 1, "trapezoidal rule": 2}
    for name, order in orders.items():
        errors = {int(row[3]): float(row[4]) for row in rows if row[:2] == ["100.0", name]}
        assert errors[1024] / errors[2048] == pytest.approx(2.0**order, rel=0.02)
    assert all(float(row[4]) < 1e-14 for row in rows if row[1] == "closed form")


def test_a_cloth_lasts_at_a_tenth_of_the_frames_with_the_velocity_first(reference: Path) -> None:
    rows = table(reference, "cloth_frame_rates", "ch06_springs")[1:]
    lasts = {(name, float(c), int(rate)): float(time) for name, c, rate, time in rows}
    for c in (0.0, 0.2):
        assert lasts["semi-implicit Euler", c, 90] == 2.0
        assert lasts["semi-implicit Euler", c, 75] < 1.0
        assert lasts["explicit Euler", c, 960] < 2.0


def test_a_ground_of_springs_throws_the_higher_the_stiffer_it_is(reference: Path) -> None:
    rows = table(reference, "penalty_bounces", "ch06_springs")[1:]
    rises = [(float(row[1]), float(row[3])) for row in rows if row[0] == "rise / fall"]
    assert rises[0][1] < 1.02  # at k h^2 / m = 0.03
    assert 3.0 < rises[-1][1] <= 1.0 / (1.0 - rises[-1][0] / 4.0)  # at 3.6, the square of E-36


def test_where_no_watch_is_written_an_explosion_is_drawn_all_the_same(tmp_path: Path) -> None:
    copy_tree(ROOT / "solutions", tmp_path / "engine")
    with (tmp_path / "engine/ch06_springs/integrators.py").open("a", encoding="utf-8") as file:
        file.write("\n\ndef watched(*_):\n    raise NotImplementedError('Exercise B6.10')\n")
    done = plot(tmp_path / "engine", tmp_path, "6", only=("energy_over_time", "cloth_frame_rates"))
    assert done.returncode == 0, done.stdout


def test_springs_that_are_not_written_are_said(tmp_path: Path) -> None:
    copy_tree(ROOT / "solutions", tmp_path / "engine")
    for module in ("springs", "other_forces", "integrators", "own_step", "closed_form"):
        path = f"ch06_springs/{module}.py"
        text = made_stubs()[f"chapters/{path}"]
        (tmp_path / "engine" / path).write_text(text, encoding="utf-8")
    done = plot(tmp_path / "engine", tmp_path, "6")
    assert done.returncode == 1
    assert done.stdout.count("not drawn, not written yet: Exercise B6.") == 8
    assert not [*tmp_path.glob("ch06_springs/*")]


@pytest.mark.parametrize("result", ["None", "(math.nan, math.inf)"])
def test_steps_that_do_nothing_or_return_nonsense_give_pictures(
    result: str, tmp_path: Path
) -> None:
    copy_tree(ROOT / "solutions", tmp_path / "engine")
    folder = tmp_path / "engine/ch06_springs"
    with (folder / "integrators.py").open("a", encoding="utf-8") as file:
        file.write(f"\n\nexplicit_euler = leapfrog = velocity_verlet = lambda *_: {result}\n")
        file.write(f"semi_implicit_euler = runge_kutta_4 = watched = lambda *_: {result}\n")
        file.write(f"backward_euler = trapezoidal = lambda *_: {result}\n")
    with (folder / "closed_form.py").open("a", encoding="utf-8") as file:
        file.write(f"\n\ndamped_spring_state = lambda *_: {result}\n")
    done = plot(tmp_path / "engine", tmp_path, "6")
    assert done.returncode == 0, done.stdout
    assert "Traceback" not in done.stderr


def test_an_engine_with_the_equation_s_damping_draws_another_picture(
    reference: Path, tmp_path: Path
) -> None:
    done = plot("sample_class/cleo", tmp_path, "3")  # her form is v d^h + a h, not (v + a h) d^h
    assert (tmp_path / "ch03_laws_of_motion/integration_error.png").exists(), done.stdout
    tables = [
        table(out, "damping_comparison", "ch03_laws_of_motion") for out in (tmp_path, reference)
    ]
    mine, right = (column(rows, "loss: the engine, (v + a h) d^h") for rows in tables)
    by_equation = column(tables[0], "loss: Eq. 3.6, v d^h + a h")
    assert mine == pytest.approx(by_equation, rel=1e-12)
    assert mine != pytest.approx(right, rel=1e-3)


def test_a_wrong_engine_gives_a_wrong_picture(reference: Path, tmp_path: Path) -> None:
    done = plot("sample_class/cleo", tmp_path)  # her vector product has a wrong sign
    assert done.returncode == 0, done.stdout
    assert table(tmp_path, "addition") == table(reference, "addition")
    assert table(tmp_path, "basis") != table(reference, "basis")
    assert table(tmp_path, "projection") == table(reference, "projection")
    wrong, right = (out / "ch02_vectors/basis.png" for out in (tmp_path, reference))
    assert wrong.read_bytes() != right.read_bytes()


def test_a_wrong_difference_is_seen_in_the_projection(reference: Path, tmp_path: Path) -> None:
    folder = tmp_path / "engine/ch02_vectors"
    copy_tree(ROOT / "solutions/ch02_vectors", folder)
    with (folder / "vector.py").open("a", encoding="utf-8") as file:
        file.write("\n\nVector3.__sub__ = lambda self, v: v + -self\n")
    assert plot(tmp_path / "engine", tmp_path).returncode == 0
    wrong, right = (out / "ch02_vectors/projection.png" for out in (tmp_path, reference))
    assert wrong.read_bytes() != right.read_bytes()


@pytest.mark.parametrize("result", ["None", "Vector3(math.nan, math.inf, 0.0)", "'text'"])
def test_an_engine_that_returns_nonsense_still_gives_a_picture(result: str, tmp_path: Path) -> None:
    folder = tmp_path / "engine/ch02_vectors"
    copy_tree(ROOT / "solutions/ch02_vectors", folder)
    with (folder / "vector.py").open("a", encoding="utf-8") as file:
        file.write(f"\n\nVector3.__add__ = lambda self, v: {result}\n")
        file.write(f"\n\nVector3.cross = lambda self, v: {result}\n")
    done = plot(tmp_path / "engine", tmp_path)
    assert (tmp_path / "ch02_vectors/addition.png").exists(), done.stdout
    assert (tmp_path / "ch02_vectors/cross_product.png").exists(), done.stdout
    assert "Traceback" not in done.stderr


def test_what_is_not_written_is_said_and_leaves_no_older_picture(tmp_path: Path) -> None:
    old = tmp_path / "ch02_vectors/addition.png"
    old.parent.mkdir()
    old.write_bytes(b"an older picture")
    stubs = tmp_path / "stubs/ch02_vectors"
    stubs.mkdir(parents=True)
    (stubs / "vector.py").write_text(
        "class Vector3:\n    def __init__(self, *_): ...\n    def __add__(self, v):\n"
        "        raise NotImplementedError('Exercise B2.5: Add and subtract')\n\n\n"
        "def make_orthonormal_basis(a, b): return a, b, a\n",
        encoding="utf-8",
    )
    done = plot(tmp_path / "stubs", tmp_path)
    assert done.returncode == 1
    assert "addition: not drawn, not written yet: Exercise B2.5" in done.stdout
    assert not old.exists()
    assert "projection: not drawn, AttributeError: 'Vector3' object has no" in done.stdout


def test_an_engine_that_cannot_be_read_is_one_sentence(tmp_path: Path) -> None:
    done = plot("sample_class/dina", tmp_path)
    assert done.returncode == 1
    assert "chapter 2 cannot be drawn: SyntaxError: '(' was never closed" in done.stdout
    assert "(sample_class/dina/ch02_vectors/vector.py, line " in done.stdout
    assert "Traceback" not in done.stdout + done.stderr


def test_a_mistake_on_the_command_line_is_a_clear_sentence(tmp_path: Path) -> None:
    done = plot("nowhere", tmp_path)
    assert done.returncode == 2
    assert "engine must be a folder of chapters, got 'nowhere'" in done.stderr
