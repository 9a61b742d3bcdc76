"""Plots for chapter 9: a disc that spins as it flies, and the order of two rotations."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from functools import partial
from typing import Any

import numpy
from matplotlib import pyplot
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import integrate_rotation
from ch09_rotations.matrix import Matrix3
from ch09_rotations.quaternion import Quaternion
from plots.ch09_rotations import orientations as exact
from plots.ch09_rotations.orientations import Arrows, X, Y, Z, arrows_by_engine, largest, turn
from plots.drawing import BLACK, BLUE, GRAY, GREEN, RED, SKY, Picture, arrow, axes_3d, slope, tell
from scenes.readings import Numbers, cross, is_drawable, is_written, stopped, tried

ORIGIN = (0.0, 0.0, 0.0)
NOWHERE: Arrows = ((math.nan,) * 3, (math.nan,) * 3, (math.nan,) * 3)
COLORS = (RED, GREEN, BLUE)  # of an object's own axes X, Y and Z
PAPER = [2, 0, 1]  # the order of x, y and z in matplotlib, where the third axis points up
# The corners of a block's faces, if its eight corners are ordered like binary numbers.
FACES = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]

# A thin disc is thrown and wobbles. Its axis is tilted from the vertical by TILT, and rotates about
# the vertical at PRECESSION. The moment of inertia about a diameter is half of that about the axis.
# It follows that the disc also spins about its axis at SPIN, against the precession.
TILT = math.radians(25.0)
PRECESSION = math.tau * 0.9
SPIN = -0.5 * PRECESSION * math.cos(TILT)
FLIGHT = 1.2  # s
AXIS = (math.sin(TILT), math.cos(TILT), 0.0)
TILTED = turn((0.0, 0.0, -1.0), TILT)  # the disc's own Y along its axis


def turning_motion() -> Picture:
    """Draw seven snapshots of a wobbling disc in flight, along with its axes."""
    rates = (120, 240, 480)
    throws = {rate: throw_disc(rate) for rate in rates}
    shown = throws[240][0]
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
        for truth in disc_arrows(n / 240):
            ends = _on_paper([place, _along(place, truth, 0.95)])
            space.plot(*ends, color=GRAY, lw=1.0, ls="--")
        if n < len(shown):
            _disc(space, place, shown[n])
            for name, color, v in zip("XYZ", COLORS, shown[n], strict=True):
                label = name if i in (0, 6) else ""
                arrow(space, _along(place, v, 0.75), label, color, tail=place)
    for artist in (*space.collections, *space.lines, *space.texts):
        artist.set_clip_on(False)  # the picture extends beyond matplotlib's axes

    rows: list[Sequence[object]] = []
    worst = []
    for rate, (found, _) in throws.items():
        off = [exact.off_directions(v, disc_arrows(n / rate)) for n, v in enumerate(found)]
        worst.append(largest(off))
        for n, (axes, error) in enumerate(zip(found, off, strict=True)):
            flat = [value for v in axes for value in v]
            rows.append((rate, n / rate, *disc_place(n / rate), *flat, error))
    space.set_title(
        "A thrown disc that wobbles, by integrate_rotation: its axes X, Y, Z,"
        " and the exact axes (dashed)\n"
        "240 steps per second: right angles off by up to "
        f"{largest([*map(exact.off_right_angles, shown)]):.2g}°, "
        f"lengths by {largest([*map(exact.off_unit_length, shown)]):.2g},\n"
        f"errors of the directions at most {worst[0]:.3g}°, {worst[1]:.3g}° and {worst[2]:.3g}° "
        f"with {rates[0]}, {rates[1]} and {rates[2]} steps per second: "
        f"order {-slope(rates, worst):.2f} in the step",
        fontsize=11,
    )
    tell(figure, [f"{rate} Hz: {message}" for rate, (_, message) in throws.items() if message])
    names = [f"{axis}.{name}" for axis in "XYZ" for name in "xyz"]
    head = ("steps per second", "time, s", "x, m", "y, m", "z, m", *names, "error, degrees")
    return Picture(figure, head, rows)


def disc_place(time: float) -> Numbers:
    """Compute the position of the disc, which flies along a parabola and lands 6 m away."""
    return 6.0 * time / FLIGHT, 0.5 * 9.81 * time * (FLIGHT - time), 0.0


def disc_arrows(time: float) -> Arrows:
    """Compute the exact directions of the disc's axes."""
    spun = exact.product(turn(AXIS, SPIN * time), TILTED)
    return exact.arrows(exact.product(turn(Y, PRECESSION * time), spun))


def disc_acceleration(time: float) -> Numbers:
    """Compute the angular acceleration: the precession keeps changing the spin's direction."""
    x, y, z = exact.rotated(turn(Y, PRECESSION * time), AXIS)
    return cross((0.0, PRECESSION, 0.0), (SPIN * x, SPIN * y, SPIN * z))


def throw_disc(rate: int) -> tuple[list[Arrows], str]:
    """Simulate the disc's rotation with integrate_rotation, in ``rate`` steps per second.

    Return the axes at the start and after each step, and the text of any error.
    """
    orientation = Quaternion(*TILTED)
    velocity = Vector3(SPIN * AXIS[0], SPIN * AXIS[1] + PRECESSION, 0.0)
    found: list[Arrows] = []

    def run() -> None:
        found.append(arrows_by_engine(orientation))
        for n in range(round(FLIGHT * rate)):
            now = Vector3(*disc_acceleration(n / rate))
            integrate_rotation(orientation, velocity, now, 1.0 / rate)
            found.append(arrows_by_engine(orientation))

    return found, stopped(run)


