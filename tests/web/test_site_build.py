"""The build of the site: what it needs, what it refuses, and what its parts are made of."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

from lab.drawing.pen import ARROWS, Pen
from lab.drawing.picture import DARK, HEIGHT, LIGHT, WIDTH
from typed import typed
from web import __main__ as site
from web import node
from web.stills import svg


def test_without_node_it_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert "there is no node: install Node.js" in node.missing()
    for name, version in (("node", "v18.1.0"), ("npm", "9")):
        (tmp_path / name).write_text(f"#!/bin/sh\necho {version}\n", encoding="utf-8")
        (tmp_path / name).chmod(0o755)
    assert node.missing() == "Node.js 20 or newer is needed, and this is v18.1.0"


def test_a_folder_with_something_else_in_it_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(ValueError, match="is neither empty nor an earlier build of the site"):
        site.build(tmp_path, with_solutions=False)
    assert (tmp_path / "thesis.txt").read_text(encoding="utf-8") == "mine"


def test_a_missing_node_is_told_before_anything_is_built(tmp_path: Path) -> None:
    done = typed("web", "--out", tmp_path / "site", PATH=str(tmp_path))
    assert done.returncode == 1
    assert done.stderr.startswith("make site: there is no node")
    assert done.stdout == ""


def test_a_picture_has_all_that_a_pen_draws_in_both_colors() -> None:
    pen = Pen()
    pen.circle((0.0, 0.0), 1.0, "blue")
    pen.dots([(1.0, 1.0), (2.0, 2.0)], "green")
    pen.line([(0.0, 0.0), (1.0, 1.0)], "black", dashed=True)
    pen.segments([((0.0, 0.0), (1.0, 1.0))], "gray")
    pen.area([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)], "water")
    pen.spring((0.0, 0.0), (2.0, 0.0), "brown")
    for kind in ("", *ARROWS):
        pen.arrow((0.0, 0.0), (1.0, 1.0), "orange", kind)
    pen.text((0.0, 1.0), "a < b", "violet")
    pen.ground(-1.0)
    drawn = ElementTree.fromstring(svg(pen.items, (-2.0, 2.0, -2.0, 2.0)))
    assert drawn.get("viewBox") == f"0 0 {WIDTH:g} {HEIGHT:g}"
    words = [shape for shape in drawn.iter() if shape.tag.endswith("text")]
    assert [word.text for word in words] == ["a < b"]
    light, dark = next(s for s in drawn.iter() if s.tag.endswith("style")).text.split("@media")
    styles = [shape.get("style") or "" for shape in drawn.iter()]
    for name in ("blue", "green", "black", "gray", "water", "brown", "orange", "violet"):
        count = sum(f"var(--{name})" in style for style in styles)
        # The ground is two shapes, and some arrows are hidden.
        assert count >= {"gray": 3}.get(name, 1) if name != "orange" else count == 2
        assert f"--{name}:{LIGHT[name]};" in light
        assert f"--{name}:{DARK[name]};" in dark
    circle = next(shape for shape in drawn.iter() if "fill: var(--blue)" in shape.get("style", ""))
    xs = [float(x) for x in re.findall(r"[MLC ]([\d.]+) [\d.]+", circle.get("d"))]
    assert (min(xs), max(xs)) == (220.0, 420.0)  # in the middle, with the scale of the height
