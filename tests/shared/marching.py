"""Compute a motion from a table of accelerations with plain numbers, as exercise B2.13 does."""

from __future__ import annotations

from itertools import pairwise

from draw import Components


def march(
    rows: list[Components], spans: list[float], p: Components, v: Components, keeps: str = ""
) -> tuple[list[float], list[float]]:
    """Return all positions and velocities. ``keeps`` names what each interval starts with again."""
    places, motions = [*p], [*v]
    place, motion = list(p), list(v)
    for row, h in zip(rows, spans, strict=True):
        start = list(p) if keeps == "position" else place
        speed = list(v) if keeps == "velocity" else motion
        place = [x + u * h + a * h * h / 2.0 for x, u, a in zip(start, speed, row, strict=True)]
        motion = [u + a * h for u, a in zip(speed, row, strict=True)]
        places += place
        motions += motion
    return places, motions


def march_slips(
    times: list[float], rows: list[Components], p: Components, v: Components
) -> list[tuple[tuple[list[float], list[float]], str]]:
    """Return what likely mistakes with several intervals give, and their causes."""
    spans = [end - start for start, end in pairwise(times)]
    own = "Each interval has its own duration, times[i + 1] - times[i]."
    return [
        (
            march(rows, [spans[0]] * 4, p, v),
            f"You use the duration of the first interval for all intervals. {own}",
        ),
        (
            march(rows, [t - times[0] for t in times[1:]], p, v),
            f"You measure each duration from the first time. {own}",
        ),
        (
            march(rows, [(times[-1] - times[0]) / 4.0] * 4, p, v),
            f"You use the average duration for all intervals. {own}",
        ),
        (
            march([rows[0]] * 4, spans, p, v),
            "You use the first acceleration in all intervals. Each interval has its own.",
        ),
        (
            march(rows, spans, p, v, "velocity"),
            "You start each interval with the first velocity. Start it with the last one that you "
            "have computed.",
        ),
        (
            march(rows, spans, p, v, "position"),
            "You start each interval at the first position. Start it at the last one that you "
            "have computed.",
        ),
    ]
