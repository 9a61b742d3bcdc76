"""Play a scene in a window, or record it to files.

For a recording, the scene plays its own script. The files are an animation, an image that shows
several frames, and a table of the values in the scene's chart.
"""

from __future__ import annotations

import csv
import faulthandler
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib
import numpy
from matplotlib import pyplot
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.figure import Figure
from rich.progress import track

from lab.drawing.picture import Picture
from lab.scene import Scene, name_of
from scenes.clock import FRAME

STEPS_A_PICTURE = 3  # gives 20 pictures per second; GIF delays are whole hundredths of a second
TILES = 12
TIME_LIMIT = 30.0  # s per picture; a picture normally takes some hundredths of a second
SIZE = (8.0, 5.0)  # inches


def record(scene: Scene, folder: Path, seconds: float | None = None) -> list[Path]:
    """Record a scripted run of ``scene`` to files in ``folder``, and return their paths.

    The files are an animated GIF, a PNG image that shows several frames, and a CSV table of the
    values in the scene's chart. Files of an earlier recording are deleted first, so that none of
    them remain if the scene fails.
    """
    name = name_of(type(scene))
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{name}{kind}" for kind in (".gif", ".png", ".csv")]
    for older in files:
        older.unlink(missing_ok=True)
    picture = Picture(scene, pyplot.figure(figsize=SIZE, layout="constrained"))
    picture.draw()
    picture.figure.canvas.draw()
    picture.figure.set_layout_engine("none")  # one layout is enough, and layout is slow
    wanted = scene.seconds if seconds is None else seconds
    pictures = max(TILES, round(wanted / FRAME / STEPS_A_PICTURE))
    on_sheet = {(i + 1) * pictures // TILES - 1 for i in range(TILES)}
    writer = PillowWriter(fps=round(1.0 / FRAME / STEPS_A_PICTURE))
    writer.setup(picture.figure, str(files[0]), dpi=80)
    rows, tiles = [_row(scene)], []
    for number in track(range(pictures), name, transient=True, disable=not sys.stdout.isatty()):
        faulthandler.dump_traceback_later(TIME_LIMIT, exit=True)
        for _ in range(STEPS_A_PICTURE):
            scene.play(scene.time)
            scene.advance(FRAME)
            rows.append(_row(scene))
        picture.draw()
        writer.grab_frame()
        if number in on_sheet:
            tiles.append(_image_of(picture.figure))
    faulthandler.cancel_dump_traceback_later()
    writer.finish()
    _sheet_of(tiles).savefig(files[1], dpi=110)
    with files[2].open("w", encoding="utf-8", newline="") as table:
        lines = csv.DictWriter(table, rows[0].keys())
        lines.writeheader()
        lines.writerows(rows)
    pyplot.close("all")
    return files


def show(scene: Scene) -> None:
    """Play ``scene`` in a window until the window is closed or the engine raises an error."""
    for setting in matplotlib.rcParams:
        if setting.startswith("keymap."):  # leave the keys to the scene
            matplotlib.rcParams[setting] = ["q"] if setting == "keymap.quit" else []
    figure = pyplot.figure(figsize=SIZE, layout="constrained")
    picture = Picture(scene, figure)
    picture.draw()
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
        guarded(scene.advance)
        if not errors:
            guarded(picture.draw)

    def pressed(event: Any) -> None:
        if event.key:
            guarded(lambda: scene.press(event.key))

    def clicked(event: Any) -> None:
        if event.inaxes is not None:
            guarded(lambda: scene.click(event.xdata, event.ydata))

    figure.canvas.mpl_connect("key_press_event", pressed)
    figure.canvas.mpl_connect("button_press_event", clicked)
    playing = FuncAnimation(figure, next_picture, interval=1000.0 * FRAME, cache_frame_data=False)
    pyplot.show()
    del playing  # the animation must live as long as the window
    if errors:
        raise errors[0]


def _row(scene: Scene) -> dict[str, float | None]:
    """Return one row of a recording's table: the time, the charted values and the error.

    The error is omitted if the scene has no exact solution.
    """
    error = scene.error()
    found: dict[str, float | None] = {"time, s": round(scene.time, 6), **scene.chart()}
    return found if error is None else found | {f"error, {scene.error_unit}": error}


def _image_of(figure: Figure) -> Any:
    """Render a matplotlib figure and return its pixels as an array."""
    canvas: Any = figure.canvas
    canvas.draw()
    return numpy.array(canvas.buffer_rgba())


def _sheet_of(tiles: list[Any]) -> Figure:
    """Arrange several frames of a recording in a grid, so that they can be seen at a glance."""
    columns = 3
    rows = -(-len(tiles) // columns)
    sheet, places = pyplot.subplots(rows, columns, figsize=(12, 2.6 * rows), layout="constrained")
    for axes, tile in zip(places.flat, tiles, strict=False):
        axes.imshow(tile)
    for axes in places.flat:
        axes.set_axis_off()
    return sheet
