"""Plots for chapter 6: when springs, cloths and penalty forces become unstable."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from functools import partial
from itertools import pairwise

from matplotlib import pyplot

from ch02_vectors.vector import Vector3
from ch06_springs.going_further.cloth import make_cloth
from ch06_springs.springs import FakeStiffSpring
from plots.ch06_springs.one_spring import true_places
from plots.drawing import BLACK, BLUE, COLORS, GRAY, RED, Picture, growth_bar, growth_map, legends
from scenes import stability
from scenes.clock import FRAME, Track, track
from scenes.integrators import INTEGRATORS, SOLVERS
from scenes.readings import numbers, written

CLOTH_SECONDS = 2


def stability_map() -> Picture:
    """Map how much a spring's oscillations grow per time step, with the limits from theory."""
    figure, panels = pyplot.subplots(2, 4, figsize=(16, 8), layout="constrained")
    *maps, key = panels.flat
    kappas = [0.01 * 10.0 ** (i / 12.0) for i in range(49)]
    by_particle, by_spring = [1.0 - i / 40.0 for i in range(39)], [i / 10.0 for i in range(21)]
    dampings = dict.fromkeys(INTEGRATORS, by_particle) | dict.fromkeys(SOLVERS, by_spring)

    def growths(name: str) -> list[list[float]]:
        return [[stability.growth_of(name, d, kappa) for kappa in kappas] for d in dampings[name]]

    grown = written({name: partial(growths, name) for name in dampings})
    rows: list[Sequence[object]] = []
    deviations = []
    for axes, name in zip(maps, dampings, strict=True):
        axes.set_title(name)
        if name not in grown:
            axes.text(0.5, 0.5, "not written yet", transform=axes.transAxes, ha="center")
            continue
        colored = growth_map(axes, kappas, dampings[name], grown[name], in_spring=name in SOLVERS)
        for damping, line in zip(dampings[name], grown[name], strict=True):
            rows += [(name, damping, *pair, "") for pair in zip(kappas, line, strict=True)]
        if name in SOLVERS:
            axes.set_title(f"{name}: at most x {max(map(max, grown[name])):.4f}", fontsize=11)
            continue
        line = [0.05 + 0.949 * i / 99.0 for i in range(100)]
        axes.plot([stability.theory(name, kept) for kept in line], line, color=BLACK)
        for kept in (0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 1.0):
            if (true := stability.theory(name, kept)) > 0.0:
                limit = stability.limit_of(partial(stability.growth_of, name, kept))
                deviations.append(abs(limit / true - 1.0))
                rows.append((f"{name}, limit", kept, limit, 1.0, true))
                axes.plot(limit, kept, "o", color="white", mec=BLACK)
    growth_bar(figure, panels, colored)
    key.set_axis_off()
    if deviations:
        key.plot([], [], color=BLACK, label="limit from theory")
        key.plot([], [], "o", color="white", mec=BLACK, label="measured limit")
        key.legend(loc="center")
        figure.suptitle(
            f"The measured limits differ from theory by a fraction of at most {max(deviations):.1g}"
        )
    columns = ("method", "d^h or c h / m", "k h^2 / m", "growth per step", "limit from theory")
    return Picture(figure, columns, rows)


