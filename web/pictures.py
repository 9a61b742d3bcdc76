"""Convert the pictures of the lessons to smaller files that look the same."""

from __future__ import annotations

import bisect
import functools
import io
from pathlib import Path

from PIL import Image, ImageChops, ImageStat

from autograder.manifest import ROOT

PALETTES = range(8, 200, 8)  # numbers of colors to try before the full picture is kept
ROUNDS = 3  # of k-means, which fits the colors of a palette to the picture
UNSEEN = 2.5  # root-mean-square difference, out of 255, that nobody sees


def copy_pictures(out: Path) -> dict[str, dict[str, object]]:
    """Convert all still pictures of the lessons to WebP files in the folder ``out``.

    Animations are not copied, because the page runs the scene itself instead.

    Returns:
        The name, width and height of the new file, for the path of each original picture.
    """
    out.mkdir(parents=True, exist_ok=True)
    found = {}
    for file in sorted(ROOT.glob("chapters/*/pictures/*.png")):
        picture = Image.open(file)
        content = _packed(picture)
        name = f"{file.parent.parent.name}-{file.stem}.webp"
        (out / name).write_bytes(content)
        path = file.relative_to(ROOT).as_posix()
        found[path] = {"name": name, "width": picture.width, "height": picture.height}
    return found


def _packed(picture: Image.Image) -> bytes:
    """Convert a picture to WebP with the fewest colors that cause no visible change."""
    full = picture.convert("RGB")

    @functools.cache
    def with_colors(colors: int) -> Image.Image:
        return full.quantize(
            colors, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE, kmeans=ROUNDS
        ).convert("RGB")

    def looks_same(colors: int) -> bool:
        difference = ImageChops.difference(full, with_colors(colors))
        return max(ImageStat.Stat(difference).rms) <= UNSEEN

    first = bisect.bisect_left(PALETTES, True, key=looks_same)
    packed = io.BytesIO()
    less = with_colors(PALETTES[first]) if first < len(PALETTES) else full
    less.save(packed, "WEBP", lossless=True, quality=100, method=4)
    return packed.getvalue()
