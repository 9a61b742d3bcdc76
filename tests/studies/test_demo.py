"""Demos are played by the engine at hand, into files or in a window, with mouse and keys."""

from __future__ import annotations

import math
import subprocess
from pathlib import Path
from typing import Any

import pytest
from matplotlib import pyplot
from matplotlib.backend_bases import KeyEvent, MouseEvent
from PIL import Image

from autograder.manifest import ROOT, load_chapters
from ch04_particle_engine.ballistics import SHOT_TYPES
from copies import copy_tree
from made import made_stubs
from studied import study
from studies import demo as demos
from wrong import write_all

NAMES = ("throw", "ballistics", "fireworks", "sniper", "springbridge", "cloth", "ropes", "bridge")
NAMES += ("platform", "blob", "wheel", "cube", "trebuchet", "ball", "spin")


def play(*arguments: str, **settings: int) -> subprocess.CompletedProcess[str]:
    return study("demo", *arguments, settings=settings)


UNLOCKED = {name: (c, e) for c in load_chapters() for e in c.exercises for name in e.play}
LATER = "raise NotImplementedError('later')"


@pytest.mark.parametrize("name", NAMES)
def test_without_a_display_a_demo_is_an_animation_and_a_contact_sheet(
    name: str, tmp_path: Path
) -> None:
    """It works with the exercise that unlocks it and those before it: what is later are stubs."""
    chapter, unlocks = UNLOCKED[name]
    written = [exercise.id for exercise in chapter.exercises]
    written = written[: written.index(unlocks.id) + 1]
    engine = tmp_path / "engine"
    copy_tree(ROOT / "solutions", engine)
    write_all(chapter, LATER, engine, but=written)
    arguments = ("--engine", str(engine), "--seconds", "2", "--out", str(tmp_path))
    # One is drawn as students see it, the others with half the pictures of the same two seconds.
    done = play(name, *arguments, STEPS_A_PICTURE=3 if name == NAMES[0] else 6)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"{name}.gif and " in done.stdout
    with Image.open(tmp_path / f"{name}.gif") as animation:
        length = 0.0
        for i in range(animation.n_frames):  # equal pictures are one, that is shown for longer
            animation.seek(i)
            length += animation.info["duration"] / 1000.0
    assert length == pytest.approx(2.0, rel=1e-9)
    assert (tmp_path / f"{name}.png").stat().st_size > 20_000, "an empty sheet"


def test_a_scene_that_cannot_begin_is_said_and_leaves_no_older_file(tmp_path: Path) -> None:
    copy_tree(ROOT / "solutions", tmp_path / "engine")
    ballistics = tmp_path / "engine/ch04_particle_engine/ballistics.py"
    ballistics.write_text(
        made_stubs()["chapters/ch04_particle_engine/ballistics.py"], encoding="utf-8"
    )
    out = tmp_path / "out"
    out.mkdir()
    (out / "ballistics.gif").write_text("an older animation", encoding="utf-8")
    done = play("ballistics", "--engine", str(tmp_path / "engine"), "--out", str(out))
    assert done.returncode == 1
    assert "ballistics: not played, not written yet: Exercise B4.3" in done.stdout
    assert [*out.iterdir()] == []


def test_a_demo_plays_with_what_is_written(tmp_path: Path) -> None:
    """Without grenades, targets, own types, wheel, turns and game there is enough to see."""
    copy_tree(ROOT / "solutions", tmp_path / "engine")
    stubs = made_stubs()
    missing = ("grenade", "targets", "firework_types", "catherine_wheel", "screen_rotation")
    for module in (*missing, "display"):
        path = f"ch04_particle_engine/{module}.py"
        (tmp_path / "engine" / path).write_text(stubs[f"chapters/{path}"], encoding="utf-8")
    for name in ("ballistics", "fireworks", "sniper"):
        engine, out = str(tmp_path / "engine"), str(tmp_path / "out")
        done = play(name, "--engine", engine, "--seconds", "1", "--out", out)
        assert done.returncode == 0, done.stdout
        assert (tmp_path / "out" / f"{name}.gif").exists()


