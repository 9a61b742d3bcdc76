"""The pictures of chapter 9 agree with theory, and show a wrong or unfinished engine."""

from __future__ import annotations

import math
from collections import defaultdict
from itertools import pairwise
from pathlib import Path

import pytest

import drawn_plots
from drawn_plots import engine_with, plot_of_stubs
from studies.readings import dot

CHAPTER = "ch09_rotations"
PLOTS = 5


def table(out: Path, name: str) -> list[list[str]]:
    return drawn_plots.table(out, name, CHAPTER)[1:]


def errors(out: Path) -> dict[str, list[float]]:
    """Return each method's final error in degrees, starting with the longest step."""
    found = defaultdict(list)
    for what, way, _, _, value in table(out, "drift_of_first_order"):
        if what == "error":
            found[way].append(float(value))
    return found


def ends(out: Path) -> dict[tuple[str, str], list[list[float]]]:
    """Return the final axes of the L by order of rotations and by method."""
    found = defaultdict(list)
    for order, state, how, _, *v in table(out, "order_of_turns"):
        if state.startswith("then"):
            found[order, how].append([float(value) for value in v])
    return found


def test_the_disc_turns_and_stays_stiff(reference: Path) -> None:
    rows = [[float(value) for value in row] for row in table(reference, "turning_motion")]
    tilt, precession = math.radians(25.0), 2.0 * math.pi * 0.9
    worst: dict[float, float] = defaultdict(float)
    for rate, time, *_, off in rows:
        worst[rate] = max(worst[rate], off)
        assert 0.0 <= time <= 1.2
    for row in rows:
        axes = row[5:8], row[8:11], row[11:14]
        for i, a in enumerate(axes):
            for j, b in enumerate(axes):
                assert dot(a, b) == pytest.approx(float(i == j), abs=1e-12)
        angle = precession * row[1]  # about Y, from X to -Z
        spun = (math.cos(angle), 1.0 / math.tan(tilt), -math.sin(angle))
        # 0.016 is 0.9 degrees.
        assert axes[1] == pytest.approx([math.sin(tilt) * c for c in spun], abs=0.016)
    # The method is of order 1, so half the step gives half the error.
    assert worst[120.0] / worst[240.0] == pytest.approx(2.0, abs=0.02)
    assert worst[240.0] / worst[480.0] == pytest.approx(2.0, abs=0.02)


def test_the_two_orders_end_120_degrees_apart(reference: Path) -> None:
    known = {"XY": [(0, 0, -1), (1, 0, 0), (0, -1, 0)], "YX": [(0, 1, 0), (0, 0, 1), (1, 0, 0)]}
    found = ends(reference)
    for (order, _), axes in found.items():
        for v, wanted in zip(axes, known[order], strict=True):
            assert v == pytest.approx(wanted, abs=1e-15)
    assert len(found) == 4
    for how in ("quaternions", "matrices"):
        pairs = zip(found["XY", how], found["YX", how], strict=True)
        trace = sum(dot(a, b) for a, b in pairs)
        assert math.degrees(math.acos((trace - 1.0) / 2.0)) == pytest.approx(120.0, abs=1e-9)


def test_the_length_grows_as_e31_has_it(reference: Path) -> None:
    seen = 0
    for what, way, rate, time, value in table(reference, "drift_of_first_order"):
        if what == "length":
            n, half = round(float(time) * int(rate)), math.pi / int(rate)
            wanted = (1.0 + half * half) ** (n / 2.0) if way == "Eq. 9.5" else 1.0
            assert float(value) == pytest.approx(wanted, rel=1e-12)
            if (way, rate, n) == ("Eq. 9.5", "60", 60):
                assert round(float(value), 4) == 1.0856
            seen += 1
    assert seen == 3 * (30 + 60 + 120 + 240 + 30) + 5


