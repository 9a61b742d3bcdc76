"""Plots for chapter 9: errors of the book's rotation step, and Euler angles near gimbal lock."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy
from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift
from ch09_rotations.euler import euler_rates, rate_map
from ch09_rotations.quaternion import Quaternion
from plots.ch09_rotations import orientations as exact
from plots.ch09_rotations.orientations import Components, components, largest, product, turn
from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE, PINK, RED, SKY, Picture, slope, tell
from scenes.readings import Numbers, is_written, number, numbers, stopped, tried, written

FLOOR = 1e-15  # where zeros and rounding errors are drawn on logarithmic axes
RATES = [10 * 2**n for n in range(8)]  # steps per second
FIRST, LAST = 0.4, 1.1  # rad, the first and the last Euler angle; any values would do
TAU = math.tau
Step = Callable[[Quaternion, Vector3, float], None]  # takes orientation, velocity, duration

# Two rotations for comparing methods. The first is a steady turn per second about a slanted axis,
# from an orientation with another slant. In the second, the axis also moves around Z, along a cone,
# at half a turn per second. The errors are measured at END, because after a whole turn some of them
# would cancel, and a product in the wrong order would not show.
END = 0.7  # s
START = turn((1.0, -2.0, 0.5), 1.0)
STEADY = (TAU * 2.0 / 3.0, -TAU / 3.0, TAU * 2.0 / 3.0)
CONING, SLANTING = 0.5 * TAU, (TAU * 0.6, 0.0, TAU * 0.8)


def steady(time: float) -> tuple[Numbers, Components]:
    """Return the angular velocity and the exact orientation in the steady rotation."""
    return STEADY, product(turn(STEADY, TAU * time), START)


def coning(time: float) -> tuple[Numbers, Components]:
    """Return the angular velocity and the exact orientation if the axis moves along a cone."""
    around = turn(exact.Z, CONING * time)
    x, y, z = exact.rotated(around, SLANTING)
    return (x, y, z + CONING), product(around, product(turn(SLANTING, TAU * time), START))


def eq_9_5(q: Quaternion, velocity: Vector3, duration: float) -> None:
    """Make a step of the book's first-order formula."""
    q.add_scaled(velocity, duration)


def eq_9_5_normalized(q: Quaternion, velocity: Vector3, duration: float) -> None:
    """Make a step of the book's first-order formula, and normalize the quaternion."""
    q.add_scaled(velocity, duration)
    q.normalize()


def rotate_by(q: Quaternion, velocity: Vector3, duration: float) -> None:
    """Make a step with the exponential of the rotation."""
    q.rotate_by(Vector3(*(component * duration for component in numbers(velocity))))


Motion = Callable[[float], tuple[Numbers, Components]]
# The step, the motion, the fraction of a step at which the velocity is taken, style and color.
WAYS: dict[str, tuple[Step, Motion, float, str, str]] = {
    "steady axis, Eq. 9.5": (eq_9_5, steady, 0.0, "o-", RED),
    "steady axis, Eq. 9.5, normalized": (eq_9_5_normalized, steady, 0.0, "x", BLACK),
    "steady axis, rotate_by": (rotate_by, steady, 0.0, "D-", GREEN),
    "moving axis, Eq. 9.5, normalized": (eq_9_5_normalized, coning, 0.0, "s-", ORANGE),
    "moving axis, rotate_by": (rotate_by, coning, 0.0, "^-", SKY),
    "moving axis, rotate_by, mid-step velocity": (rotate_by, coning, 0.5, "v-", BLUE),
}


