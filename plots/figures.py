"""Draw the pictures of all lessons with the reference solution, for `make figures`.

They are the plots of `make plot`, and animations that the lab records. To make pages load quickly,
all have only a few colors, and the animations are scaled down and have fewer frames per second.
"""

from __future__ import annotations

import argparse
import bisect
import functools
import re
import subprocess
import sys
from pathlib import Path

from matplotlib import pyplot
from PIL import Image, ImageChops, ImageSequence, ImageStat

from autograder.files import from_here
from autograder.manifest import ROOT
from plots.draw import draw, plots_of
from scenes.engine import use_engine

# The plots that lessons show, such as "ch02_vectors/addition".
PLOTS = [
    f"{lesson.parent.name}/{name}"
    for lesson in sorted(ROOT.glob("chapters/*/README.md"))
    for name in re.findall(
        r"\(pictures/(\w+)(?<!_still)\.png\)", lesson.read_text(encoding="utf-8")
    )
]
# The length of each animation in s, and the time of the still picture that a page shows instead, so
# that nothing moves unless the reader wants it to.
ANIMATIONS = {
    "ch04_particle_engine/fireworks": (6.0, 2.5),
    "ch05_forces/sniper": (11.0, 3.0),
    "ch06_springs/cloth": (7.0, 4.0),
    "ch07_constraints/ropes": (6.0, 1.0),
    "ch08_mass_aggregate/trebuchet": (5.5, 2.0),
    "ch09_rotations/spin": (4.5, 2.0),
}
COLORS_OF_ANIMATION = 48
COLORS_OF_STILL = range(8, 257, 8)  # the numbers of colors to try
UNSEEN = 2.5  # a root-mean-square difference of colors, out of 255, that nobody sees
WIDTH = 480  # px, of an animation
PICTURE_TIME = 100  # ms per picture of an animation
TIME_LIMIT = 600.0  # s for one plot; the reference has no endless loop, but machines may be slow


def main(arguments: list[str]) -> int:
    """Draw the pictures of all lessons, and return 1 if one of them could not be drawn."""
    parser = argparse.ArgumentParser(prog="python -m plots figures", description=__doc__)
    parser.add_argument("--engine", default="solutions", help="the engine to draw with")
    parser.add_argument("--out", type=Path, default=ROOT / "chapters", help="the chapters' folder")
    options = parser.parse_args(arguments)
    use_engine(parser, options.engine)
    pyplot.switch_backend("Agg")  # writes scenes to files even if there is a display
    work = ROOT / "build" / "figures"
    done = []
    for chapter, name in (name.split("/") for name in PLOTS):
        folder = work / chapter
        folder.mkdir(parents=True, exist_ok=True)
        plots = plots_of(chapter) | plots_of(chapter, "FOR_LESSONS")
        done.append(draw(plots[name], folder, TIME_LIMIT))
        if done[-1]:
            with Image.open(folder / f"{name}.png") as drawn:
                _write([_few_colors(drawn)], options.out / chapter / "pictures" / f"{name}.png")
        pyplot.close("all")
    for name, (seconds, still) in ANIMATIONS.items():
        animation = work / f"{name}.gif"
        how = ("--engine", options.engine, "--seconds", str(seconds), "--out", animation.parent)
        command = [sys.executable, "-m", "lab", "record", animation.stem, *map(str, how)]
        done.append(not subprocess.run(command, check=False).returncode)
        if done[-1]:
            folder = options.out / animation.parent.name / "pictures"
            _write(_shrunk(animation), folder / animation.name)
            _write([_still(animation, still)], folder / f"{animation.stem}_still.png")
    print(f"{sum(done)} of {len(done)} pictures drawn with {options.engine}")
    return 0 if all(done) else 1


def _shrunk(animation: Path) -> list[Image.Image]:
    """Return smaller frames of an animation in few colors, one for every PICTURE_TIME ms."""
    pictures: list[Image.Image] = []
    time = 0.0
    with Image.open(animation) as frames:
        size = (WIDTH, round(WIDTH * frames.height / frames.width))
        for frame in ImageSequence.Iterator(frames):
            small = frame.convert("RGB").resize(size, Image.Resampling.LANCZOS)
            time += frame.info["duration"]  # equal pictures are merged and shown for longer
            while len(pictures) * PICTURE_TIME < time:
                pictures.append(small)
    # All pictures share a palette, made from four of them, so that still parts do not flicker.
    strip = Image.new("RGB", (4 * size[0], size[1]))
    for i in range(4):
        strip.paste(pictures[i * (len(pictures) - 1) // 3], (i * size[0], 0))
    few = _palette(strip, COLORS_OF_ANIMATION)
    return [picture.quantize(palette=few, dither=Image.Dither.NONE) for picture in pictures]


def _still(animation: Path, seconds: float) -> Image.Image:
    """Return the frame that an animation shows after ``seconds`` seconds, in full size."""
    left = 1000.0 * seconds
    with Image.open(animation) as frames:
        for frame in ImageSequence.Iterator(frames):
            left -= frame.info["duration"]
            if left <= 0.0:
                break
        return _few_colors(frame)


def _few_colors(picture: Image.Image) -> Image.Image:
    """Reduce the colors of a picture as far as possible without a visible change."""
    full = picture.convert("RGB")
    reduced = functools.cache(functools.partial(_palette, full))

    def looks_same(count: int) -> bool:
        difference = ImageChops.difference(full, reduced(count).convert("RGB"))
        return max(ImageStat.Stat(difference).rms) <= UNSEEN

    first = bisect.bisect_left(COLORS_OF_STILL, True, key=looks_same)
    return reduced(COLORS_OF_STILL[min(first, len(COLORS_OF_STILL) - 1)])


def _palette(picture: Image.Image, count: int) -> Image.Image:
    """Reduce ``picture`` to ``count`` colors that are as different as possible.

    The most frequent colors are grays along letters, with which colored lines would turn gray.
    """
    few = picture.quantize(
        count, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE, kmeans=3
    )
    entries = few.getpalette() or []
    brightest = max(range(0, len(entries), 3), key=lambda i: sum(entries[i : i + 3]))
    entries[brightest : brightest + 3] = [255, 255, 255]  # as white as the page
    few.putpalette(entries)
    return few


def _write(pictures: list[Image.Image], place: Path) -> None:
    """Save one image, or several as a looping GIF, and print the path and file size."""
    place.parent.mkdir(parents=True, exist_ok=True)
    if len(pictures) == 1:
        pictures[0].save(place, optimize=True)
    else:
        rest, time = pictures[1:], PICTURE_TIME
        pictures[0].save(place, save_all=True, append_images=rest, duration=time, loop=0)
    print(f"  {from_here(place)}, {place.stat().st_size // 1000} kB")
