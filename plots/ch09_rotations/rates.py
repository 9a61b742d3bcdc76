"""Plots for chapter 9: errors of the book's rotation step, and Euler angles near gimbal lock."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from typing import Any

from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from ch09_rotations.angular import first_order_drift
from ch09_rotations.euler import euler_rates, rate_map
from plots.drawing import BLACK, BLUE, GRAY, GREEN, ORANGE, PINK, RED, SKY, Picture, slope, tell
from scenes.readings import is_written, number, numbers, stopped, written
from scenes.rotations import (
    END,
    TAU,
    Step,
    Velocity,
    by_exponential,
    by_first_order,
    by_first_order_normalized,
    coning_orientation,
    coning_velocity,
    degrees_apart,
    largest,
    singular_values,
    steady_orientation,
    steady_velocity,
    turn_by_steps,
    worst_axis,
)

FLOOR = 1e-15  # where zeros and rounding errors are drawn on logarithmic axes
RATES = [10 * 2**n for n in range(8)]  # steps per second
WAYS: dict[str, tuple[Step, Velocity, float, str, str]] = {
    "steady axis, Eq. 9.5": (by_first_order, steady_velocity, 0.0, "o-", RED),
    "steady axis, Eq. 9.5, normalized": (
        *(by_first_order_normalized, steady_velocity, 0.0, "x", BLACK),
    ),
    "steady axis, rotate_by": (by_exponential, steady_velocity, 0.0, "D-", GREEN),
    "moving axis, Eq. 9.5, normalized": (
        *(by_first_order_normalized, coning_velocity, 0.0, "s-", ORANGE),
    ),
    "moving axis, rotate_by": (by_exponential, coning_velocity, 0.0, "^-", SKY),
    "moving axis, rotate_by, mid-step velocity": (
        *(by_exponential, coning_velocity, 0.5, "v-", BLUE),
    ),
}


def drift_of_first_order() -> Picture:
    """Plot the two errors of Eq. 9.5, the book's formula for rotating a quaternion by one step.

    Each step makes the quaternion longer, and rotates it by the wrong angle. Better integration
    methods are shown for comparison.
    """
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(14, 6.4), layout="constrained")
    rows: list[Sequence[object]] = []
    notes: list[str] = []
    seconds, rates = 3, (30, 60, 120, 240)
    ways = {("Eq. 9.5", rate): by_first_order for rate in rates} | {
        ("rotate_by", 30): by_exponential
    }
    scenes = {
        key: partial(turn_by_steps, step, steady_velocity, seconds * key[1], float(key[1]))
        for key, step in ways.items()
    }
    colors = dict(zip(ways, (RED, ORANGE, PINK, SKY, BLACK), strict=True))
    off, drift_off = [], []
    for (way, rate), (found, message) in written(scenes).items():
        color = colors[way, rate]
        times = [n / rate for n in range(len(found))]
        lengths = [math.hypot(*q) for q in found]
        growth = math.hypot(1.0, 0.5 * TAU / rate) if way == "Eq. 9.5" else 1.0
        lines = [growth**n for n in range(len(found))]
        off += [abs(a - b) for a, b in zip(lengths, lines, strict=True)]
        if way == "Eq. 9.5":
            drift_off.append(abs(_drift(float(seconds), seconds * rate)[0] - lengths[-1]))
        label = f"{way}, {rate} Hz: {lengths[-1]:.4g} after {times[-1]:.2g} s"
        left.plot(times, lengths, "o", color=color, ms=3, markevery=rate // 15, label=label)
        left.plot(times, lines, color=color, lw=1)
        rows += [("length", way, rate, *pair) for pair in zip(times, lengths, strict=True)]
        notes += [f"{way}, {rate} Hz: {message}"] if message else []
    left.plot(
        [], [], color=GRAY, lw=1, label="lines: (1 + (w h / 2)$^2$)$^{n/2}$ after n steps, or 1"
    )
    left.set_title(
        "One turn per second about a steady axis: the length differs from the\n"
        f"closed form (lines) by at most {largest(off):.2g}{_of_drift(drift_off, '')}",
        fontsize=11,
    )
    left.set(xlabel="time, s", ylabel="length of the quaternion")
    left.legend(fontsize=8.5, loc="upper left")
    _errors_in_angle(right, rows, notes)
    for axes in (left, right):
        axes.grid(alpha=0.3)
    tell(figure, notes)
    return Picture(figure, ("what", "method", "steps per second", "time, s", "value"), rows)


def gimbal_lock() -> Picture:
    """Plot how Euler angles fail near gimbal lock, where the middle angle is 90°.

    In gimbal lock, no change of the angles can rotate a body about a certain axis. Near it, a
    rotation about that axis makes the angles change faster and faster.
    """
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13, 5.8), layout="constrained")
    x, z = 0.4, 1.1  # rad; any values would do
    degrees = range(-90, 91, 3)
    distances = [10.0 ** (-0.25 * n) for n in range(-7, 25)]  # degrees
    found = written(
        {
            "map": lambda: [singular_values(rate_map(x, math.radians(y), z)) for y in degrees],
            "rates": lambda: [_worst_rate(x, distance, z) for distance in distances],
        }
    )
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
        flat = [zip(a, b, strict=True) for a, b in zip(found["map"], theory, strict=True)]
        off = largest([abs(a - b) for pairs in flat for a, b in pairs])
        left.set_title(
            f"Singular values of rate_map: the smallest is {found['map'][-1][2]:.2g} at 90°,\n"
            f"all differ from sqrt(1 + |sin y|), 1, sqrt(1 - |sin y|) (gray) by at most {off:.2g}",
            fontsize=11,
        )
        left.legend(fontsize=9, loc="lower center")
    if "rates" in found:
        theory = [1.0 / (math.sqrt(2.0) * math.sin(math.radians(0.5 * d))) for d in distances]
        rates = [rate for rate, _ in found["rates"]]
        right.loglog(distances, theory, color=GRAY, lw=4, alpha=0.4, label="1 / sqrt(1 - sin y)")
        right.loglog(
            distances, rates, "o", color=RED, ms=4, label="length of the result of euler_rates"
        )
        refused = [_refuses(x, math.radians(angle)) for angle in range(0, 360, 30)]
        right.set_title(
            "The Euler rates of 1 rad/s about the worst axis: slope "
            f"{slope(distances[16:], rates[16:]):.4f};\n"
            f"at 90° euler_rates raises an error for {sum(refused)} of {len(refused)} angles z",
            fontsize=11,
        )
        right.legend(fontsize=9)
        tell(figure, [*dict.fromkeys(message for _, message in found["rates"] if message)])
        rows += [("rates, rad/s", 90.0 - d, rate) for d, rate in zip(distances, rates, strict=True)]
    left.set(xlabel="middle angle y, degrees", ylabel="singular value of rate_map, no unit")
    left.set_xticks(range(-90, 91, 30))
    right.set(xlabel="distance of y from 90°, degrees", ylabel="length of the Euler rates, rad/s")
    for axes in (left, right):
        axes.grid(alpha=0.3)
    return Picture(figure, ("what", "y, degrees", "value"), rows)


def _errors_in_angle(axes: Any, rows: list[Sequence[object]], notes: list[str]) -> None:
    """Plot the angle error of each integration method against the length of the time step."""
    found = written({way: partial(_ends, way, notes) for way in WAYS})
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


def _drift(duration: float, steps: int) -> tuple[float, float]:
    """Return the errors of Eq. 9.5 that the student's function first_order_drift predicts.

    The errors are reported as two numbers. The first is the final length of the quaternion, which
    should be 1. The second is how far the rotation lags behind, as an angle in degrees. Both are
    NaN if the student has not written the function yet.
    """
    found: list[object] = []
    if is_written(lambda: found.append(first_order_drift(TAU, duration, steps))):
        length, angle = found[0] if isinstance(found[0], tuple) else (None, None)
        return number(length), math.degrees(number(angle))
    return math.nan, math.nan


def _of_drift(off: Sequence[float], unit: str) -> str:
    """Return the part of a plot's title that reports the error of first_order_drift.

    ``off`` contains the differences between the predictions of this function and the measured
    values. If the student has not written the function yet, return an empty string.
    """
    if not is_written(lambda: first_order_drift(TAU, 1.0, 10)):
        return ""
    return f",\nfirst_order_drift differs from the measurement by {largest([*off]):.2g}{unit}"


def _ends(way: str, notes: list[str]) -> list[float]:
    """Measure the error of an integration method at the end of a rotation, for each step rate.

    ``way`` is the name of the method. The errors are angles in degrees.
    """
    step, velocity, share, *_ = WAYS[way]
    wanted = (steady_orientation if velocity is steady_velocity else coning_orientation)(END)
    errors = []
    for rate in RATES:
        steps = round(END * rate)
        found, message = turn_by_steps(step, velocity, steps, float(rate), share)
        errors.append(degrees_apart(found[-1], wanted) if not message else math.nan)
        notes += [f"{way}, {rate} Hz: {message}"] if message else []
    return errors


def _worst_rate(x: float, distance: float, z: float) -> tuple[float, str]:
    """Measure how fast Euler angles change near gimbal lock, in a rotation about the worst axis.

    ``distance`` is the angle to gimbal lock in degrees, and the body rotates at 1 rad/s. Return the
    magnitude of the Euler rates in rad/s, and the text of any error.
    """
    left = math.radians(distance)
    found: list[float] = []

    def act() -> None:
        turning = Vector3(*worst_axis(left, z))
        found.append(math.hypot(*numbers(euler_rates(x, 0.5 * math.pi - left, z, turning))))

    message = stopped(act)
    return (found[0], "") if found else (math.nan, message)


def _refuses(x: float, z: float) -> bool:
    """Return True if euler_rates raises an error for the axis that is lost in gimbal lock."""
    lost = worst_axis(0.0, z)
    return bool(stopped(lambda: euler_rates(x, 0.5 * math.pi, z, Vector3(*lost))))