def test_a_ball_is_thrown_with_a_mass_a_step_and_a_copy_of_a_vector(tmp_path: Path) -> None:
    ch02, ch03 = load_chapters()[:2]
    write_all(ch02, LATER, tmp_path, but=["B2.1"])
    write_all(ch03, LATER, tmp_path, but=["B3.1", "B3.4"])
    arguments = ("--engine", str(tmp_path), "--seconds", "1", "--out", str(tmp_path / "out"))
    done = play("throw", *arguments)
    assert done.returncode == 0, done.stdout
    write_all(ch03, LATER, tmp_path, but=["B3.1"])
    done = play("throw", *arguments)
    assert done.returncode == 1
    assert "throw: not played, not written yet: later" in done.stdout, "before the first throw"


def test_what_is_not_written_is_said(tmp_path: Path) -> None:
    stubs = tmp_path / "ch04_particle_engine"
    copy_tree(ROOT / "solutions/ch04_particle_engine", stubs)
    source = (stubs / "display.py").read_text(encoding="utf-8")
    left = source.replace(
        "    if is_over(display):\n        return False",
        "    raise NotImplementedError('Exercise P4.1: Keep the display alive')",
    )
    assert left != source
    (stubs / "display.py").write_text(left, encoding="utf-8")
    for folder in ("ch02_vectors", "ch03_laws_of_motion"):
        copy_tree(ROOT / "solutions" / folder, tmp_path / folder)
    done = play("fireworks", "--engine", str(tmp_path), "--out", str(tmp_path / "out"))
    assert done.returncode == 1
    assert "fireworks: not played, not written yet: Exercise P4.1" in done.stdout
    assert "Traceback" not in done.stderr


def test_a_demo_that_is_not_there_is_a_clear_sentence() -> None:
    done = play("trebuchets", "--engine", "solutions")
    assert done.returncode == 2
    there = ", ".join(NAMES)
    assert f"there is no demo 'trebuchets'; there is {there}" in " ".join(done.stderr.split())
    done = play("fireworks", "--engine", "nowhere")
    assert "engine must be a folder of chapters, got 'nowhere'" in done.stderr
    done = play("fireworks", "--engine", "solutions", "--seconds", "-1")
    assert "--seconds must be positive and finite, got -1.0" in done.stderr