def order_of_turns() -> Picture:
    """Draw a letter L rotated by 90° about the world's X and Y axes, in both orders."""
    figure = pyplot.figure(figsize=(10.5, 7.2), layout="constrained")
    grid = figure.add_gridspec(2, 3)
    quarter = {
        name: exact.components(Quaternion.from_axis_angle(Vector3(*axis), 0.5 * math.pi))
        for name, axis in (("X", X), ("Y", Y))
    }
    rows: list[Sequence[object]] = []
    notes: list[str] = []
    ends: dict[str, list[Arrows]] = {"quaternions": [], "matrices": []}
    for row, order in enumerate(("XY", "YX")):
        first, second = (Quaternion(*quarter[name]) for name in order)
        both = Quaternion(*exact.components(second * first))
        words = ("at the start", f"90° about {order[0]}", f"then 90° about {order[1]}")
        turned = (partial(arrows_by_engine, q) for q in (Quaternion(), first, both))
        by_quaternions, messages = zip(*(tried(act, NOWHERE) for act in turned), strict=True)
        notes += filter(None, messages)
        by_matrices = _by_matrices(first, second, notes)
        for column, name in enumerate(words):
            space = axes_3d(figure, grid[row, column], 1.15)
            space.set(xticklabels=[], yticklabels=[], zticklabels=[])
            space.set(xlabel="", ylabel="", zlabel="")
            space.set_title(name, fontsize=11)
            space.set_box_aspect((1, 1, 1), zoom=1.15)
            for axis, label in ((X, "x"), (Y, "y"), (Z, "z")):
                space.plot(*_on_paper([ORIGIN, _along(ORIGIN, axis, 1.3)]), color=GRAY, lw=1)
                space.text(*_on_paper([_along(ORIGIN, axis, 1.45)])[:, 0], label, color=GRAY)
            _letter(space, by_quaternions[column])
            for label, color, v in zip("XYZ", COLORS, by_quaternions[column], strict=True):
                arrow(space, v, label, color)
            for v in by_matrices[column] if by_matrices else ():
                space.plot(*_on_paper([ORIGIN, _along(ORIGIN, v, 1.3)]), "k--", lw=1)
        for how, states in (("quaternions", by_quaternions), ("matrices", by_matrices)):
            ends[how] += states[2:]
            for name, state in zip(words, states, strict=False):
                for label, v in zip("XYZ", state, strict=True):
                    rows.append((order, name, how, label, *v))
    angles = {
        how: exact.degrees_between_arrows(*pair) for how, pair in ends.items() if len(pair) == 2
    }
    told = [f"by {how} {angle:.7g}°" for how, angle in angles.items()]
    lines = [f"The angle between the upper and the lower result: {', '.join(told)}"]
    if "matrices" in angles:
        off = largest([exact.off_directions(*pair) for pair in zip(*ends.values(), strict=True)])
        lines.append(f"Results by matrices (dashed) and by quaternions differ by {off:.3g}°")
    figure.suptitle("\n".join(lines), fontsize=12)
    tell(figure, notes)
    return Picture(figure, ("order", "state", "by", "axis", "x", "y", "z"), rows)


def _by_matrices(first: Quaternion, second: Quaternion, notes: list[str]) -> list[Arrows]:
    """Return X, Y and Z before, between and after two turns by matrix, or [] if that fails."""
    found: list[Arrows] = []

    def act() -> None:
        a, b = (Matrix3(*exact.entries(Matrix3.from_quaternion(q))) for q in (first, second))
        found.extend([(X, Y, Z), _columns(a), _columns(b.product(a))])

    messages: list[str] = []
    if is_written(lambda: messages.append(stopped(act))):
        notes += filter(None, messages)
    return found


def _columns(matrix: Any) -> Arrows:
    """Return the columns of an engine's Matrix3, which are the axes of a rotated body."""
    a, b, c, d, e, f, g, h, i = exact.entries(matrix)
    return (a, d, g), (b, e, h), (c, f, i)


def _letter(space: Any, found: Arrows) -> None:
    """Draw a rotated letter L, which stands upright and faces along Z before the rotation."""
    if is_drawable(*found):
        for x, y in (((-0.1, 0.1), (-0.1, 0.8)), ((0.1, 0.5), (-0.1, 0.1))):
            corners = numpy.array([*itertools.product(x, y, (-0.1, 0.1))]) @ numpy.array(found)
            faces = corners[:, PAPER][FACES]
            look = {"alpha": 0.3, "facecolor": GRAY, "edgecolor": BLACK}
            space.add_collection3d(Poly3DCollection(faces, **look))


def _disc(space: Any, place: Numbers, found: Arrows) -> None:
    """Draw a rotated disc with a radius of 0.45 m, which is perpendicular to its Y axis."""
    if is_drawable(*found):
        around = numpy.radians(range(0, 360, 10))
        rim = numpy.outer(numpy.cos(around), found[0]) + numpy.outer(numpy.sin(around), found[2])
        face = (place + 0.45 * rim)[:, PAPER]
        space.add_collection3d(Poly3DCollection([face], alpha=0.35, facecolor=SKY, edgecolor=GRAY))


def _along(place: Numbers, v: Numbers, length: float) -> Numbers:
    return place[0] + length * v[0], place[1] + length * v[1], place[2] + length * v[2]


def _on_paper(points: Iterable[Numbers]) -> Any:
    """Return the coordinates of points for matplotlib, one array for each of its axes."""
    return numpy.array([*points]).T[PAPER]
