"""Plots of the reference show what theory says. With any other engine they say what is wrong."""

from __future__ import annotations

import csv
import importlib
import math
import re
from pathlib import Path
from subprocess import CompletedProcess

import pytest
from matplotlib import pyplot
from matplotlib.text import Text

from autograder.manifest import ROOT, load_chapters
from copies import copy_tree
from made import made_stubs
from studied import study
from studies.drawing import Picture
from studies.plot import draw

TINY = r"(0(?![.\d])|\d\S*e-1\d(?!\d))"  # an error of rounding
# What each plot says in its titles and legends, as regular expressions. The comments say where the
# numbers come from.
SAYS: dict[str, tuple[str, ...]] = {
    "ch02_vectors/addition": ("ends at the far corner",),
    "ch02_vectors/projection": ("between a and d is 90°",),
    "ch02_vectors/cross_product": (
        "90° to a, 90° to b and\n0° to its",
        f"differ by at most {TINY}",
    ),
    "ch02_vectors/basis": (
        "right-handed basis, with angles of 90°, 90°, 90°\nand lengths of 1, 1, 1",
    ),
    # A velocity loses 1 - (1 - D) / -ln D, and D is 0.5^(1/4) at 15 Hz and 0.5^4 at 240 Hz.
    "ch03_laws_of_motion/damping_comparison": (
        "8 % at 15 Hz, 66 % at 240 Hz",
        "opposite sides;\n.* power (0.99|1.00) and (0.99|1.00)",
    ),
    # The position lags by g t h / 2, with t = 5 s or 3.2 s.
    "ch03_laws_of_motion/integration_error": ("power 1.000\nand is 0.409 m at 60 steps",),
    "ch03_laws_of_motion/trajectories": ("up to 1.57 m without damping",),
    # Drag leaves 0.99^2t of the laser's energy after 2 s. An artillery shell has 200 kg and 50 m/s.
    "ch04_particle_engine/shots": ("laser has 96 %", "artillery: .* 250,000 J", "grenade has"),
    # Type 2 leaves two fireworks of type 4, each of which leaves twelve of type 7.
    "ch04_particle_engine/fireworks": ("11 types and a wheel", "type 2: at most 24 burning"),
    "ch04_particle_engine/step_error": (r"1.000 \(artillery\) and 1.000 \(fireball\)",),
    # k1 v + k2 v^2 is the weight.
    "ch05_forces/terminal_speeds": (
        f"error of at most {TINY}",
        "1.00 with k1 alone and 0.50 with k2 alone",
    ),
    "ch05_forces/fall_with_drag": (r"power (0.99|1.00)\d and (0.99|1.00)\d",),
    # A turn adds 2 pi h / (1 - e^2), with h = 2 pi / 5000 and e = 0.5.
    "ch05_forces/orbit": (r"adds 0.0104 .*\(theory 0.0105\),\n0.00522 with",),
    "ch05_forces/cost_of_a_generator": (r"a generator takes \d",),
    # The forces are k (2 m - 1 m) with k = 10 N/m, half of 9.81 N, and 8 N / e.
    "ch06_springs/force_against_length": (
        r"\+10 N, the printed formula -10 N",
        "4.905 of 9.81 N",
        "2.943 of 8 N",
    ),
    "ch06_springs/three_regimes": ("2 N s/m: under", "20 N s/m: critical", "40 N s/m: over"),
    "ch06_springs/stability_map": (
        f"theory by a fraction of at most {TINY}",
        "backward Euler: at most x 0.99",
        "trapezoidal rule: at most x 1.0000",
    ),
    # The true factors are e^(-c h / 2), the period is 2 pi / 20 s. The last limit is known.
    "ch06_springs/fake_spring": (
        "True: x 1.0000 per frame, period 0.314 s",
        "True: x 0.9672",
        "no damping: at most x 1.129",
        "critical damping: at most x 0.99",
    ),
    # With k h^2 / m = z = 1/36, each step multiplies the energy by 1 + z, or divides it. For
    # leapfrog and Verlet it oscillates by z / 4, and for semi-implicit Euler by sqrt(z) / 2.
    "ch06_springs/energy_over_time": (
        r"explicit Euler: energy x 1.0278 per step, which is x 1.38e\+07 in 10 s",
        "backward Euler: energy x 0.9730 per step",
        "semi-implicit Euler: at most 0.09",
        "leapfrog: at most 0.007\n",
        "velocity Verlet: at most 0.007\n",
        f"trapezoidal rule: at most {TINY}",
        "explicit Euler stopped with SimulationDiverged",
    ),
    "ch06_springs/error_against_work": (
        r"explicit Euler 1.00\d, semi-implicit Euler 1.00\d, leapfrog 2.000, velocity Verlet 2.000,"
        r"\nRunge-Kutta 4 4.00\d, backward Euler (0.99|1.00)\d, trapezoidal rule 2.000",
    ),
    # It is safe from sqrt(8 k / m) / 2 = 89.4 Hz on; a falling cloth is slightly less stiff.
    "ch06_springs/cloth_frame_rates": (
        "explicit Euler, c = 0 N s/m: always explodes",
        "semi-implicit Euler, c = 0 N s/m: stable from (82|85|90) Hz",
    ),
    "ch06_springs/penalty_bounces": ("0.0556: up to 1.00 m", "over 5 % higher than they fell"),
    # A fall takes sqrt(0.4) s and each flight half of the one before: sqrt(0.4) (1 + 2) s in all.
    "ch07_constraints/bounce_heights": (
        "explicit Euler: up to 2.750 m",
        "time division: up to 2.000 m",
        "impacts end after 1.8973666 s",
    ),
    # Known heights of the jitter; the bounce is 0.9^2 of the fall.
    "ch07_constraints/resting_jitter": (
        "with resting rule 1.39 mm, with no rule 5.56 mm",
        "with resting rule 2.75 mm, with no rule 137 mm",
        r"bounce 32.3, .* 0 mm \(theory 32.4\)",
    ),
    # The pile begins with 1 m/s and 0.01 m. The worst contact first is the better order.
    "ch07_constraints/resolver_convergence": (
        r"of 22 contacts, after 100 resolutions:\nworst first 0.05 m/s, in list order 0.07",
        r"of 22 contacts, after 100 resolutions:\nworst first 0.0014 m, in list order 0.003",
    ),
    "ch07_constraints/stack_height": (r"up to 1.1 % \(default\)", r"\d\d % \(default\), \d %"),
    "ch07_constraints/rope_by_method": (
        r"DirectChain: at most \S+e-\d\d m",
        r"TwoSidedRod, 8 substeps: at most 0\.\d",
    ),
    "ch07_constraints/rods_hold": ("16 substeps: 0.0017 m for 10", "16 substeps: 0.00029 m for 10"),
    "ch07_constraints/pendulum_energy": (r"DirectChain, 60 Hz: (9.99|10)\d* J", "960 Hz: 8.6"),
    "ch07_constraints/restitution_of_materials": ("10 drops in drops.csv. .* within 0.081 %",),
    "ch08_mass_aggregate/energy_of_bridge": ("all energies but 30 Hz, default iterations vary by",),
    "ch08_mass_aggregate/energy_of_platform": ("all energies vary by less than 0.1 %",),
    "ch08_mass_aggregate/mass_ratios": ("iterations: fails at 100", "16 substeps: holds at 1000"),
    # The catenary's sag is SciPy's.
    "ch08_mass_aggregate/hanging_rope": (
        "catenary: sag 1.00527 m",
        r"DirectChain by -?\de-(09|1\d) m",
    ),
    "ch08_mass_aggregate/variable_frames": (
        "(?s)even frames with an error of 0 m.*even frames with an error of 0 m",
        "bridge: down to 2.51 m in even frames, to 0.5 m in uneven",
    ),
    # By Lagrange's equations it throws 99.6 m at 27 degrees. The machine throws 4 % less.
    "ch08_mass_aggregate/trebuchet_range": (
        "my_design throws 95",
        r"400 kg: at best 95\S* m at 27",
    ),
    # The spin follows w' = 10 - w^3 h / 2 for 2 s.
    "ch08_mass_aggregate/wheel_deformation": ("48 % at 60 Hz, 25 % at 240 Hz, 8.9 % at 960 Hz",),
    "ch08_mass_aggregate/blob_bonds": (
        "dropped, without cables: at least 45, finally 45",
        "18 m/s, without cables: at least 42, finally 45",
    ),
    # 720 frames of nine balls.
    "ch08_mass_aggregate/sleeping_balls": (
        r"ParticleWorld 6,480 and 2.*SleepingWorld 2,\d+ and 5",
    ),
    "ch09_rotations/turning_motion": (
        f"right angles off by up to {TINY}°, lengths by {TINY}",
        "0.892°, 0.446° and 0.223° .* order 1.00 in the step",
    ),
    "ch09_rotations/order_of_turns": ("by quaternions 120°, by matrices 120°",),
    # The length of Eq. 9.5 is (1 + (pi / 60)^2)^90 (E-31).
    "ch09_rotations/drift_of_first_order": (
        "60 Hz: 1.279 after 3 s",
        f"(?s)lines. by at most {TINY},.* measurement by {TINY}\n.* measurement by {TINY}°",
        "Eq. 9.5: order 2.00",
        f"steady axis, rotate_by: at most {TINY}°",
        "moving axis, rotate_by: order 1.00",
        "mid-step velocity: order 2.00",
    ),
    "ch09_rotations/gimbal_lock": (f"by at most {TINY}", "slope -1.0000", "for 12 of 12 angles"),
    "ch09_rotations/balance_lines": (
        f"(?s)by at most {TINY} m,.* at most {TINY} N m",
        "0.212 kg on the left, 0.95 kg on the right",
    ),
}


