"""Plots of the reference show what theory says, and each has its numbers beside it."""

from __future__ import annotations

import csv
import math
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from matplotlib import pyplot
from matplotlib.text import Text

from autograder.manifest import ROOT, load_chapters
from plots.draw import draw, plots_of
from plots.drawing import Picture

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
    # Two positions are wrong by up to 0.5 mm each, 60 times per second: 0.06 m/s, and then four.
    "ch02_vectors/filmed_motion": (
        r"height is off\nby at most 0.000[45]\d? m",
        r"velocity is off\nby at most 0.0[45]\d* m/s",
        r"acceleration is off\nby at most [456]\.\d m/s",
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
    "ch06_springs/three_regimes": ("2 N s/m: under", r"up to 0\.0\d+, 0\.0\d+, 0\.0\d+ m"),
    "ch06_springs/stability_map": (
        f"theory by a fraction of at most {TINY}",
        "backward Euler: at most x 0.99",
        "trapezoidal rule: at most x 1.0000",
    ),
    # The true factors are e^(-c h / 2), the period is 2 pi / 20 s. The faked one grows
    # most beyond a phase of pi per step.
    "ch06_springs/fake_spring": (
        "True: x 1.0000 per frame, period 0.314 s",
        "True: x 0.9672",
        r"no damping: at most x 1.129, at \S+ h = 3\.[2-9]",
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
    "ch06_springs/penalty_bounces": ("0.0556: up to 1.00 m", r"one rises [3-9]\.\d times"),
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
        "10 links sink by 0.036 and 0.00018 m",
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
        f"{chapter.name}/{plot}" for chapter in load_chapters() for plot in plots_of(chapter.name)
    }
    assert plots == {*SAYS}


@pytest.mark.parametrize("name", SAYS)
def test_a_plot_says_what_theory_says_and_has_its_numbers_beside_it(
    name: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    chapter, _, plot = name.partition("/")
    made: list[Picture] = []

    def drawn() -> Picture:
        made.append(plots_of(chapter)[plot]())
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
    figure, width = picture.figure, picture.figure.bbox.x1
    titles_seen = [*figure.texts, *(axes.title for axes in figure.axes)]
    ends = [text.get_window_extent() for text in titles_seen if text.get_text()]
    assert [end for end in ends if end.x0 < -1.0 or end.x1 > width + 1.0] == [], "a title is cut"
    pyplot.close("all")


# Numbers that are in the pictures and tables alone


def rows_of(plot: str) -> Iterator[list[Any]]:
    """Yield the rows of a plot's table."""
    chapter, _, name = plot.partition("/")
    yield from plots_of(chapter)[name]().rows
    pyplot.close("all")


def test_the_artillery_shell_lands_where_it_is_known_to() -> None:
    *_, (_, _, time, _, _, z, _) = [
        row for row in rows_of("ch04_particle_engine/shots") if row[1] == "artillery"
    ]
    # At the end, the step is a t h / 2 = 0.5 m too high, so it lands at most 2 frames late.
    assert 3.0347583 - 1.0 / 60.0 < time < 3.0347583 + 2.0 / 60.0
    assert z == pytest.approx(119.557788, abs=1.5)


def test_ropes_are_slack_and_a_spring_gets_softer_beyond_its_limit() -> None:
    rows = rows_of("ch06_springs/force_against_length")
    forces = {(name, place): force for name, place, force in rows}
    assert forces["Bungee", 1.0] == 0.0
    assert forces["Bungee", 3.0] == pytest.approx(-10.0, rel=1e-12)  # k 10, rest 2
    assert forces["ElasticLimitSpring", 4.0] == pytest.approx(-13.0, rel=1e-12)  # 10 + 0.3 * 10


def test_the_rates_near_gimbal_lock_are_those_of_theory() -> None:
    rows = rows_of("ch09_rotations/gimbal_lock")
    rates = {90.0 - y: rate for what, y, rate in rows if what.startswith("rates")}
    assert len(rates) == 32
    for left, rate in rates.items():  # the difference of angles has 8 digits at least
        wanted = 1.0 / (math.sqrt(2.0) * math.sin(math.radians(0.5 * left)))
        assert rate == pytest.approx(wanted, rel=1e-7)


def test_a_plot_that_does_not_end_says_in_which_line_it_was(tmp_path: Path) -> None:
    (tmp_path / "loop.py").write_text("def endless():\n    while True: pass\n", encoding="utf-8")
    code = f"import sys; sys.path.append({str(ROOT)!r}); from plots.draw import draw; "
    code += "from pathlib import Path; from loop import endless; draw(endless, Path(), 0.5)"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, encoding="utf-8"
    )
    assert "endless: not finished after 0.5 s, at loop.py, line 2." in done.stdout
    assert (done.returncode, done.stderr) == (1, "")
