"""Plots for chapter 2. Their titles are computed without the engine's functions."""

from __future__ import annotations

import math
from collections.abc import Sequence

from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from ch02_vectors.calculus import difference_quotients
from ch02_vectors.recordings import thrown_ball
from ch02_vectors.vector import Vector3, make_orthonormal_basis
from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE, THEORY, Picture, arrow, axes_3d, finish
from scenes.readings import angle_between, cross, dot, is_drawable, number, numbers

COLUMNS = ("vector", "x", "y", "z")


def addition() -> Picture:
    """Draw two vectors and their sum, the diagonal of the parallelogram that they span."""
    a, b = (4.0, 1.0, 0.0), (1.0, 3.0, 0.0)
    corner = (5.0, 4.0, 0.0)
    total = numbers(Vector3(*a) + Vector3(*b))
    off = math.dist(total, corner)
    if not is_drawable(total):
        title = "a + b is not finite, so it cannot be drawn"
    elif off < 1e-9:
        title = "a + b ends at the far corner of the parallelogram of a and b"
    else:
        title = f"a + b misses the far corner of the parallelogram by {off:.3g}"
    figure, axes = _plane(title, 7, 6)
    arrow(axes, corner, "", GRAY, "--", tail=a)
    arrow(axes, corner, "", GRAY, "--", tail=b)
    arrow(axes, a, "a", BLUE)
    arrow(axes, b, "b", ORANGE)
    arrow(axes, total, "a + b", BLACK)
    return Picture(figure, COLUMNS, [("a", *a), ("b", *b), ("a + b", *total)])


def projection() -> Picture:
    """Draw a vector and its two parts, one along a direction and one perpendicular to it."""
    a, b = (math.cos(0.3), math.sin(0.3), 0.0), (2.0, 4.0, 0.0)
    direction, v = Vector3(*a), Vector3(*b)
    along = direction * direction.dot(v)
    part, rest = numbers(along), numbers(v - along)
    figure, axes = _plane(f"The angle between a and d is {angle_between(a, rest):.4g}°", 5, 5)
    axes.axline((0, 0), a[:2], color=GRAY, ls=":", label="line along a")
    arrow(axes, b, "b", ORANGE)
    arrow(axes, part, "c a, with c = a . b", BLUE)
    end = (part[0] + rest[0], part[1] + rest[1], part[2] + rest[2])
    arrow(axes, end, "d = b - c a", BLACK, tail=part)
    axes.legend(loc="lower right")
    rows = [("a", *a), ("b", *b), ("c a", *part), ("b - c a", *rest)]
    return Picture(figure, COLUMNS, rows)


def cross_product() -> Picture:
    """Draw the vector product of two vectors, and plot how its length depends on their angle."""
    a, b = (0.3, 0.1, 1.2), (1.0, 0.0, 0.2)
    product = numbers(Vector3(*a).cross(Vector3(*b)))
    figure = pyplot.figure(figsize=(10, 5), layout="constrained")
    space = axes_3d(figure, 121, 1.3)
    corners = [(0.0, 0.0, 0.0), a, (a[0] + b[0], a[1] + b[1], a[2] + b[2]), b]
    face = [[(z, x, y) for x, y, z in corners]]
    space.add_collection3d(Poly3DCollection(face, alpha=0.25, facecolor=GRAY))
    arrow(space, a, "a", BLUE)
    arrow(space, b, "b", ORANGE)
    arrow(space, product, "a x b", BLACK)
    angles = [angle_between(v, product) for v in (a, b, cross(a, b))]
    title = (
        "Angles of a x b: {:.4g}° to a, {:.4g}° to b and\n"
        "{:.4g}° to its direction in right-handed axes".format(*angles)
    )
    if not is_drawable(product):
        title = "a x b is not finite, so it cannot be drawn"
    space.set_title(title)

    degrees = range(0, 181, 5)
    lengths = [_product_length(math.radians(angle)) for angle in degrees]
    plane = figure.add_subplot(122)
    theory = [6.0 * math.sin(math.radians(angle)) for angle in degrees]
    plane.plot(degrees, theory, **THEORY, label="|a| |b| sin t")
    plane.plot(degrees, lengths, "o", color=BLACK, ms=4, label="|a x b|")
    plane.set(xlabel="angle t between a and b, degrees", ylabel="|a x b| for |a| = 2 and |b| = 3")
    plane.legend()
    rows = [*zip(degrees, lengths, theory, strict=True)]
    gap = max(abs(got - wanted) for _, got, wanted in rows)
    plane.set_title(f"|a x b| and |a| |b| sin t differ by at most {gap:.1g}")
    return Picture(figure, ("angle t, degrees", "|a x b|", "|a| |b| sin t"), rows)


