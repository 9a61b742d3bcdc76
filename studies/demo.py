"""Play a chapter's demo in a window with mouse and keys, or into files where there is no display.

Each chapter's demos.py has a tuple DEMOS of classes, and `make demo` takes their names in small
letters. Without a display an invented player plays: what it does is written as an animation, and
as a contact sheet of its frames, below build/demos/.
"""

from __future__ import annotations

import argparse
import faulthandler
import importlib
import math
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

import matplotlib
import numpy
from matplotlib import pyplot
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.figure import Figure
from rich.progress import track

from autograder.manifest import ROOT, load_chapters
from studies.engine import add_engine_options, use_engine
from studies.reason import reason, shown

FRAME = 1.0 / 60.0
STEPS_A_PICTURE = 3  # 20 pictures a second: the format counts in hundredths
TILES = 12
TIME_LIMIT = 30.0  # seconds for one picture, which takes some hundredths


class Demo(Protocol):
    """What a class of a chapter's demos.py is: a scene, how it is drawn, and who plays it.

    ``seconds`` is how long the invented player plays, ``keys`` a line of help.
    """

    seconds: float
    keys: str

    def __init__(self, figure: Figure) -> None: ...

    def update(self, duration: float) -> None:
        """Let a frame pass."""

    def draw(self) -> None:
        """Draw the scene as it is now."""

    def press(self, key: str) -> None:
        """Do what a key asks for."""

    def click(self, axes: object, x: float, y: float) -> None:
        """Do what a click on a point of these axes asks for."""

    def play(self, time: float) -> None:
        """Do what a player would do at this time; called once a frame where there is no display."""


def main(arguments: list[str]) -> int:
    """Play the demo that the arguments name; return 1 where it could not be played."""
    parser = argparse.ArgumentParser(prog="python -m studies demo", description=__doc__)
    parser.add_argument("name", nargs="?", default="", help="a demo, such as fireworks")
    add_engine_options(parser)
    parser.add_argument("--seconds", type=float, help="for how long the invented player plays")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "demos")
    options = parser.parse_args(arguments)
    if options.seconds is not None and not 0.0 < options.seconds < math.inf:
        parser.error(f"--seconds must be positive and finite, got {options.seconds!r}")
    use_engine(parser, options.engine, options.given)
    faulthandler.dump_traceback_later(TIME_LIMIT, exit=True)  # an endless loop: say where, and end
    demos = find_demos()
    if options.name not in demos:
        there = ", ".join(demos) or "none that can be read"
        wrong = f"there is no demo {options.name!r}" if options.name else "name a demo"
        parser.error(f"{wrong}; there is {there}")
    try:
        figure = pyplot.figure(figsize=(8, 5), layout="constrained")
        demo = demos[options.name](figure)
        demo.draw()
        figure.canvas.draw()
        figure.set_layout_engine("none")  # laid out once: anew for each picture takes most of it
        if pyplot.get_backend().lower() == "agg":  # matplotlib found no display
            seconds = demo.seconds if options.seconds is None else options.seconds
            write(demo, figure, options.name, seconds, options.out)
        else:
            print(demo.keys, "q ends it.")
            show(demo, figure)
    except (Exception, SystemExit) as error:
        print(f"{options.name}: not played, {reason(error)}")
        return 1
    finally:
        faulthandler.cancel_dump_traceback_later()
    return 0


def find_demos() -> dict[str, type[Demo]]:
    """Return the demos of every chapter by their names; say which chapters cannot be read."""
    demos: dict[str, type[Demo]] = {}
    for chapter in load_chapters():
        if (ROOT / "chapters" / chapter.name / "demos.py").exists():
            try:
                found = importlib.import_module(f"{chapter.name}.demos").DEMOS
            except (Exception, SystemExit) as error:
                print(f"the demos of chapter {chapter.number} cannot be read: {reason(error)}")
                continue
            demos |= {demo.__name__.lower(): demo for demo in found}
    return demos


def write(demo: Demo, figure: Figure, name: str, seconds: float, folder: Path) -> None:
    """Let the invented player play; write the animation and the contact sheet, and say where."""
    folder.mkdir(parents=True, exist_ok=True)
    animation, sheet = folder / f"{name}.gif", folder / f"{name}.png"
    for older in (animation, sheet):
        older.unlink(missing_ok=True)
    pictures = max(TILES, round(seconds / FRAME / STEPS_A_PICTURE))
    on_sheet = {(i + 1) * pictures // TILES - 1 for i in range(TILES)}
    tiles = []
    writer = PillowWriter(fps=round(1.0 / FRAME / STEPS_A_PICTURE))
    no_bar = not sys.stdout.isatty()
    if no_bar:
        print(f"{name}: no display, so {pictures} pictures are drawn into a file", flush=True)
    writer.setup(figure, str(animation), dpi=80)
    for picture in track(range(pictures), name, transient=True, disable=no_bar):
        faulthandler.dump_traceback_later(TIME_LIMIT, exit=True)
        for step in range(STEPS_A_PICTURE):
            demo.play((picture * STEPS_A_PICTURE + step) * FRAME)
            demo.update(FRAME)
        demo.draw()
        writer.grab_frame()
        if picture in on_sheet:
            tiles.append(_picture_of(figure))
    writer.finish()  # only now is there a file: what raises before leaves none
    _sheet_of(tiles).savefig(sheet, dpi=110)
    print(f"{name}: {shown(animation)} and {shown(sheet)}")


def show(demo: Demo, figure: Figure) -> None:
    """Play in a window until it is closed, a frame a picture, however long it takes to draw.

    Raises what the engine raised.
    """
    for setting in matplotlib.rcParams:
        if setting.startswith("keymap."):  # the keys belong to the demo
            matplotlib.rcParams[setting] = ["q"] if setting == "keymap.quit" else []
    errors: list[Exception] = []

    def guarded(act: Callable[[], None]) -> None:
        faulthandler.dump_traceback_later(TIME_LIMIT, exit=True)
        try:
            act()
        except Exception as error:
            errors.append(error)
            pyplot.close(figure)
        finally:
            faulthandler.cancel_dump_traceback_later()

    def next_picture(_: int) -> None:
        guarded(lambda: demo.update(FRAME))
        if not errors:
            guarded(demo.draw)

    def pressed(event: Any) -> None:
        if event.key:
            guarded(lambda: demo.press(event.key))

    def clicked(event: Any) -> None:
        if event.inaxes is not None:
            guarded(lambda: demo.click(event.inaxes, event.xdata, event.ydata))

    figure.canvas.mpl_connect("key_press_event", pressed)
    figure.canvas.mpl_connect("button_press_event", clicked)
    playing = FuncAnimation(figure, next_picture, interval=1000.0 * FRAME, cache_frame_data=False)
    faulthandler.cancel_dump_traceback_later()  # a window may stay open for as long as one likes
    pyplot.show()
    del playing  # it had to live as long as the window
    if errors:
        raise errors[0]


def _picture_of(figure: Figure) -> Any:
    """Return the figure as it is now, as an image."""
    canvas: Any = figure.canvas
    canvas.draw()
    return numpy.array(canvas.buffer_rgba())


def _sheet_of(tiles: list[Any]) -> Figure:
    """Return a figure of these images, row by row."""
    columns = 3
    rows = -(-len(tiles) // columns)
    sheet, places = pyplot.subplots(rows, columns, figsize=(12, 2.6 * rows), layout="constrained")
    for axes, tile in zip(places.flat, tiles, strict=False):
        axes.imshow(tile)
    for axes in places.flat:
        axes.set_axis_off()
    return sheet