def test_each_way_to_step_has_its_order(reference: Path) -> None:
    off = errors(reference)
    steady, moving = (f"{which} axis, " for which in ("steady", "moving"))
    for i, bare in enumerate(off[f"{steady}Eq. 9.5"]):
        rate = 10 * 2**i
        half = math.pi / rate
        lacking = math.degrees(2.0 * (0.7 * rate) * (half - math.atan(half)))
        assert bare == pytest.approx(lacking, abs=1e-11)
        assert off[f"{steady}Eq. 9.5, normalized"][i] == pytest.approx(bare, abs=1e-11)
    assert max(off[f"{steady}rotate_by"]) < 1e-11
    orders = {
        f"{steady}Eq. 9.5": 2,
        f"{moving}Eq. 9.5, normalized": 1,
        f"{moving}rotate_by": 1,
        f"{moving}rotate_by, mid-step velocity": 2,
    }
    for way, order in orders.items():
        # The next order changes the ratios by a hundredth at steps of 1/320 s.
        ratios = [a / b for a, b in pairwise(off[way][-4:])]
        assert ratios == pytest.approx([2.0**order] * 3, rel=0.02), way


def test_a_direction_is_lost_at_90_degrees(reference: Path) -> None:
    seen = defaultdict(int)
    for what, y, value in table(reference, "gimbal_lock"):
        sine = abs(math.sin(math.radians(float(y))))
        if what == "rates, rad/s":
            left = math.radians(90.0 - float(y))  # the difference has 8 digits at least
            wanted = 1.0 / (math.sqrt(2.0) * math.sin(0.5 * left))
            assert float(value) == pytest.approx(wanted, rel=1e-7)
        else:
            values = {"largest": 1.0 + sine, "middle": 1.0, "smallest": 1.0 - sine}
            assert float(value) ** 2 == pytest.approx(values[what.split()[0]], abs=1e-14)
        seen[what] += 1
    assert sorted(seen.values()) == [32, 61, 61, 61]


def test_the_box_balances_on_unequal_masses(reference: Path) -> None:
    rows = table(reference, "balance_lines")
    stones = [[float(value) for value in row[2:]] for row in rows if row[0] == "stone"]
    total = sum(mass for mass, _, _ in stones)
    middle = [sum(stone[0] * stone[i] for stone in stones) / total for i in (1, 2)]
    lines = {int(row[1]): [float(value) for value in row[2:]] for row in rows if row[0] == "line"}
    assert [*lines] == [*range(0, 181, 3)]
    for angle, (offset, left, right, miss, torque) in lines.items():
        along = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        assert offset == pytest.approx(along[0] * middle[1] - along[1] * middle[0], abs=1e-15)
        assert left + right == pytest.approx(total, rel=1e-12)
        assert miss < 1e-15
        assert torque < 1e-14
    assert lines[150][1:3] == pytest.approx([0.212, 0.95])


def test_stubs_are_said(tmp_path: Path) -> None:
    printed = plot_of_stubs(CHAPTER, tmp_path)
    assert printed.count("not drawn, not written yet: Exercise ") == PLOTS, printed


