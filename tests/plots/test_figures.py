"""Every lesson has pictures, and `make figures` draws all of them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from matplotlib import pyplot
from PIL import Image, ImageColor, ImageSequence

from autograder.manifest import ROOT, Chapter, load_chapters
from lab.drawing.picture import LIGHT
from plots import ch02_vectors as plots
from plots import figures
from plots.draw import plots_of
from plots.drawing import BLUE, ORANGE

LARGEST = 300_000  # bytes, so that a page loads quickly
STILLS = {f"{name}.png" for name in figures.PLOTS}
STILLS |= {f"{name}_still.png" for name in figures.ANIMATIONS}
MADE = STILLS | {f"{name}.gif" for name in figures.ANIMATIONS}


@pytest.mark.parametrize("chapter", load_chapters(), ids=lambda chapter: chapter.name)
def test_a_lesson_has_pictures_that_load_at_once_and_say_what_they_show(chapter: Chapter) -> None:
    lesson = (ROOT / "chapters" / chapter.name / "README.md").read_text(encoding="utf-8")
    shown = re.findall(r"!\[([^\]]*)\]\(([^)]+)\)", lesson)
    assert len(shown) >= 2
    for words, name in shown:
        assert len(words.split()) >= 12, "too short to describe the picture to a blind reader"
        picture = ROOT / "chapters" / chapter.name / name
        assert 2_000 < picture.stat().st_size < LARGEST
        with Image.open(picture) as image:
            assert image.width >= 480
            assert image.convert("RGB").getpixel((3, 3)) == (255, 255, 255), "not white"
    of_chapter = {Path(name).name for name in MADE if Path(name).parent.name == chapter.name}
    animations = set(re.findall(r"\]\(pictures/(\w+\.gif)\)", lesson))
    stills = {name.removeprefix("pictures/") for _, name in shown}
    assert stills | animations == of_chapter, "a drawn picture is not shown"
    named = {Path(name).name for name in figures.PLOTS if Path(name).parent.name == chapter.name}
    assert named <= {*plots_of(chapter.name), *plots_of(chapter.name, "FOR_LESSONS")}


def test_no_page_shows_an_animation_that_its_reader_did_not_start() -> None:
    """Readers must be able to stop motion that lasts longer than five seconds (WCAG 2.2.2)."""
    for page in [*ROOT.glob("*.md"), *ROOT.glob("*/*.md"), *ROOT.glob("chapters/*/*.md")]:
        assert not re.search(r"!\[[^\]]*\]\([^)]+\.gif\)", page.read_text(encoding="utf-8")), page


def test_no_picture_lies_there_that_nothing_draws() -> None:
    there = [*ROOT.glob("chapters/**/*.png"), *ROOT.glob("chapters/**/*.gif")]
    made = {f"{Path(name).parent}/pictures/{Path(name).name}" for name in MADE}
    assert {path.relative_to(ROOT / "chapters").as_posix() for path in there} == made


def test_figures_draws_a_plot_and_an_animation_and_says_where(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(figures, "PLOTS", ("ch02_vectors/cross_product",))
    monkeypatch.setattr(figures, "ANIMATIONS", {"ch05_forces/sniper": (2.0, 1.0)})
    monkeypatch.setattr(figures, "ROOT", tmp_path)
    assert figures.main(["--out", str(tmp_path / "chapters")]) == 0
    told = capfd.readouterr().out
    assert "chapters/ch02_vectors/pictures/cross_product.png, " in told
    assert "chapters/ch05_forces/pictures/sniper.gif, " in told
    assert "2 of 2 pictures drawn with solutions" in told
    with Image.open(tmp_path / "chapters/ch05_forces/pictures/sniper.gif") as animation:
        time = 0.0
        for i in range(animation.n_frames):
            animation.seek(i)
            time += animation.info["duration"]
    assert time == 2000.0  # ms, the length of the recording
    with Image.open(tmp_path / "chapters/ch02_vectors/pictures/cross_product.png") as picture:
        assert picture.size == (1100, 550)
        assert all(is_in(color, picture) for color in (BLUE, ORANGE))


def test_an_animation_in_few_colors_still_tells_its_lines_apart() -> None:
    with Image.open(ROOT / "chapters/ch09_rotations/pictures/spin.gif") as animation:
        for color in ("blue", "orange", "green"):  # the edges of the visible faces
            assert any(is_in(LIGHT[color], frame) for frame in ImageSequence.Iterator(animation))


def is_in(color: str, picture: Image.Image) -> bool:
    """Return whether a picture has this color, or a color that is almost the same."""
    wanted = ImageColor.getrgb(color)
    colors = [color for _, color in picture.convert("RGB").getcolors(1 << 20) or []]
    return min(max(map(abs, map(int.__sub__, c, wanted))) for c in colors) <= 16


def test_a_picture_that_cannot_be_drawn_is_said_and_the_older_one_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    older = tmp_path / "ch02_vectors/pictures/cross_product.png"
    older.parent.mkdir(parents=True)
    older.write_text("an older picture", encoding="utf-8")

    def cross_product() -> None:
        raise ArithmeticError("no such product")

    monkeypatch.setattr(plots, "PLOTS", (cross_product,))
    monkeypatch.setattr(figures, "PLOTS", ("ch02_vectors/cross_product",))
    monkeypatch.setattr(figures, "ANIMATIONS", {})
    monkeypatch.setattr(figures, "ROOT", tmp_path)
    assert figures.main(["--out", str(tmp_path)]) == 1
    told = capfd.readouterr().out
    assert "cross_product: not drawn, ArithmeticError: no such product" in told
    assert "0 of 1 pictures drawn" in told
    assert older.read_text(encoding="utf-8") == "an older picture"
    pyplot.close("all")