def basis() -> Picture:
    """Draw an orthonormal basis, along with the two vectors from which it was built."""
    a, b = (1.6, 0.6, 0.4), (0.2, 1.3, 0.6)
    made = make_orthonormal_basis(Vector3(*a), Vector3(*b))
    first, second, third = (numbers(v) for v in made)
    figure = pyplot.figure(figsize=(6, 6), layout="constrained")
    space = axes_3d(figure, 111, 1.2)
    shown = {"a": a, "b": b, "first": first, "second": second, "third": third}
    for (name, v), color in zip(shown.items(), (GRAY, GRAY, BLUE, ORANGE, GREEN), strict=True):
        arrow(space, v, name, color, "--" if color == GRAY else "-")
    pairs = ((first, second), (second, third), (third, first))
    angles = ", ".join(f"{angle_between(v, w):.4g}°" for v, w in pairs)
    lengths = ", ".join(f"{math.sqrt(dot(v, v)):.4g}" for v in (first, second, third))
    is_right = dot(cross(first, second), third) > 0.0
    kind = "right-handed basis" if is_right else "basis that is not right-handed"
    title = f"A {kind}, with angles of {angles}\nand lengths of {lengths}"
    if not is_drawable(first, second, third):
        title = "A vector of the basis is not finite, so it cannot be drawn"
    space.set_title(title)
    return Picture(figure, COLUMNS, [(name, *v) for name, v in shown.items()])


def filmed_motion() -> Picture:
    """Plot the heights of a filmed ball, and the velocities and accelerations from them."""
    start, speed, gravity = 1.5, 6.0, 9.81  # the motion that was filmed, in m, m/s and m/s^2
    times, positions = thrown_ball()
    middles, velocities = _rates(times, positions)
    inner, accelerations = _rates(middles, velocities)
    panels = (
        ("height, m", times, positions, [start + speed * t - gravity * t * t / 2.0 for t in times]),
        ("velocity upward, m/s", middles, velocities, [speed - gravity * t for t in middles]),
        ("acceleration upward, m/s^2", inner, accelerations, [-gravity] * len(inner)),
    )
    figure, all_axes = pyplot.subplots(1, 3, figsize=(12, 4), layout="constrained")
    rows: list[tuple[object, ...]] = []
    for axes, (label, at, vectors, exact) in zip(all_axes, panels, strict=True):
        upward = [numbers(v)[1] for v in vectors]
        axes.plot(at, exact, **THEORY, label="exact")
        axes.plot(at[: len(upward)], upward[: len(at)], "o", color=BLACK, ms=3, label="measured")
        off = max((abs(y - wanted) for y, wanted in zip(upward, exact, strict=False)), default=0.0)
        kind, unit = label.rsplit(", ", 1)
        title = f"The {kind.split()[0]} is off\nby at most {off:.2g} {unit}"
        finish(axes, title, "time, s", label)
        rows += [(label, *row) for row in zip(at, upward, exact, strict=False)]
    all_axes[0].legend(loc="lower center")
    return Picture(figure, ("quantity", "time, s", "measured", "exact"), rows)


PLOTS = (addition, projection, cross_product, basis, filmed_motion)


def _rates(
    times: Sequence[float], vectors: Sequence[Vector3]
) -> tuple[list[float], Sequence[Vector3]]:
    """Call the student's difference_quotients. If it fails, there is nothing to draw."""
    try:
        middles, quotients = difference_quotients(times, vectors)
        return [number(time) for time in middles], list(quotients)
    except (ArithmeticError, AttributeError, TypeError, ValueError):
        return [], []


def _product_length(angle: float) -> float:
    """Let the engine compute |a x b| for |a| = 2 and |b| = 3 at an angle in a tilted plane."""
    along, across = 3.0 * math.cos(angle), 3.0 * math.sin(angle)
    a, b = Vector3(1.2, 1.6, 0.0), Vector3(0.6 * along, 0.8 * along, across)
    return math.hypot(*numbers(a.cross(b)))


def _plane(title: str, right: int, top: int) -> tuple[Figure, Axes]:
    """Create a figure of the X-Y plane from (-1, -1) to (right, top)."""
    figure, axes = pyplot.subplots(figsize=(6, 5), layout="constrained")
    finish(axes, title, "x", "y", xlim=(-1, right), ylim=(-1, top), aspect="equal")
    return figure, axes
