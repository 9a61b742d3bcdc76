"""Draw a picture of each scene, which readers see before they start the scene.

Run this program as `python -m web.stills FOLDER`. In most pictures, a script has played the scene
on the reference engine for a moment. A lesson can also start a scene with settings, as in `make lab
SCENE=... SET=...`. The picture then shows the initial state, so that it does not give away the
outcome.
"""

from __future__ import annotations

import argparse
import json
import re
from pathlib import Path

from autograder.handouts.handout import CHARTS
from autograder.manifest import ROOT
from lab.catalog import Entry, entries, load
from lab.drawing.pen import Pen
from scenes.clock import FRAME
from scenes.engine import use_engine
from web.svg import svg

COMMAND = re.compile(r'make lab SCENE=([\w-]+)(?:\s+SET="([^"]*)")?')
MOMENT = 0.4  # s


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
    """List the scenes that students can run on their own engine.

    The scene that replays the accuracy study is left out, because it always uses the reference
    solution.
    """
    return [e for e in entries() if e.module.rpartition(".")[2] != Path(CHARTS).stem]


def wanted() -> list[tuple[str, str]]:
    """List the pictures to draw, as pairs of a scene's name and its settings.

    Every scene gets one picture without settings. Each `make lab` command with settings in a lesson
    gets a picture of its own.
    """
    found = [(entry.name, "") for entry in scenes_of_students()]
    for lesson in sorted(ROOT.glob("chapters/*/README.md")):
        found += COMMAND.findall(lesson.read_text(encoding="utf-8").replace("\n> ", " "))
    return list(dict.fromkeys(found))


def still_name(scene: str, settings: str) -> str:
    """Return the file name of a scene's picture, without the suffix.

    For example, the scene one-spring with the setting stiffness=36 becomes
    "one-spring_stiffness-36".
    """
    return "_".join([scene, *settings.replace("=", "-").split()])


def still(name: str, settings: str) -> str:
    """Draw a scene as an SVG picture, with settings such as "rate=30 mass=1".

    Without settings, a scripted player plays the scene for 0.4 s before it is drawn.
    """
    values = dict(word.split("=", 1) for word in settings.split())
    scene = load(name)(**values)
    while not settings and scene.time < MOMENT:
        scene.play(scene.time)
        scene.advance(FRAME)
    pen = Pen()
    scene.draw(pen)
    return svg(pen.items, scene.view)


if __name__ == "__main__":
    main()
