"""Draw vectors, or the path of a particle, with the characters of a terminal."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from functools import wraps
from string import ascii_lowercase
from typing import Any

WIDTH, HEIGHT = 61, 21  # characters; one is about twice as high as it is wide
LONGEST_PATH = 500  # positions that are kept of each particle

Point = tuple[float, float]
Place = tuple[float, float, float]
_paths: dict[int, tuple[Any, deque[Place]]] = {}  # keyed by id, with the particle, which keeps it


def show(*things: Any) -> None:
    """Draw vectors as arrows from the origin, and particles with the path of their last steps."""
    lines: list[list[Place]] = []
    labels = []
    for letter, thing in zip(ascii_lowercase, things, strict=False):
        if hasattr(thing, "position"):
            _, path = _paths.get(id(thing), (thing, deque()))
            lines.append([*path, _place(thing.position)])
            labels.append(f"{letter}: position {thing.position}, velocity {thing.velocity}")
        elif hasattr(thing, "x"):
            ahead = [i / WIDTH for i in range(WIDTH + 1)]
            lines.append([(thing.x * t, thing.y * t, thing.z * t) for t in ahead])
            labels.append(f"{letter}: {thing}")
        else:
            raise TypeError(f"show draws vectors and particles, got {thing!r}")
    # X points to the right and Y up. If everything has x = 0, Z points to the right instead.
    across = 0 if any(place[0] for line in lines for place in line) else 2
    print(picture([[(place[across], place[1]) for place in line] for line in lines]))
    print(f"to the right: {'XYZ'[across]}, up: Y", *labels, sep="\n")


def _place(position: Any) -> Place:
    return position.x, position.y, position.z


def picture(lines: list[list[Point]]) -> str:
    """Return a drawing of lines of points, each with a letter at its end, and of the origin (+)."""
    points = [(0.0, 0.0), *(point for line in lines for point in line)]
    left, right = min(x for x, _ in points), max(x for x, _ in points)
    low, high = min(y for _, y in points), max(y for _, y in points)
    scale = max((right - left) / (WIDTH - 1), (high - low) / (HEIGHT - 1) / 2.0) or 1.0
    rows = round((high - low) / scale / 2.0) + 1
    cells = [[" "] * WIDTH for _ in range(rows)]

    ends = [(line[-1], letter) for letter, line in zip(ascii_lowercase, lines, strict=False)]
    for (x, y), mark in [*((point, "·") for point in points), ((0.0, 0.0), "+"), *ends]:
        cells[round((high - y) / scale / 2.0)][round((x - left) / scale)] = mark
    drawn = "\n".join("".join(row).rstrip() for row in cells)
    return f"{drawn}\none character to the right is {scale:.3g}, one line is {2.0 * scale:.3g}"


def remember_paths(kind: type) -> None:
    """Make a class of particles remember where its particles have been."""
    for name in ("drift", "kick"):
        if method := vars(kind).get(name):
            setattr(kind, name, _remembering(method))


def _remembering(method: Callable[..., Any]) -> Callable[..., Any]:
    @wraps(method)
    def step(particle: Any, duration: float) -> Any:
        _, path = _paths.setdefault(id(particle), (particle, deque(maxlen=LONGEST_PATH)))
        here = _place(particle.position)
        if not path or path[-1] != here:
            path.append(here)
        return method(particle, duration)

    return step