@pytest.fixture
def window(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Return a function that plays a demo in a window, in which these events happen."""
    pyplot.switch_backend("Agg")  # whether or not there is a display

    def played(name: str, *events: tuple[Any, ...]) -> Any:
        figure = pyplot.figure(figsize=(8, 5), layout="constrained")
        demo: Any = demos.find_demos()[name](figure)

        def happen() -> None:
            figure.canvas.draw()
            for event in events:
                if isinstance(event[0], str):
                    made: Any = KeyEvent("key_press_event", figure.canvas, event[0])
                else:
                    axes, x, y = event
                    pixel = getattr(demo, axes[0]).transData.transform((x, y))
                    made = MouseEvent("button_press_event", figure.canvas, *pixel, button=1)
                figure.canvas.callbacks.process(made.name, made)
                demo.update(demos.FRAME)
            demo.draw()
            figure.canvas.draw()

        monkeypatch.setattr(pyplot, "show", happen)
        demos.show(demo, figure)
        return demo

    yield played
    pyplot.close("all")


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_the_ball_is_above_its_exact_path_by_what_the_step_leaves_out(window: Any) -> None:
    """Without the term a h^2 / 2 of each step, n steps of h end n g h^2 / 2 too high."""
    for key, rate in (("1", 60), ("4", 10)):
        demo = window("throw", (key,), (" ",))
        assert demo.rate == rate
        while demo.steps < rate:
            demo.update(demos.FRAME)
        true = demo.thrown.exact(1.0).position
        x, y = demo.way[-1]
        assert x == pytest.approx(true[0], rel=1e-12)
        assert y - true[1] == pytest.approx(9.81 / rate / 2.0, rel=1e-9)
        demo.draw()
        assert f"{9.81 / rate / 2.0:.2f} m from its exact" in demo.title.get_text()


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_keys_and_clicks_aim_the_ball(window: Any) -> None:
    demo = window("throw", ("up",), ("right",), ("right",), ("a",), (" ",), ("up",))
    vx, vy, _ = demo.thrown.start.velocity  # the last key is for the next throw
    assert math.degrees(math.atan2(vy, vx)) == pytest.approx(57.0)
    assert math.hypot(vx, vy) == pytest.approx(9.5)
    assert demo.particle.damping == demo.AIR
    assert window("throw", ("a",), ("a",)).damping == 1.0
    # Before gravity had a step the slope was 4 / 3; the strength is the distance from the hand.
    velocity = window("throw", (("axes",), 4.0, 6.0)).thrown.start.velocity
    assert velocity == pytest.approx((6.0, 8.0, 0.0), rel=1e-6)


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_a_ball_that_falls_through_the_hoop_counts_and_moves_it(window: Any) -> None:
    demo = window("throw", ("r",))
    hoop = demo.hoop
    run, rise = (to - start for to, start in zip(hoop, demo.HAND, strict=True))
    angle = math.radians(60.0)
    # The speed of a parabola through the middle of the hoop.
    fall = run * math.tan(angle) - rise
    speed = run / math.cos(angle) * math.sqrt(9.81 / (2.0 * fall))
    for factor, score in ((0.8, 0), (1.2, 0), (1.0, 1)):
        demo.aim(angle, factor * speed)
        demo.press(" ")
        while demo.flies:
            demo.update(demos.FRAME)
        assert demo.score == score
        assert ("exact path: in" in demo.message) == (score == 1)
    for _ in range(120):
        demo.update(demos.FRAME)
    assert demo.hoop != hoop


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_keys_choose_aim_and_fire(window: Any) -> None:
    demo = window("ballistics", ("2",), ("up",), ("left",), (" ",), ("5",), (" ",))
    assert [shot.type for shot in demo.range.shots] == ["artillery", "grenade"]
    artillery = demo.range.shots[0].particle.velocity
    assert artillery.x > 0.0  # left of one who looks along Z
    assert artillery.y > SHOT_TYPES["artillery"].velocity[1]


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_a_click_aims_at_its_point(window: Any) -> None:
    demo = window("ballistics", (("side",), 50.0, 21.5), (("above",), 60.0, 6.0))
    first, second = (shot.particle.velocity for shot in demo.range.shots)
    # Before gravity had a frame the slope was 20 / 50; damping keeps the direction.
    assert first.y / first.z == pytest.approx(20.0 / 50.0, abs=0.01)
    assert second.x / second.z == pytest.approx(6.0 / 60.0, abs=0.01)


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_the_rifle_shoots_where_the_scope_is_clicked(window: Any) -> None:
    demo = window("sniper", (("scope",), 13.0, 10.0))
    velocity = demo.range.bullet.velocity
    # A frame of wind and gravity turns it by less than 0.5 mrad.
    assert 1000.0 * velocity.x / velocity.z == pytest.approx(13.0, abs=0.5)
    assert 1000.0 * velocity.y / velocity.z == pytest.approx(10.0, abs=0.5)
    assert demo.range.shots_left == 9


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_keys_move_the_cross_and_shoot(window: Any) -> None:
    demo = window("sniper", ("left",), ("up",), ("up",), (" ",), (" ",))
    assert demo.aim == pytest.approx((0.0005, 0.001))
    assert demo.range.shots_left == 9  # the second one has to wait
    assert window("sniper", (" ",), ("r",)).range.shots_left == 10


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_the_walker_walks_and_springs_get_stiffer(window: Any) -> None:
    demo = window("springbridge", ("right",), ("right",), ("left",), ("s",))
    assert demo.x == pytest.approx(0.5 + demo.PACE)
    assert demo.stiffness == 4000.0
    assert min(plank.position.y for plank in demo.planks) == demo.planks[1].position.y < -0.001
    assert demo.message == ""


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_a_bridge_and_a_cloth_that_explode_stop_say_so_and_start_anew(window: Any) -> None:
    for name, keys in (("springbridge", "sssse"), ("cloth", "e")):
        demo = window(name, *[(key,) for key in keys])
        for _ in range(300):
            demo.update(demos.FRAME)
        assert demo.message.startswith("SimulationDiverged: particle")
        demo.draw()
        assert "over the limit of 100 m/s" in demo.title.get_text().replace("\n", " ")
        demo.press("r")
        assert demo.message == ""


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_keys_set_the_frame_rate_of_the_cloth(window: Any) -> None:
    assert window("cloth", ("down",), ("down",), ("up",)).rate == 120
    assert window("cloth", *[("down",)] * 20).rate == 30


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_one_rope_of_rods_stretches_and_another_does_not(window: Any) -> None:
    """A rod a frame passes a pull on by a link a frame; one solve for all rods leaves no such lag.

    The lower limit is a tenth of a link, the upper one a millionth of the rope.
    """
    demo = window("ropes", ("up",), ("down",), ("r",))
    assert demo.count == 5
    for _ in range(120):
        demo.update(demos.FRAME)
    by_frame, by_substeps, solved = demo.too_long()
    assert by_frame > 10.0 * by_substeps
    assert by_frame > 0.01
    assert abs(solved) < 0.5e-6
    assert window("ropes", *[("up",)] * 9).count == demo.COUNTS[-1]


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_a_click_into_the_dark_is_a_miss_and_keys_launch(window: Any) -> None:
    demo = window("fireworks", (("axes",), 28.0, 30.0), ("2",), ("6",))
    assert demo.display.misses == 1
    types = [firework.type for firework in demo.display.show.fireworks]
    assert (types.count(2), types.count(6)) == (1, 2)  # one of type 6 begins the game
    demo = window("fireworks", (("axes",), 28.0, 30.0), ("r",))
    assert demo.display.misses == 0


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_keys_choose_the_axis_of_the_spin_and_disturb_it(window: Any) -> None:
    demo = window("spin", ("1",), ("up",), ("up",))
    assert (demo.axis, demo.disturbed) == (1, 4)  # Y is the longest side
    # Nearly all of it about Y, and a fifth about Z, after the last key and one frame.
    assert demo.velocities[0] == pytest.approx((0.0, demo.SPEED, 0.2 * demo.SPEED), rel=1e-15)
    for key, turned_over in (("2", 8), ("1", 0), ("3", 0)):
        demo.press(key)
        for _ in range(900):
            demo.update(demos.FRAME)
        assert demo.turned_over == turned_over
    demo.press("r")
    assert (demo.time, demo.turned_over) == (0.0, 0)
    demo.press(" ")
    demo.update(demos.FRAME)
    assert demo.time == 0.0  # it is stopped
    assert window("spin", *[("down",)] * 9).disturbed == 0


@pytest.mark.filterwarnings("ignore:Animation was deleted")
def test_what_the_engine_raises_ends_the_window_and_is_told(
    window: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    Fireworks = demos.find_demos()["fireworks"]  # noqa: N806 - a class

    def broken(*_: Any) -> None:
        raise ValueError("no such click")

    monkeypatch.setattr(Fireworks, "click", broken)
    with pytest.raises(ValueError, match="no such click"):
        window("fireworks", (("axes",), 0.0, 10.0))