def test_what_is_not_written_is_left_out(tmp_path: Path) -> None:
    stub = "    raise NotImplementedError('Exercise B9.0')"
    wrong = {
        "matrix.py": f"def _stub(*_):\n{stub}\n\n\nMatrix3.from_quaternion = _stub",
        "quaternion.py": f"def _stub(*_):\n{stub}\n\n\nQuaternion.rotate_by = _stub",
        "euler.py": f"def euler_rates(*_):\n{stub}",
        "angular.py": f"def first_order_drift(*_):\n{stub}",
    }
    done = drawn_plots.plot(engine_with(CHAPTER, wrong, tmp_path), tmp_path, "9")
    assert done.stdout.count("not drawn") == 1, done.stdout
    assert "turning_motion: not drawn, not written yet: Exercise B9.0" in done.stdout
    assert [*ends(tmp_path)] == [("XY", "quaternions"), ("YX", "quaternions")]
    assert [*errors(tmp_path)] == [
        "steady axis, Eq. 9.5",
        "steady axis, Eq. 9.5, normalized",
        "moving axis, Eq. 9.5, normalized",
    ]
    assert len(table(tmp_path, "gimbal_lock")) == 3 * 61


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("what,mass,x,y\n", "there are no stones in stones.csv: weigh some"),
        ("what,mass,x,y\nslate,0.2,0.1\n", "stones.csv, line 2 must be a name, a positive mass"),
        ("", "stones.csv: line 1 must be what,mass,x,y"),
    ],
)
def test_without_stones_the_plot_says_so(text: str, message: str, tmp_path: Path) -> None:
    engine = engine_with(CHAPTER, {}, tmp_path)
    (engine / CHAPTER / "stones.csv").write_text(text, encoding="utf-8")
    done = drawn_plots.plot(engine, tmp_path, "9", only=("balance_lines", "gimbal_lock"))
    assert done.returncode == 1
    assert f"balance_lines: not drawn, ValueError: {message}" in done.stdout
    assert done.stdout.count("not drawn") == 1


def test_products_the_wrong_way_round_are_seen(tmp_path: Path) -> None:
    wrong = {
        "quaternion.py": """\
def _add_scaled(self, vector, scale):
    rate = self * Quaternion(0.0, *vector)
    for name in "rijk":
        setattr(self, name, getattr(self, name) + 0.5 * scale * getattr(rate, name))


Quaternion.add_scaled = _add_scaled""",
        "matrix.py": """\
_right = Matrix3.from_quaternion
Matrix3.from_quaternion = staticmethod(lambda q: _right(q).transpose())""",
    }
    done = drawn_plots.plot(engine_with(CHAPTER, wrong, tmp_path), tmp_path, "9")
    assert done.returncode == 0, done.stdout
    for way, off in errors(tmp_path).items():
        assert (off[-1] > 10.0) == ("Eq. 9.5" in way), way
    found = ends(tmp_path)
    for order in ("XY", "YX"):
        pairs = zip(found[order, "matrices"], found[order, "quaternions"], strict=True)
        assert max(math.dist(a, b) for a, b in pairs) > 1.0


@pytest.mark.parametrize("result", ["None", "float('nan')", "(float('nan'), float('inf'))"])
def test_an_engine_of_nonsense_gives_pictures_all_the_same(result: str, tmp_path: Path) -> None:
    nothing = f"lambda *_: {result}"
    of_quaternion = ("rotate", "rotate_by", "add_scaled", "normalize", "__mul__")
    made = f"Quaternion.from_axis_angle = staticmethod({nothing})\n"
    wrong = {
        "quaternion.py": made + "\n".join(f"Quaternion.{n} = {nothing}" for n in of_quaternion),
        "matrix.py": f"Matrix3.product = Matrix3.from_quaternion = {nothing}",
        "euler.py": f"rate_map = euler_rates = {nothing}",
        "angular.py": f"integrate_rotation = first_order_drift = {nothing}",
        "exercises.py": f"balance_offset = masses_beside = {nothing}",
    }
    done = drawn_plots.plot(engine_with(CHAPTER, wrong, tmp_path), tmp_path, "9")
    assert done.returncode == 0, done.stdout + done.stderr
    assert not done.stderr


def test_an_engine_that_refuses_is_told(tmp_path: Path) -> None:
    wrong = {
        "quaternion.py": """\
def _refuse(*_):
    raise ValueError("no")


Quaternion.rotate = Quaternion.add_scaled = Quaternion.rotate_by = _refuse"""
    }
    done = drawn_plots.plot(engine_with(CHAPTER, wrong, tmp_path), tmp_path, "9")
    assert done.returncode == 0, done.stdout + done.stderr
    assert all(math.isnan(value) for off in errors(tmp_path).values() for value in off)
