"""Copy the pages' pictures as smaller files that look the same, and return their sizes."""

from __future__ import annotations

import io
from pathlib import Path

from PIL import Image, ImageChops, ImageStat

from autograder.manifest import ROOT

PALETTES = (64, 128)  # numbers of colors to try before the full picture is kept
UNSEEN = 2.5  # root-mean-square difference, out of 255, that nobody sees


def copy_pictures(out: Path) -> dict[str, dict[str, object]]:
    """Copy all still pictures into a folder. Return a name, a width and a height for each path.

    Animations are not copied, because the page runs the scene itself instead.
    """
    out.mkdir(parents=True, exist_ok=True)
    found = {}
    for file in sorted(ROOT.glob("chapters/*/*.png")):
        picture = Image.open(file)
        content = _packed(picture)
        name = f"{file.parent.name}-{file.stem}.webp"
        (out / name).write_bytes(content)
        path = file.relative_to(ROOT).as_posix()
        found[path] = {"name": name, "width": picture.width, "height": picture.height}
    return found


def _packed(picture: Image.Image) -> bytes:
    """Return a picture in WebP format. It has fewer colors if the difference is invisible."""
    full = picture.convert("RGB")
    for colors in PALETTES:
        less = full.quantize(
            colors, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE
        ).convert("RGB")
        if max(ImageStat.Stat(ImageChops.difference(full, less)).rms) <= UNSEEN:
            full = less
            break
    packed = io.BytesIO()
    full.save(packed, "WEBP", lossless=True, quality=60, method=4)
    return packed.getvalue()
