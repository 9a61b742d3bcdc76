"""Plots for chapter 9: a disc that spins as it flies, and the order of two rotations.

The title of each plot reports errors that are computed without the student's engine, so that they
reveal bugs in it. A curve is omitted if the student has not yet written the functions that it
needs. For Eq. 9.5 and gimbal lock, see rates.py. For the box of stones, see stones.py.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import product
from typing import Any

from matplotlib import pyplot
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from ch02_vectors.vector import Vector3
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import Quaternion
from plots.drawing import (
    BLACK,
    BLUE,
    GRAY,
    GREEN,
    LABEL,
    RED,
    SKY,
    Picture,
    arrow_3d,
    axes_3d,
    slope,
    tell,
)
from scenes.readings import Numbers, is_drawable, is_written, stopped
from scenes.rotations import (
    FLIGHT,
    NOWHERE,
    Arrows,
    X,
    Y,
    Z,
    arrows,
    arrows_by_engine,
    columns,
    components,
    degrees_between_arrows,
    disc_orientation,
    disc_place,
    largest,
    nine,
    off_directions,
    off_right_angles,
    off_unit_length,
    throw_disc,
)

ORIGIN = (0.0, 0.0, 0.0)
COLORS = (RED, GREEN, BLUE)  # of an object's own axes X, Y and Z
SMALL = LABEL | {"fontsize": 9}


def turning_motion() -> Picture:
    """Draw seven snapshots of a wobbling disc in flight, along with its axes."""
    rates = (120, 240, 480)
    throws = {rate: throw_disc(rate) for rate in rates}
    shown = throws[240]
    figure = pyplot.figure(figsize=(13, 6.4))
    figure.subplots_adjust(0.0, 0.08, 1.0, 0.88)
    space = axes_3d(figure, 111, 1.0)
    space.set(ylim=(-0.6, 6.6), zlim=(-0.6, 2.6), xlabel="z, m", ylabel="x, m", zlabel="y, m")
    space.set_box_aspect((2.0, 7.2, 3.2), zoom=1.7)
    space.set_xticks((-1, 0, 1))
    space.set_zticks((0, 1, 2))
    space.view_init(elev=18, azim=12)
    path = [disc_place(FLIGHT * i / 100) for i in range(101)]
    space.plot(*_on_paper(path), color=GRAY, lw=1, ls=":")
    for i in range(7):
        n = round(i * FLIGHT / 6.0 * 240)
        place = disc_place(n / 240)
        for truth in arrows(disc_orientation(n / 240)):
            tip = _along(place, truth, 0.95)
            space.plot(*_on_paper([place, tip]), color=GRAY, lw=1.0, ls="--")
        if n < len(shown.found):
            found = shown.found[n]
            _disc(space, place, found)
            for name, color, v in zip("XYZ", COLORS, found, strict=True):
                label = name if i in (0, 6) else ""
                arrow_3d(space, _along(place, v, 0.75), label, color, tail=place)
    for artist in (*space.collections, *space.lines, *space.texts):
        artist.set_clip_on(False)  # the picture extends beyond matplotlib's axes
    off = [throws[rate].worst_direction() for rate in rates]
    space.set_title(
        "A thrown disc that wobbles, by integrate_rotation: its axes X, Y, Z,"
        " and the exact axes (dashed)\n"
        f"240 steps per second: right angles off by up to {shown.worst(off_right_angles):.2g}°, "
        f"lengths by {shown.worst(off_unit_length):.2g},\n"
        f"errors of the directions at most {off[0]:.3g}°, {off[1]:.3g}° and {off[2]:.3g}° "
        f"with {rates[0]}, {rates[1]} and {rates[2]} steps per second: "
        f"order {-slope(rates, off):.2f} in the step",
        fontsize=11,
    )
    tell(figure, [f"{rate} Hz: {throw.message}" for rate, throw in throws.items() if throw.message])
    rows: list[Sequence[object]] = []
    for rate, throw in throws.items():
        for time, found, wanted in zip(throw.times, throw.found, throw.wanted, strict=True):
            flat = [value for v in found for value in v]
            rows.append((rate, time, *disc_place(time), *flat, off_directions(found, wanted)))
    names = [f"{axis}.{name}" for axis in "XYZ" for name in "xyz"]
    head = ("steps per second", "time, s", "x, m", "y, m", "z, m", *names, "error, degrees")
    return Picture(figure, head, rows)


def order_of_turns() -> Picture:
    """Draw a letter L rotated by 90° about the world's X and Y axes, in both orders.

    The two results differ, because rotations do not commute.
    """
    figure = pyplot.figure(figsize=(10.5, 7.2), layout="constrained")
    grid = figure.add_gridspec(2, 3)
    quarter = {
        name: components(Quaternion.from_axis_angle(Vector3(*axis), 0.5 * math.pi))
        for name, axis in (("X", X), ("Y", Y))
    }
    rows: list[Sequence[object]] = []
    notes: list[str] = []
    ends: dict[str, list[Arrows]] = {"quaternions": [], "matrices": []}
    for row, order in enumerate(("XY", "YX")):
        first, second = (Quaternion(*quarter[name]) for name in order)
        both = Quaternion(*components(second * first))
        words = ("at the start", f"90° about {order[0]}", f"then 90° about {order[1]}")
        by_quaternions = [_by_quaternion(q, notes) for q in (Quaternion(), first, both)]
        by_matrices = _by_matrices(first, second, notes)
        for column, name in enumerate(words):
            space = axes_3d(figure, grid[row, column], 1.15)
            space.set(xticklabels=[], yticklabels=[], zticklabels=[])
            space.set(xlabel="", ylabel="", zlabel="")
            space.set_title(name, fontsize=11)
            space.set_box_aspect((1, 1, 1), zoom=1.15)
            for axis, label in ((X, "x"), (Y, "y"), (Z, "z")):
                space.plot(*_on_paper([ORIGIN, _along(ORIGIN, axis, 1.3)]), color=GRAY, lw=1)
                space.text(*_point(_along(ORIGIN, axis, 1.45)), label, color=GRAY)
            _letter(space, by_quaternions[column])
            for label, color, v in zip("XYZ", COLORS, by_quaternions[column], strict=True):
                arrow_3d(space, v, label, color)
            for v in by_matrices[column] if by_matrices else ():
                space.plot(*_on_paper([ORIGIN, _along(ORIGIN, v, 1.3)]), "k--", lw=1)
        for how, states in (("quaternions", by_quaternions), ("matrices", by_matrices)):
            ends[how] += states[2:]
            for name, state in zip(words, states, strict=False):
                for label, v in zip("XYZ", state, strict=True):
                    rows.append((order, name, how, label, *v))
    angles = {how: degrees_between_arrows(*pair) for how, pair in ends.items() if len(pair) == 2}
    told = [f"by {how} {angle:.7g}°" for how, angle in angles.items()]
    lines = [f"The angle between the upper and the lower result: {', '.join(told)}"]
    if "matrices" in angles:
        pairs = zip(*ends.values(), strict=True)
        off = largest([off_directions(*pair) for pair in pairs])
        lines.append(f"Results by matrices (dashed) and by quaternions differ by {off:.3g}°")
    figure.suptitle("\n".join(lines), fontsize=12)
    tell(figure, notes)
    return Picture(figure, ("order", "state", "by", "axis", "x", "y", "z"), rows)


def _by_quaternion(q: Quaternion, notes: list[str]) -> Arrows:
    """Rotate the vectors X, Y and Z with a quaternion from the student's engine.

    If the engine raises an exception, add its message to ``notes`` and return NOWHERE, in which
    every component is NaN.
    """
    found: list[Arrows] = []
    if message := stopped(lambda: found.append(arrows_by_engine(q))):
        notes.append(message)
    return found[0] if found else NOWHERE


def _by_matrices(first: Quaternion, second: Quaternion, notes: list[str]) -> list[Arrows]:
    """Rotate the vectors X, Y and Z twice with matrices from the student's engine.

    Return the vectors before the rotations, after the first one, and after both. If the engine
    fails or its matrices are not written yet, return an empty list.
    """
    found: list[Arrows] = []

    def act() -> None:
        a, b = (Matrix3(*nine(Matrix3.from_quaternion(q))) for q in (first, second))
        found.extend([(X, Y, Z), columns(a), columns(b.product(a))])

    messages: list[str] = []
    if is_written(lambda: messages.append(stopped(act))):
        notes += filter(None, messages)
    return found


def _letter(space: Any, found: Arrows) -> None:
    """Draw a letter L that has been rotated.

    Before the rotation, it stands upright and faces along Z. ``found`` contains the directions of
    its X, Y and Z axes after the rotation.
    """
    if is_drawable(*found):
        for x, y in (((-0.1, 0.1), (-0.1, 0.8)), ((0.1, 0.5), (-0.1, 0.1))):
            _block(space, found, (x, y, (-0.1, 0.1)))


def _block(space: Any, found: Arrows, sides: Sequence[tuple[float, float]]) -> None:
    """Draw a rectangular block that has been rotated.

    ``sides`` are the intervals that the block covers along its own X, Y and Z axes. ``found``
    contains the directions of these axes after the rotation.
    """
    corners = {c: _beyond(ORIGIN, found, c) for c in product(*sides)}
    faces = []
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        for end in sides[i]:
            face = [c for c in corners if c[i] == end]
            face.sort(key=lambda c: (c[j], c[k] if c[j] == sides[j][0] else -c[k]))  # in order
            faces.append([_point(corners[c]) for c in face])
    space.add_collection3d(Poly3DCollection(faces, alpha=0.3, facecolor=GRAY, edgecolor=BLACK))


def _disc(space: Any, place: Numbers, found: Arrows) -> None:
    """Draw a rotated disc at ``place``, with a radius of 0.45 m.

    ``found`` contains the directions of its X, Y and Z axes. The Y axis is perpendicular to the
    disc.
    """
    if is_drawable(*found):
        around = [math.radians(angle) for angle in range(0, 360, 10)]
        rim = [(0.45 * math.cos(a), 0.0, 0.45 * math.sin(a)) for a in around]
        face = [_point(_beyond(place, found, own)) for own in rim]
        space.add_collection3d(Poly3DCollection([face], alpha=0.35, facecolor=SKY, edgecolor=GRAY))


def _beyond(place: Numbers, found: Arrows, own: Numbers) -> Numbers:
    """Convert a point from a rotated object's local coordinates to world coordinates.

    ``own`` is the point in local coordinates. ``place`` is the position of the object, and
    ``found`` contains the directions of its local X, Y and Z axes in world coordinates.
    """
    x, y, z = (
        at + math.fsum(v[i] * c for v, c in zip(found, own, strict=True))
        for i, at in enumerate(place)
    )
    return x, y, z


def _along(place: Numbers, v: Numbers, length: float) -> Numbers:
    return place[0] + length * v[0], place[1] + length * v[1], place[2] + length * v[2]


def _point(v: Numbers) -> Numbers:
    """Reorder a vector's components for matplotlib, where the third axis points up."""
    return v[2], v[0], v[1]


def _on_paper(points: Iterable[Numbers]) -> list[tuple[float, ...]]:
    return [*zip(*map(_point, points), strict=True)]
