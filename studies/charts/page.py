"""Write the charts of all scenes to one web page, and all data points to a CSV file.

Each chart shows how accurate and how fast our engine and pymunk are in a scene. The page needs no
other files.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from pathlib import Path
from urllib.parse import quote

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from autograder.files import replace_bytes
from studies.accuracy.measure import Point
from studies.accuracy.results import table
from studies.accuracy.scene import Scene
from studies.charts.panels import HEIGHT, IDS, MARKS, WIDTH, panel
from studies.charts.ratios import ratios

HERE = Path(__file__).parent
COLUMNS = (
    *("scene", "model", "by", "is a better model", "steps, or 1 / tolerance", "per frames"),
    "error / scale",
    *("time, ms", "lower quartile, ms", "upper quartile, ms", "work", "what is counted as work"),
)


def write(scenes: Sequence[Scene], points: Sequence[Point], how: str, out: Path) -> None:
    """Write the page with all charts to ``index.html``, and all data points to ``points.csv``.

    Both files are saved in the folder ``out``. ``how`` is a sentence for the page, which explains
    how the times were measured.
    """
    own = {scene.name: [p for p in points if p.scene == scene.name] for scene in scenes}
    panels = [panel(scene, own[scene.name]) for scene in scenes]
    data = csv_of(scenes, own)
    axis, compared = ratios(table(points))
    environment = Environment(
        loader=FileSystemLoader(HERE),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    page = environment.get_template("page.html").render(
        panels=panels,
        models=sorted({drawn.name for each in panels for drawn in each.models}),
        ratios=compared,
        axis=axis,
        how=how,
        data=quote(data, safe=" ,/()=+"),
        marks={IDS[mark]: path for mark, path in MARKS.items()},
        width=WIDTH,
        height=HEIGHT,
        style=(HERE / "style.css").read_text(encoding="utf-8"),
        script=(HERE / "script.js").read_text(encoding="utf-8"),
    )
    replace_bytes(out / "points.csv", data.encode())
    replace_bytes(out / "index.html", page.encode())


def csv_of(scenes: Sequence[Scene], own: dict[str, list[Point]]) -> str:
    """Format the measured points of all scenes as CSV text, for download from the page.

    ``own`` is a dict from the name of each scene to its points.
    """
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(COLUMNS)
    for scene in scenes:
        per = {model.name: model.per for model in scene.models}
        for p in own[scene.name]:
            times = (1e3 * time for time in (p.time, *p.spread))
            start = (scene.name, p.model, p.by, p.is_formula, p.steps, per[p.model], p.error)
            writer.writerow((*start, *(f"{time:.4g}" for time in times), p.work, scene.counted))
    return file.getvalue()