def test_each_plot_is_tested() -> None:
    plots = {
        f"{chapter.name}/{plot.__name__}"
        for chapter in load_chapters()
        for plot in importlib.import_module(f"lab.plots.{chapter.name}").PLOTS
    }
    assert plots == {*SAYS}


@pytest.mark.parametrize("name", SAYS)
def test_a_plot_says_what_theory_says_and_has_its_numbers_beside_it(
    name: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    chapter, _, plot = name.partition("/")
    made: list[Picture] = []

    def drawn() -> Picture:
        made.append(getattr(importlib.import_module(f"lab.plots.{chapter}"), plot)())
        return made[0]

    drawn.__name__ = plot
    pyplot.switch_backend("Agg")
    assert draw(drawn, tmp_path)
    assert re.search(rf"{plot}: \S*{plot}.png and \S*{plot}.csv\n", capfd.readouterr().out)
    assert len((tmp_path / f"{plot}.png").read_bytes()) > 10_000, "an empty picture"
    [picture] = made
    with (tmp_path / f"{plot}.csv").open(encoding="utf-8", newline="") as file:
        titles, *rows = csv.reader(file)
    assert titles == [*picture.columns]
    assert rows == [[str(value) for value in row] for row in picture.rows]
    assert len(rows) > 2
    words = "".join(f"{text.get_text()}\n" for text in picture.figure.findobj(Text))
    assert [said for said in SAYS[name] if not re.search(said, words)] == [], words
    pyplot.close("all")


def test_the_rates_near_gimbal_lock_are_those_of_theory() -> None:
    """The title of the plot has their slope alone."""
    rows = importlib.import_module("lab.plots.ch09_rotations").gimbal_lock().rows
    rates = {90.0 - y: rate for what, y, rate in rows if what.startswith("rates")}
    assert len(rates) == 32
    for left, rate in rates.items():  # the difference of angles has 8 digits at least
        wanted = 1.0 / (math.sqrt(2.0) * math.sin(math.radians(0.5 * left)))
        assert rate == pytest.approx(wanted, rel=1e-7)
    pyplot.close("all")


# Engines other than the reference, drawn by the command


def plot(
    engine: str | Path, out: Path, chapter: str, only: tuple[str, ...] = ()
) -> CompletedProcess[str]:
    """Draw the plots of a chapter with an engine, or only those that ``only`` names."""
    number = str(int(chapter[2:4]))
    return study("plot", "--chapter", number, "--engine", str(engine), "--out", str(out), only=only)


def engine_with(chapter: str, added: dict[str, str], at: Path) -> Path:
    """Return a copy of the reference with lines appended to some modules of a chapter."""
    copy_tree(ROOT / "solutions", at / "engine")
    for module, lines in added.items():
        with (at / "engine" / chapter / f"{module}.py").open("a", encoding="utf-8") as file:
            file.write(f"\n\n{lines}\n")
    return at / "engine"


def series(out: Path, chapter: str, name: str, column: int) -> list[str]:
    """Return the different values in a column of the table beside a plot."""
    with (out / chapter / f"{name}.csv").open(encoding="utf-8", newline="") as file:
        return [*dict.fromkeys(row[column] for row in [*csv.reader(file)][1:])]


NOTHING = "raise NotImplementedError('Exercise B9.9')"
# For each chapter, functions that do nothing, return nonsense or raise an error.
NONSENSE = [
    (
        "ch02_vectors",
        {
            "vector": """\
Vector3.__add__ = lambda *_: None
Vector3.__sub__ = lambda *_: 'text'
Vector3.cross = lambda *_: Vector3(math.nan, math.inf, 0.0)"""
        },
    ),
    (
        "ch06_springs",
        {
            "integrators": """\
explicit_euler = trapezoidal = watched = lambda *_: None
backward_euler = lambda *_: (math.nan, math.inf)""",
            "closed_form": "damped_spring_state = lambda *_: (math.nan, math.inf)",
        },
    ),
    (
        "ch07_constraints",
        {
            "contacts": "Contact.separating_velocity = lambda *_: float('nan')",
            "detectors": "GroundPlane.next_impact = lambda *_: None",
            "exercises": "def table_of_drops(drops): return []",
        },
    ),
    (
        "ch09_rotations",
        {
            "quaternion": """\
def _refuse(*_):
    raise ValueError('no')


Quaternion.from_axis_angle = staticmethod(lambda *_: None)
Quaternion.add_scaled = _refuse
Quaternion.rotate_by = Quaternion.rotate = lambda *_: float('nan')""",
            "matrix": "Matrix3.product = Matrix3.from_quaternion = lambda *_: None",
            "euler": "rate_map = euler_rates = lambda *_: (float('nan'), float('inf'))",
            "angular": "integrate_rotation = first_order_drift = lambda *_: None",
            "exercises": "balance_offset = masses_beside = lambda *_: float('nan')",
        },
    ),
]


@pytest.mark.parametrize(("chapter", "wrong"), NONSENSE, ids=[name for name, _ in NONSENSE])
def test_an_engine_of_nonsense_gives_pictures(
    chapter: str, wrong: dict[str, str], tmp_path: Path
) -> None:
    done = plot(engine_with(chapter, wrong, tmp_path), tmp_path, chapter)
    assert done.returncode == 0, done.stdout + done.stderr
    assert not done.stderr
    pictures = {path.stem for path in (tmp_path / chapter).glob("*.png")}
    assert pictures == {name.partition("/")[2] for name in SAYS if chapter in name}


# These need only modules that are given.
NEED_NO_EXERCISE = {"rope_by_method", "pendulum_energy", "hanging_rope"}


@pytest.mark.parametrize("chapter", [chapter.name for chapter in load_chapters()])
def test_a_plot_of_stubs_names_the_exercise_to_write(chapter: str, tmp_path: Path) -> None:
    engine = engine_with(chapter, {}, tmp_path)
    for path, text in made_stubs().items():
        if path.startswith(f"chapters/{chapter}/"):
            (engine / path.removeprefix("chapters/")).write_text(text, encoding="utf-8")
    done = plot(engine, tmp_path, chapter)
    assert done.returncode == 1
    said = re.findall(
        rf"(?m)^(\w+): not drawn, not written yet: Exercise [BP]?{chapter[3]}\.", done.stdout
    )
    plots = {name.partition("/")[2] for name in SAYS if chapter in name}
    assert {*said} == plots - NEED_NO_EXERCISE, done.stdout
    assert {path.stem for path in (tmp_path / chapter).glob("*.png")} == plots & NEED_NO_EXERCISE


def test_a_curve_that_is_not_written_is_left_out(tmp_path: Path) -> None:
    stub = f"def _stub(*_):\n    {NOTHING}\n\n\n"
    added = {
        "matrix": f"{stub}Matrix3.from_quaternion = _stub",
        "quaternion": f"{stub}Quaternion.rotate_by = _stub",
        "euler": f"{stub}euler_rates = _stub",
        "angular": f"{stub}first_order_drift = _stub",
    }
    done = plot(engine_with("ch09_rotations", added, tmp_path), tmp_path, "ch09_rotations")
    assert re.findall(r"(\w+): not drawn, (.*)", done.stdout) == [
        ("turning_motion", "not written yet: Exercise B9.9")
    ]
    assert series(tmp_path, "ch09_rotations", "order_of_turns", 2) == ["quaternions"]
    assert series(tmp_path, "ch09_rotations", "drift_of_first_order", 1) == [
        "Eq. 9.5",
        "steady axis, Eq. 9.5",
        "steady axis, Eq. 9.5, normalized",
        "moving axis, Eq. 9.5, normalized",
    ]
    assert len(series(tmp_path, "ch09_rotations", "gimbal_lock", 0)) == 3


def test_an_explosion_is_drawn_even_if_no_watch_is_written(tmp_path: Path) -> None:
    engine = engine_with(
        "ch06_springs", {"integrators": f"def watched(*_):\n    {NOTHING}"}, tmp_path
    )
    only = ("energy_over_time", "cloth_frame_rates")
    done = plot(engine, tmp_path, "ch06_springs", only)
    assert done.returncode == 0, done.stdout


def test_a_plot_that_fails_leaves_no_older_picture_and_says_why(tmp_path: Path) -> None:
    old = tmp_path / "ch02_vectors/addition.png"
    old.parent.mkdir()
    old.write_bytes(b"an older picture")
    wrong = f"def _stub(*_):\n    {NOTHING}\n\n\nVector3.__add__ = _stub\ndel Vector3.dot"
    done = plot(engine_with("ch02_vectors", {"vector": wrong}, tmp_path), tmp_path, "ch02_vectors")
    assert done.returncode == 1
    assert "addition: not drawn, not written yet: Exercise B9.9" in done.stdout
    assert not old.exists()
    assert "projection: not drawn, AttributeError: 'Vector3' object has no" in done.stdout


def test_a_plot_without_the_student_s_drops_shows_the_sample(tmp_path: Path) -> None:
    engine = engine_with("ch07_constraints", {}, tmp_path)
    (engine / "ch07_constraints/drops.csv").write_text(
        "material,initial_height,bounce_height\n", encoding="utf-8"
    )
    done = plot(engine, tmp_path, "ch07_constraints", only=("restitution_of_materials",))
    assert done.returncode == 0, done.stdout
    with (tmp_path / "ch07_constraints/restitution_of_materials.csv").open() as file:
        assert sum(line.startswith("drop,") for line in file) == 13


def test_a_plot_without_stones_says_so(tmp_path: Path) -> None:
    engine = engine_with("ch09_rotations", {}, tmp_path)
    (engine / "ch09_rotations/stones.csv").write_text("what,mass,x,y\n", encoding="utf-8")
    done = plot(engine, tmp_path, "ch09_rotations", only=("balance_lines",))
    assert done.returncode == 1
    assert "balance_lines: not drawn, ValueError: there are no stones in stones.csv" in done.stdout


def test_an_engine_that_cannot_be_read_is_one_sentence(tmp_path: Path) -> None:
    done = plot("sample_class/dina", tmp_path, "ch02_vectors")
    assert done.returncode == 1
    assert "chapter 2 cannot be drawn: SyntaxError: '(' was never closed" in done.stdout
    assert "(sample_class/dina/ch02_vectors/vector.py, line " in done.stdout
    assert "Traceback" not in done.stdout + done.stderr


def test_a_mistake_on_the_command_line_is_a_clear_sentence(tmp_path: Path) -> None:
    done = plot("nowhere", tmp_path, "ch02_vectors")
    assert done.returncode == 2
    assert "engine must be a folder of chapters, got 'nowhere'" in done.stderr
