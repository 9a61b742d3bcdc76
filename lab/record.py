"""Record a scripted run of a scene to files: an animation, a sheet of pictures and a table."""

from __future__ import annotations

import csv
import sys
from pathlib import Path
from typing import Any

import numpy
from matplotlib import pyplot
from matplotlib.animation import PillowWriter
from rich.progress import track

from lab.drawing.pen import Pen
from lab.drawing.picture import LIGHT, Painter
from lab.scene import Scene, name_of
from scenes.clock import FRAME
from scenes.reason import time_limit

STEPS_A_PICTURE = 3  # gives 20 pictures per second; GIF delays are whole hundredths of a second
TILES = 12
TIME_LIMIT = 30.0  # s per picture; a picture normally takes some hundredths of a second
PIXEL = 0.8  # points; slightly less than a pixel, because the axes leave less room for the scene


def record(scene: Scene, folder: Path, seconds: float | None = None) -> list[Path]:
    """Record a scripted run of ``scene`` to files in ``folder``, and return their paths."""
    name = name_of(type(scene))
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{name}{kind}" for kind in (".gif", ".png", ".csv")]
    for older in files:
        older.unlink(missing_ok=True)  # so that none remain if the scene fails
    figure = pyplot.figure(figsize=(8.0, 5.0), layout="constrained")
    canvas: Any = figure.canvas
    axes, title = figure.subplots(), figure.suptitle("", fontsize=10)
    left, right, bottom, top = scene.view
    axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
    painter = Painter(axes, LIGHT, PIXEL)
    drawn: list[Any] = []

    def draw() -> None:
        pen = Pen()
        scene.draw(pen)
        for artist in drawn:
            artist.remove()
        drawn[:] = painter.draw(pen.items)
        title.set_text(f"{scene.title}, {scene.time:.2f} s\n{scene.facts()}")

    with time_limit(TIME_LIMIT):
        draw()
    canvas.draw()
    figure.set_layout_engine("none")  # one layout is enough, and layout is slow
    wanted = scene.seconds if seconds is None else seconds
    pictures = max(TILES, round(wanted / FRAME / STEPS_A_PICTURE))
    on_sheet = {(i + 1) * pictures // TILES - 1 for i in range(TILES)}
    writer = PillowWriter(fps=round(1.0 / FRAME / STEPS_A_PICTURE))
    writer.setup(figure, str(files[0]), dpi=80)
    rows, tiles = [_row(scene)], []
    for number in track(range(pictures), name, transient=True, disable=not sys.stdout.isatty()):
        with time_limit(TIME_LIMIT):
            for _ in range(STEPS_A_PICTURE):
                scene.play(scene.time)
                scene.advance(FRAME)
                rows.append(_row(scene))
            draw()
            writer.grab_frame()
        if number in on_sheet:
            canvas.draw()
            tiles.append(numpy.array(canvas.buffer_rgba()))
    writer.finish()
    _save_sheet(tiles, files[1])
    with files[2].open("w", encoding="utf-8", newline="") as table:
        lines = csv.DictWriter(table, rows[0].keys())
        lines.writeheader()
        lines.writerows(rows)
    pyplot.close("all")
    return files


def _row(scene: Scene) -> dict[str, float | None]:
    error = scene.error()
    found: dict[str, float | None] = {"time, s": round(scene.time, 6), **scene.chart()}
    return found if error is None else found | {f"error, {scene.error_unit}": error}


def _save_sheet(tiles: list[Any], file: Path) -> None:
    rows = -(-len(tiles) // 3)
    sheet, places = pyplot.subplots(rows, 3, figsize=(12, 2.6 * rows), layout="constrained")
    for axes in places.flat:
        axes.set_axis_off()
    for axes, tile in zip(places.flat, tiles, strict=False):
        axes.imshow(tile)
    sheet.savefig(file, dpi=110)
