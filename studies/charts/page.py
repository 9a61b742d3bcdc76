"""Write the charts of all scenes to one web page, and all data points to a CSV file.

The page has every number in tables. Its script draws the charts from them, with Observable Plot
(https://observablehq.com/plot), which is part of the page. The page needs no other files.
"""

from __future__ import annotations

import csv
import io
import re
import textwrap
from collections.abc import Sequence
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from autograder.files import replace_bytes
from autograder.manifest import ROOT
from autograder.text.marked import with_text
from scenes.clock import RATE
from studies.accuracy.catalog import group_of, scenes_with
from studies.accuracy.measure import Point
from studies.accuracy.results import TOLERANCES, Row, front, models_of, table
from studies.accuracy.scene import Scene
from studies.charts import ratios
from studies.stored import store

HERE = Path(__file__).parent
LIBRARIES = ("d3.min.js", "d3.LICENSE", "plot.umd.min.js", "plot.LICENSE")
CEILING = 10.0  # runs with larger errors are useless
COLUMNS = (
    *("scene", "model", "by", "is a better model", "steps, or 1 / tolerance", "per frames"),
    "error / scale",
    *("time, ms", "lower quartile, ms", "upper quartile, ms", "work", "what is counted as work"),
)
# Colors of style.css, and symbols of Plot. The integrators have the colors of the other pictures.
OWN = {
    "explicit Euler": "red",
    "semi-implicit Euler": "blue",
    "leapfrog": "violet",
    "velocity Verlet": "sky",
    "Runge-Kutta 4": "green",
    "backward Euler": "orange",
    "trapezoidal rule": "pink",
    "adaptive": "brown",
}
OURS = ("blue", "green", "orange", "sky", "pink", "brown", "violet", "yellow")
FILLED = ("square", "triangle", "diamond", "hexagon", "star", "wye", "cross")
LINES = ("times", "plus", "asterisk")
LOOKS = {
    "ours": [(color, symbol) for symbol in FILLED for color in OURS],
    "the book": [("red", symbol) for symbol in (*LINES, *FILLED)],
    "pymunk": [(color, symbol) for symbol in (*LINES, *FILLED) for color in ("black", "gray")],
}

PICTURE, PAGE = "studies/accuracy/overview.png", "studies/accuracy/charts.html"
FIGURES = "studies/accuracy/figures.json"
READMES = ("README.md", "studies/README.md")
SHOWN = re.compile(r"!\[[^\]]*\](?=\([^)]*overview\.png\))")
BEGIN, END = "<!-- ratios: `make measure WHAT=charts` writes this -->", "<!-- end of ratios -->"


def write(scenes: Sequence[Scene], points: Sequence[Point], how: str, out: Path) -> None:
    """Write all charts to ``index.html``, and all data points to ``points.csv``.

    ``how`` is a sentence for the page on how the times were measured.
    """
    own = {scene.name: [p for p in points if p.scene == scene.name] for scene in scenes}
    groups: dict[str, list[dict[str, Any]]] = {}
    for scene in scenes:
        group = groups.setdefault(group_of()[scene.name], [])
        group.append(panel(scene, own[scene.name]))
    figures = ratios.figures_of(table(points))
    environment = Environment(
        loader=FileSystemLoader(HERE),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    page = environment.get_template("page.html").render(
        groups=groups,
        models=sorted({point.model for point in points}),
        figures={(f["scene"], f["is_formula"], f["tolerance"]): f for f in figures},
        tolerances=TOLERANCES,
        ratios=ratios,
        looks=looks(),
        how=how,
        columns=COLUMNS,
        ceiling=CEILING,
        id=id,
        **{file.replace(".", "_"): _read(f"vendor/{file}") for file in LIBRARIES},
        style=_read("style.css"),
        script=_read("script.js"),
    )
    replace_bytes(out / "points.csv", csv_of(scenes, own).encode())
    replace_bytes(out / "index.html", page.encode())


def _read(name: str) -> str:
    return (HERE / name).read_text(encoding="utf-8")


def panel(scene: Scene, points: Sequence[Point]) -> dict[str, Any]:
    """Prepare the section of a scene for the template, from its measured points."""
    best = {id(point) for point in front(points) if point.error < CEILING}
    own, rows = models_of(points), table(points)
    return {
        "scene": scene,
        "about": f"{scene.frames / RATE:.3g} s; errors in units of its scale, {scene.scale:.3g} m",
        "said": ratios.said(points, 1e-4),
        "rows": [*zip(rows, ratios.figures_of(rows), strict=True)],
        "models": [(model, own[model.name]) for model in scene.models if model.name in own],
        "best": best,
    }


@cache
def looks() -> dict[str, tuple[str, str]]:
    """Return a color and a symbol for every model, which it has in every chart.

    No two models of a scene look alike, as long as there are enough symbols.
    """
    scenes = [{model.name: model.by for model in scene.models} for scene in scenes_with("")]
    found = {name: (color, "circle") for name, color in OWN.items()}
    for scene in scenes:
        for name, by in scene.items():
            if name not in found:
                near = [found.get(other) for each in scenes if name in each for other in each]
                found[name] = next((look for look in LOOKS[by] if look not in near), LOOKS[by][0])
    return found


def csv_of(scenes: Sequence[Scene], own: dict[str, list[Point]]) -> str:
    """Format the measured points of all scenes, which ``own`` groups by name, as CSV text."""
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


def keep(rows: Sequence[Row], day: str, out: Path, root: Path = ROOT) -> None:
    """Copy the picture, the page and the ratios in ``out``, measured on ``day``, to the repository.

    The READMEs get a new description of the picture, and one of them a new table.
    """
    replace_bytes(root / PICTURE, (out / "overview.png").read_bytes())
    replace_bytes(root / PAGE, (out / "index.html").read_bytes())
    figures = ratios.figures_of(rows)
    store(root / FIGURES, measured=day, pymunk=metadata.version("pymunk"), rows=figures)
    alt = "\n".join(textwrap.wrap(f"![{ratios.described(rows)}]", 105, break_long_words=False))
    for name in READMES:
        path = root / name
        text = SHOWN.sub(lambda _: alt, path.read_text(encoding="utf-8"))
        if BEGIN in text:
            text = with_text(text, BEGIN, END, ratios.table(figures))
        replace_bytes(path, text.encode())
