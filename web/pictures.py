"""Copy the pictures of the pages, without loss but smaller where WebP is, and note their sizes."""

from __future__ import annotations

import io
from pathlib import Path

from PIL import Image

from autograder.manifest import ROOT


def copy_pictures(out: Path) -> dict[str, dict[str, object]]:
    """Copy all still pictures into a folder; return name, width and height by their path.

    Animations stay behind: a scene that runs on the page takes the place of each.
    """
    out.mkdir(parents=True, exist_ok=True)
    found = {}
    for file in sorted(ROOT.glob("chapters/*/*.png")):
        picture = Image.open(file)
        packed = io.BytesIO()
        picture.save(packed, "WEBP", lossless=True, quality=60, method=4)
        content, suffix = min((packed.getvalue(), ".webp"), (file.read_bytes(), ".png"), key=_size)
        name = f"{file.parent.name}-{file.stem}{suffix}"
        (out / name).write_bytes(content)
        path = file.relative_to(ROOT).as_posix()
        found[path] = {"name": name, "width": picture.width, "height": picture.height}
    return found


def _size(kind: tuple[bytes, str]) -> int:
    return len(kind[0])
