"""Draw a picture of each scene, which readers see before they start the scene.

Run this program as `python -m web.stills FOLDER`. In most pictures, a script has played the scene
on the reference engine for a moment. A lesson can also start a scene with settings, as in `make lab
SCENE=... SET=...`. The picture then shows the initial state, so that it does not give away the
outcome.
"""

from __future__ import annotations

import argparse
import io
import json
import re
from pathlib import Path

from matplotlib import rc_context
from matplotlib.figure import Figure

from autograder.handouts.handout import CHARTS
from autograder.manifest import ROOT
from lab.catalog import Entry, entries, load
from lab.drawing.pen import COLORS, Item, Pen
from lab.drawing.picture import DARK, HEIGHT, LIGHT, WIDTH, Painter
from scenes.clock import FRAME
from scenes.engine import use_engine

COMMAND = re.compile(r'make lab SCENE=([\w-]+)(?:\s+SET="([^"]*)")?')
MOMENT = 0.4  # s
HIDDEN = ("force", "contact")  # arrows that a page shows only on request
# A color that stands for each name until the name itself is written into a picture.
MARKS = {name: f"#0000{number:02x}" for number, name in enumerate(COLORS, 1)}
WITHOUT = dict.fromkeys(("Date", "Creator", "Type", "Format"))  # no notes about its making


def main() -> None:
    """Draw a picture of each scene into a folder, and list the scenes in scenes.json."""
    parser = argparse.ArgumentParser(prog="python -m web.stills", description=__doc__)
    parser.add_argument("folder", type=Path)
    folder: Path = parser.parse_args().folder
    use_engine(parser, "solutions")
    folder.mkdir(parents=True, exist_ok=True)
    for scene, settings in wanted():
        (folder / f"{still_name(scene, settings)}.svg").write_text(
            still(scene, settings), encoding="utf-8", newline="\n"
        )
    scenes = [
        {"name": e.name, "title": e.title, "chapter": e.chapter, "question": load(e.name).question}
        for e in scenes_of_students()
    ]
    (folder / "scenes.json").write_text(json.dumps(scenes), encoding="utf-8")


def scenes_of_students() -> list[Entry]:
    """List all scenes but the accuracy study's, which only runs on the reference."""
    return [e for e in entries() if e.module.rpartition(".")[2] != Path(CHARTS).stem]


def wanted() -> list[tuple[str, str]]:
    """List each scene without settings, and with those of `make lab` commands in lessons."""
    found = [(entry.name, "") for entry in scenes_of_students()]
    for lesson in sorted(ROOT.glob("chapters/*/README.md")):
        found += COMMAND.findall(lesson.read_text(encoding="utf-8").replace("\n> ", " "))
    return list(dict.fromkeys(found))


def still_name(scene: str, settings: str) -> str:
    """Return a file name without suffix, such as "one-spring_stiffness-36"."""
    return "_".join([scene, *settings.replace("=", "-").split()])


def still(name: str, settings: str) -> str:
    """Draw a scene with settings such as "rate=30 mass=1", or else after 0.4 s of play."""
    values = dict(word.split("=", 1) for word in settings.split())
    scene = load(name)(**values)
    while not settings and scene.time < MOMENT:
        scene.play(scene.time)
        scene.advance(FRAME)
    pen = Pen()
    scene.draw(pen)
    return svg(pen.items, scene.view)


def svg(items: list[Item], view: tuple[float, float, float, float]) -> str:
    """Turn what a scene's pen recorded into an SVG picture with the lab's light and dark colors."""
    left, right, bottom, top = view
    scale = max((right - left) / WIDTH, (top - bottom) / HEIGHT)
    x, y = (left + right) / 2.0, (bottom + top) / 2.0
    figure = Figure(figsize=(WIDTH / 72.0, HEIGHT / 72.0))
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(x - 0.5 * scale * WIDTH, x + 0.5 * scale * WIDTH)
    axes.set_ylim(y - 0.5 * scale * HEIGHT, y + 0.5 * scale * HEIGHT)
    shown = [item for item in items if item[0] != "arrow" or item[-1] not in HIDDEN]
    Painter(axes, MARKS, 1.0).draw(shown)
    file = io.StringIO()
    with rc_context({"svg.fonttype": "none", "svg.hashsalt": "still"}):
        figure.savefig(file, format="svg", metadata=WITHOUT, transparent=True)
    return _slim(file.getvalue())


def _slim(drawn: str) -> str:
    """Shorten matplotlib's SVG, and let its colors and letters be those of the page."""
    names = [*MARKS]
    light, dark = ("".join(f"--{n}:{sheet[n]};" for n in names) for sheet in (LIGHT, DARK))
    rules = f"svg{{{light}}}@media (prefers-color-scheme:dark){{svg{{{dark}}}}}</style>"
    for pattern, replacement in (
        (r"(?s)^.*?(?=<svg)", ""),
        (r' (clip-path="url|transform="rotate|id="[A-Za-z0-9]+_\d+(?="))[^"]*"', ""),
        (r"(?s)<clipPath.*?</clipPath>", ""),
        (r'="(\d+)pt"', r'="\1"'),
        (r"font-family: [^;]*", "font-family: system-ui, sans-serif"),
        (r"\d+\.\d+", lambda number: f"{float(number[0]):.4g}"),
        (r"#0000([0-9a-f]{2})", lambda mark: f"var(--{names[int(mark[1], 16) - 1]})"),
        (r"\s*\n\s*", "\n"),
    ):
        drawn = re.sub(pattern, replacement, drawn)
    return drawn.replace("</style>", rules, 1)


if __name__ == "__main__":
    main()