def fake_spring() -> Picture:
    """Compare a faked stiff spring with a real one, and show at which steps its swings grow."""
    figure, (bare, damped, right) = pyplot.subplots(1, 3, figsize=(15, 4.8), layout="constrained")
    k, frames = 400.0, 90
    times = [i * FRAME for i in range(frames + 1)]
    rows: list[Sequence[object]] = []
    for axes, c in ((bare, 0.0), (damped, 4.0)):
        exact = true_places(k, c, times)
        axes.plot(times, exact, color=BLACK, lw=1, label="true spring")
        own = math.exp(-c / 2.0 * FRAME)
        words = [f"c = {c:g} N s/m. True: x {own:.4f} per frame, period {_period(exact):.3f} s"]
        fake = FakeStiffSpring(Vector3(), k, c)
        run = partial(stability.swing, generator=fake, steps=frames, limit=1e3)
        steps = {name: INTEGRATORS[name] for name in ("semi-implicit Euler", "explicit Euler")}
        runs = written({name: partial(run, step) for name, step in steps.items()})
        for name, (places, _) in runs.items():
            seen, color = places.values, COLORS[name]
            axes.plot(places.times, seen, ".-", ms=3, lw=0.8, color=color, label=f"faked, {name}")
            rows += [("swing", name, c, *row) for row in zip(times, exact, seen, strict=False)]
            factor = stability.growth(steps[name], fake)
            words.append(f"{name}: x {factor:.4f} per frame, period {_period(seen):.3f} s")
        axes.set_title("\n".join(words), fontsize=9)
        axes.set(xlabel="time, s", ylabel="x, m (400 N/m, 1 kg, 60 Hz)", ylim=(-4.0, 4.0))
    angles = [0.1 + 0.02 * i for i in range(596)]
    words = []
    for share, color, label in ((0.0, RED, "no damping"), (0.05, BLUE, "1/20 of critical damping")):
        grown = {angle: stability.faked_growth(angle, share) for angle in angles}
        right.plot(*zip(*grown.items(), strict=True), color=color, lw=1.2, label=label)
        rows += [("growth", "semi-implicit Euler", share, *pair, "") for pair in grown.items()]
        most, angle = max((factor, angle) for angle, factor in grown.items())
        words.append(f"{label}: at most x {most:.3f}, at $\\chi$ h = {angle:.2f}")
    right.axhline(1.0, color=BLACK, lw=0.8)
    for i in (1, 3):
        right.axvline(i * math.pi, color=GRAY, lw=1, ls=":")
    right.set_xlabel(r"$\chi$ h (dotted: $\pi$ and 3 $\pi$)")
    right.set_ylabel("growth per frame with semi-implicit Euler")
    right.set_title("\n".join(words), fontsize=9)
    legends(bare, damped, loc="upper left")
    legends(right)
    kind, time = "c or fraction of critical", "time, s, or chi h"
    columns = ("part", "step", kind, time, "true m, or growth", "faked m")
    return Picture(figure, columns, rows)


def _period(places: Sequence[float]) -> float:
    """Return the time per oscillation in s, or NaN if there are too few zero crossings."""
    found = [i + a / (a - b) for i, (a, b) in enumerate(pairwise(places)) if a * b < 0.0]
    return 2.0 * (found[-1] - found[0]) / (len(found) - 1) * FRAME if found[1:] else math.nan


def cloth_frame_rates() -> Picture:
    """Plot how long a cloth of springs stays stable at each frame rate, with two integrators."""
    figure, axes = pyplot.subplots(figsize=(9, 5.2), layout="constrained")
    rows: list[Sequence[object]] = []
    book = (30, 60, 120, 240, 480, 960)
    rates = {
        "explicit Euler": book,
        "semi-implicit Euler": (30, 45, 60, 70, 75, 80, 82, 85, 90, 120),
    }
    note = ""
    keys = [(name, c, rate) for name in rates for c in (0.2, 0.0) for rate in rates[name]]
    falls = written({key: partial(_fall, *key) for key in keys})
    for name, damping in dict.fromkeys(key[:2] for key in falls):
        found = {rate: falls[name, damping, rate] for rate in rates[name]}
        lasts = {rate: (len(fall.times) - 1) / rate for rate, fall in found.items()}
        whole = [rate for rate, fall in found.items() if not fall.message]
        label = f"{name}, c = {damping:g} N s/m"
        words = f"{label}: " + (f"stable from {whole[0]} Hz" if whole else "always explodes")
        pairs, look = zip(*lasts.items(), strict=True), {"ms": 4, "mfc": "white", "label": words}
        axes.semilogx(*pairs, "o-" if damping else "s--", color=COLORS[name], **look)
        rows += [(name, damping, *pair) for pair in lasts.items()]
        if found[rates[name][1]].message:
            note = note or f"{label}, {rates[name][1]} Hz: {found[rates[name][1]].message}"
    axes.set(xlabel="frame rate, Hz", ylabel="time until the cloth explodes, s", ylim=(0.0, 2.8))
    axes.axhline(CLOTH_SECONDS, color=GRAY, lw=1, ls=":")
    axes.set_xticks(book, [f"{rate:g}" for rate in book])
    axes.minorticks_off()
    legends(axes, ncols=2, loc="upper center")
    axes.set_title(f"Frame rates at which a cloth of 180 springs lasts for {CLOTH_SECONDS} s")
    figure.supxlabel("\n".join(textwrap.wrap(note, 110)), fontsize=8)
    return Picture(figure, ("step", "damping, N s/m", "frame rate, Hz", "lasts, s"), rows)