def drift_of_first_order() -> Picture:
    """Plot the errors of Eq. 9.5 in length and angle, and those of better methods."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(14, 6.4), layout="constrained")
    rows: list[Sequence[object]] = []
    notes: list[str] = []
    seconds = 3
    lines: dict[tuple[str, int], tuple[Step, str]] = {
        ("Eq. 9.5", 30): (eq_9_5, RED),
        ("Eq. 9.5", 60): (eq_9_5, ORANGE),
        ("Eq. 9.5", 120): (eq_9_5, PINK),
        ("Eq. 9.5", 240): (eq_9_5, SKY),
        ("rotate_by", 30): (rotate_by, BLACK),
    }
    runs = {
        key: partial(_turned, step, steady, seconds, key[1]) for key, (step, _) in lines.items()
    }
    off, drift_off = [], []
    for (way, rate), (found, message) in written(runs).items():
        color = lines[way, rate][1]
        times = [n / rate for n in range(len(found))]
        lengths = [math.hypot(*q) for q in found]
        growth = math.hypot(1.0, 0.5 * TAU / rate) if way == "Eq. 9.5" else 1.0
        theory = [growth**n for n in range(len(found))]
        off += [abs(a - b) for a, b in zip(lengths, theory, strict=True)]
        if way == "Eq. 9.5":
            drift_off.append(abs(_drift(float(seconds), seconds * rate)[0] - lengths[-1]))
        label = f"{way}, {rate} Hz: {lengths[-1]:.4g} after {times[-1]:.2g} s"
        left.plot(times, lengths, "o", color=color, ms=3, markevery=rate // 15, label=label)
        left.plot(times, theory, color=color, lw=1)
        rows += [("length", way, rate, *pair) for pair in zip(times, lengths, strict=True)]
        notes += [f"{way}, {rate} Hz: {message}"] if message else []
    label = "lines: (1 + (w h / 2)$^2$)$^{n/2}$ after n steps, or 1"
    left.plot([], [], color=GRAY, lw=1, label=label)
    left.set_title(
        "One turn per second about a steady axis: the length differs from the\n"
        f"closed form (lines) by at most {largest(off):.2g}{_of_drift(drift_off, '')}",
        fontsize=11,
    )
    left.set(xlabel="time, s", ylabel="length of the quaternion")
    left.legend(fontsize=8.5, loc="upper left")
    _plot_errors(right, rows, notes)
    for axes in (left, right):
        axes.grid(alpha=0.3)
    tell(figure, notes)
    return Picture(figure, ("what", "method", "steps per second", "time, s", "value"), rows)


def _plot_errors(axes: Any, rows: list[Sequence[object]], notes: list[str]) -> None:
    """Plot the angle error of each integration method against the length of the time step."""
    found = written({way: partial(_errors, way, notes) for way in WAYS})
    steps = [1.0 / rate for rate in RATES]
    for way, errors in found.items():
        *_, style, color = WAYS[way]
        if max(errors) < 1e-9:
            label = f"{way}: at most {max(errors):.1g}°"
        else:
            order = slope(steps[-4:], errors[-4:])
            label = f"{way}: order {order:.2f}, {errors[3]:.2g}° at {RATES[3]} Hz"
        shown = [max(error, FLOOR) for error in errors]
        axes.loglog(steps, shown, style, color=color, ms=8 if style == "x" else 6, label=label)
        rows += [("error", way, rate, END, e) for rate, e in zip(RATES, errors, strict=True)]
    lines = [f"Error of the orientation after {END:g} s, by time step"]
    bare, mended = (found.get(f"steady axis, Eq. 9.5{how}") for how in ("", ", normalized"))
    if bare and mended:
        apart = largest([abs(a - b) for a, b in zip(bare, mended, strict=True)])
        lines.append(f"Normalizing changes the angle of Eq. 9.5 by at most {apart:.2g}°")
    if bare:
        drifts = [_drift(END, round(END * rate))[1] for rate in RATES]
        off = [abs(drift - error) for drift, error in zip(drifts, bare, strict=True)]
        lines[-1] += _of_drift(off, "°")
    axes.set_title("\n".join(lines), fontsize=11)
    axes.set(xlabel="time step h, s", ylabel="error of the angle, degrees", ylim=(FLOOR, 1e3))
    axes.legend(fontsize=8.5, loc="center", bbox_to_anchor=(0.5, 0.4))


def _errors(way: str, notes: list[str]) -> list[float]:
    """Measure the error of a method at END in degrees, for each step rate."""
    step, motion, fraction, *_ = WAYS[way]
    errors = []
    for rate in RATES:
        found, message = _turned(step, motion, END, rate, fraction)
        errors.append(math.nan if message else exact.degrees_apart(found[-1], motion(END)[1]))
        notes += [f"{way}, {rate} Hz: {message}"] if message else []
    return errors


def _turned(
    step: Step, motion: Motion, seconds: float, rate: int, fraction: float = 0.0
) -> tuple[list[Components], str]:
    """Rotate a quaternion step by step from START, and return all orientations and any error.

    The angular velocity is taken at a ``fraction`` of each step.
    """
    q = Quaternion(*START)
    found = [components(q)]

    def run() -> None:
        for n in range(round(seconds * rate)):
            step(q, Vector3(*motion((n + fraction) / rate)[0]), 1.0 / rate)
            found.append(components(q))

    return found, stopped(run)


def _drift(duration: float, steps: int) -> tuple[float, float]:
    """Return the length and lag in degrees by first_order_drift, or NaN if not written."""
    found: list[object] = []
    if is_written(lambda: found.append(first_order_drift(TAU, duration, steps))):
        length, angle = found[0] if isinstance(found[0], tuple) else (None, None)
        return number(length), math.degrees(number(angle))
    return math.nan, math.nan


def _of_drift(off: Sequence[float], unit: str) -> str:
    """Return the part of a title that reports errors of first_order_drift, if it is written."""
    if not is_written(lambda: first_order_drift(TAU, 1.0, 10)):
        return ""
    return f",\nfirst_order_drift differs from the measurement by {largest(off):.2g}{unit}"


def gimbal_lock() -> Picture:
    """Plot how Euler angles fail near gimbal lock, where the middle angle is 90°."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.8), layout="constrained")
    degrees = range(-90, 91, 3)
    distances = [10.0 ** (-0.25 * n) for n in range(-7, 25)]  # degrees
    runs: dict[str, Callable[[], list[Any]]] = {
        "map": lambda: [_singular_values(math.radians(y)) for y in degrees],
        "rates": lambda: [_worst_rate(math.radians(distance)) for distance in distances],
    }
    found = written(runs)
    rows: list[Sequence[object]] = []
    if "map" in found:
        sines = [abs(math.sin(math.radians(y))) for y in degrees]
        theory = [(math.sqrt(1.0 + s), 1.0, math.sqrt(1.0 - s)) for s in sines]
        names = ("largest", "middle", "smallest")
        for i, (name, color) in enumerate(zip(names, (ORANGE, GREEN, BLUE), strict=True)):
            seen = [triple[i] for triple in found["map"]]
            left.plot(degrees, [t[i] for t in theory], color=GRAY, lw=4, alpha=0.4)
            left.plot(degrees, seen, "o", color=color, ms=4, label=f"{name}: {seen[-1]:.2g} at 90°")
            rows += [(f"{name} singular value", *pair) for pair in zip(degrees, seen, strict=True)]
        off = largest([*abs(numpy.subtract(found["map"], theory)).flat])
        left.set_title(
            f"Singular values of rate_map: the smallest is {found['map'][-1][2]:.2g} at 90°,\n"
            f"all differ from sqrt(1 + |sin y|), 1, sqrt(1 - |sin y|) (gray) by at most {off:.2g}",
            fontsize=11,
        )
        left.legend(fontsize=9, loc="lower center")
    if "rates" in found:
        lengths, messages = zip(*found["rates"], strict=True)
        curve = [1.0 / (math.sqrt(2.0) * math.sin(math.radians(0.5 * d))) for d in distances]
        right.loglog(distances, curve, color=GRAY, lw=4, alpha=0.4, label="1 / sqrt(1 - sin y)")
        label = "length of the result of euler_rates"
        right.loglog(distances, lengths, "o", color=RED, ms=4, label=label)
        # In gimbal lock, euler_rates should raise an error for the axis that is lost.
        last = [math.radians(angle) for angle in range(0, 360, 30)]
        locked = [(FIRST, 0.5 * math.pi, z, _worst_axis(0.0, z)) for z in last]
        refused = [bool(stopped(partial(euler_rates, *angles))) for angles in locked]
        right.set_title(
            "The Euler rates of 1 rad/s about the worst axis: slope "
            f"{slope(distances[16:], lengths[16:]):.4f};\n"
            f"at 90° euler_rates raises an error for {sum(refused)} of {len(refused)} angles z",
            fontsize=11,
        )
        right.legend(fontsize=9)
        tell(figure, [*dict.fromkeys(filter(None, messages))])
        for distance, length in zip(distances, lengths, strict=True):
            rows.append(("rates, rad/s", 90.0 - distance, length))
    left.set(xlabel="middle angle y, degrees", ylabel="singular value of rate_map, no unit")
    left.set_xticks(range(-90, 91, 30))
    right.set(xlabel="distance of y from 90°, degrees", ylabel="length of the Euler rates, rad/s")
    for axes in (left, right):
        axes.grid(alpha=0.3)
    return Picture(figure, ("what", "y, degrees", "value"), rows)


def _singular_values(y: float) -> list[float]:
    """Compute the singular values of the student's rate_map, largest first, or three times NaN."""
    found = exact.entries(rate_map(FIRST, y, LAST))
    if not all(map(math.isfinite, found)):
        return [math.nan] * 3
    return numpy.linalg.svd(numpy.reshape(found, (3, 3)), compute_uv=False).tolist()


def _worst_axis(distance: float, z: float) -> Vector3:
    """Return the axis halfway between Z and the rotated X, which changes the angles fastest.

    The Euler angle y is ``distance`` rad below 90 degrees.
    """
    along = math.cos(0.5 * distance)
    return Vector3(math.cos(z) * along, math.sin(z) * along, math.sin(0.5 * distance))


def _worst_rate(distance: float) -> tuple[float, str]:
    """Return the length of the Euler rates at 1 rad/s about the worst axis, and any error."""
    angles = FIRST, 0.5 * math.pi - distance, LAST
    rates, message = tried(lambda: euler_rates(*angles, _worst_axis(distance, LAST)), None)
    return math.hypot(*numbers(rates)), message