def _fall(name: str, damping: float, rate: int) -> Track:
    """Record how high a corner of a falling cloth is, until a knot exceeds 1000 m/s."""
    knots, registry = make_cloth(damping)
    step = stability.watching(INTEGRATORS[name], 1000.0)
    return track(
        lambda duration: step(knots, registry.update_forces, duration),
        lambda: numbers(knots[-1].position)[1],
        CLOTH_SECONDS * rate,
        1.0 / rate,
    )


def penalty_bounces() -> Picture:
    """Plot the bounces on ground with a penalty force, which may be so stiff that they grow."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    rows: list[Sequence[object]] = []
    falls = [0.5 + i / 40.0 for i in range(21)]

    def highest_rise(stiffness: float) -> tuple[float, float]:
        return max((max(stability.bounces(stiffness, fall, 90)) / fall, fall) for fall in falls)

    _, fall = highest_rise(10_800.0)
    for stiffness, color in ((200.0, BLUE), (10_800.0, RED)):
        heights = stability.bounces(stiffness, fall, 180)
        times = [i * FRAME for i in range(len(heights))]
        kappa = stiffness * FRAME**2
        label = f"{stiffness:,.0f} N/m, k h$^2$ / m = {kappa:.3g}: up to {max(heights):.2f} m"
        left.plot(times, heights, ".-", ms=3, lw=1, color=color, label=label)
        rows += [("height", kappa, *pair) for pair in zip(times, heights, strict=True)]
    left.axhline(0.0, color=BLACK, lw=0.8)
    left.set(xlabel="time, s", ylabel="height, m (below 0: in the ground)")
    left.set_title(f"1 kg falls {fall:g} m onto a ground without damping, 60 Hz", fontsize=10)
    left.margins(y=0.2)
    left.legend(fontsize=8, loc="upper left")
    kappas = [0.03 * 10.0 ** (i / 24.0) for i in range(51)]
    highest = [highest_rise(kappa / FRAME**2)[0] for kappa in kappas]
    rows += [("rise / fall", kappa, "", high) for kappa, high in zip(kappas, highest, strict=True)]
    right.loglog(kappas, highest, color=RED)
    right.axhline(1.0, color=BLACK, lw=0.8)
    right.set(xlabel="k h$^2$ / m", ylabel="largest rise / fall, in 21 falls from 0.5 to 1 m")
    thrown = [kappa for kappa, high in zip(kappas, highest, strict=True) if high > 1.05]
    if thrown:
        words = "on, some bodies rise over 5 % higher\nthan they fell from, and one rises"
        title = f"From {thrown[0]:.2g} {words} {max(highest):.1f} times as high"
        right.set_title(title, fontsize=10)
    for axes in (left, right):
        axes.grid(alpha=0.3)
    return Picture(figure, ("part", "k h^2 / m", "time, s", "height, m, or ratio"), rows)
