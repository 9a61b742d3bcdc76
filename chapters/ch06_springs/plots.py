"""Pictures of chapter 6: forces of springs, how steps swing them, and where each step explodes.

Titles give what is measured on the picture: a wrong engine cannot hide. What is not written yet is
left out where there is something else to see.
"""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence

from matplotlib import pyplot
from matplotlib.axes import Axes

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator
from ch05_forces.particle import Particle
from ch06_springs.integrators import semi_implicit_euler
from ch06_springs.own_step import my_step
from ch06_springs.springs import (
    AnchoredSpring,
    Bungee,
    Buoyancy,
    ElasticLimitSpring,
    FakeStiffSpring,
    LighterThanAir,
    Spring,
)
from studies.drawing import (
    BLACK,
    BLUE,
    COLORS,
    GREEN,
    GREY,
    ORANGE,
    RED,
    Picture,
    growth_bar,
    growth_map,
    is_written,
    numbers,
    slope,
)
from studies.stability import (
    INTEGRATORS,
    SOLVERS,
    Pull,
    bounces,
    cloth_lasts,
    faked_growth,
    growth,
    growth_of,
    largest_error,
    limits,
    methods,
    period,
    swing,
    theory,
    true_place,
)

FRAME = 1.0 / 60.0
CLOTH_SECONDS = 2


def force_against_length() -> Picture:
    """The forces of springs and ropes against their length, and lifts against the height."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    k, rest = 10.0, 2.0
    other = Particle()
    limited = ElasticLimitSpring(other, k, rest, 3.0, 0.3)
    shown: tuple[tuple[Axes, ForceGenerator, str, str, float, str], ...] = (
        (left, limited, "ElasticLimitSpring, limit 3 m, share 0.3", GREEN, 5.0, "-"),
        (left, Spring(other, k, rest), "Spring", BLUE, 2.0, "-"),
        (left, Bungee(other, k, rest), "Bungee", ORANGE, 2.5, "--"),
        (right, Buoyancy(1.0, 0.001, 0.0), "Buoyancy, max_depth 1 m", BLUE, 2.0, "-"),
        (right, LighterThanAir(8.0, 2.0), "LighterThanAir, scale_height 2 m", ORANGE, 2.0, "-"),
    )
    rows: list[tuple[str, float, float]] = []
    for axes, generator, label, color, width, style in shown:
        axis, first, last = (0, 1, 80) if axes is left else (1, -40, 80)
        if not is_written(lambda g=generator: g.update_force(Particle(Vector3(1.0)), FRAME)):  # type: ignore[misc]
            continue
        places = [i / 20.0 for i in range(first, last + 1)]
        forces = [_force(generator, place, axis) for place in places]
        axes.plot(places, forces, style, color=color, lw=width, label=label)
        rows += [(type(generator).__name__, *pair) for pair in zip(places, forces, strict=True)]
    if not rows:
        _force(Spring(other, k, rest), 1.0, 0)  # says what is not written
    lengths = [0.05, rest, 4.0]
    printed = [-k * abs(length - rest) for length in lengths]
    left.plot(lengths, printed, "--", color=GREY, lw=1, label="printed, with abs (E-3)")
    for axes in (left, right):
        axes.axhline(0.0, color=BLACK, lw=0.8)
        axes.grid(alpha=0.3)
        if axes.lines[1:]:
            axes.legend(fontsize=8, loc="upper right")
        else:
            axes.text(0.5, 0.5, "not written yet", transform=axes.transAxes, ha="center")
    left.set(xlabel=f"length, m; {rest:g} m at rest, {k:g} N/m", ylabel="force, N; positive pushes")
    right.set(xlabel="height above the water, or the ground, m", ylabel="force upwards, N")
    at = {row[:2]: row[2] for row in rows}
    if ("Spring", 1.0) in at:
        left.set_title(
            f"At 1 m a spring gives {at['Spring', 1.0]:+.4g} N, the printed form {-k:+.4g} N",
            fontsize=10,
        )
    words = []
    if ("Buoyancy", 0.0) in at:
        words.append(f"Half under water: {at['Buoyancy', 0.0]:.4g} N of {at['Buoyancy', -2.0]:.4g}")
    if ("LighterThanAir", 2.0) in at:
        low, high = at["LighterThanAir", 0.0], at["LighterThanAir", 2.0]
        words.append(f"The balloon's lift 2 m up: {high:.4g} N of {low:.4g}")
    right.set_title("\n".join(words), fontsize=10)
    return Picture(figure, ("generator", "length or height, m", "force, N"), rows)


def three_regimes() -> Picture:
    """The closed form of a damped spring in its three regimes, and steps beside it."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    k, frames = 100.0, 90
    times = [i * FRAME for i in range(frames + 1)]
    rows: list[Sequence[object]] = []
    words = []
    for c, name, color in (
        (2.0, "under-damped", BLUE),
        (20.0, "critical", GREEN),
        (40.0, "over-damped", RED),
    ):
        exact = [true_place(k, c, time) for time in times]
        label = f"c = {c:g} N s/m: {name}"
        left.plot(times, exact, color=color, label=label)
        spring = AnchoredSpring(Vector3(), k, 0.0, c)
        stepped = [math.nan] * len(times)
        if is_written(lambda g=spring: swing(semi_implicit_euler, g, FRAME, 1, 1e3)):  # type: ignore[misc]
            run = swing(semi_implicit_euler, spring, FRAME, frames, 1e3)
            stepped[: len(run.places)] = run.places
            left.plot(times[::2], stepped[::2], "o", color=color, ms=3)
            off = [a - b for a, b in zip(stepped, exact, strict=True)]
            right.plot(times, off, color=color, label=label)
            words.append(f"{max(map(abs, off)):.3f}")
        rows += [(c, *row) for row in zip(times, exact, stepped, strict=True)]
    left.set(xlabel="time, s", ylabel="x, m (lines: the formula; dots: steps)")
    left.set_title("Where a spring of 100 N/m takes 1 kg, from x = 1 m at rest", fontsize=10)
    right.set(xlabel="time, s", ylabel="x of the steps less that of the formula, m")
    if words:
        right.set_title(
            f"Semi-implicit Euler at 60 Hz is off by up to {', '.join(words)} m", fontsize=10
        )
        left.legend(fontsize=8)
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.axhline(0.0, color=BLACK, lw=0.8)
    return Picture(figure, ("c, N s/m", "time, s", "formula, m", "semi-implicit Euler, m"), rows)


def stability_map() -> Picture:
    """What each step multiplies swings by, over stiffness and damping, and the limits of theory."""
    figure, panels = pyplot.subplots(2, 4, figsize=(16, 8), layout="constrained")
    *maps, key = panels.flat
    kappas = [0.01 * 10.0 ** (i / 12.0) for i in range(49)]
    rows: list[Sequence[object]] = []
    deviations, colored = [], None
    for axes, name in zip(maps, (*INTEGRATORS, *SOLVERS), strict=True):
        implicit = name in SOLVERS
        words = "spring, c h / m" if implicit else "particle, d$^h$"
        axes.set(xscale="log", title=name, xlim=(kappas[0], kappas[-1]))
        axes.set(xlabel="k h$^2$ / m", ylabel=f"damping of the {words}")
        if not is_written(lambda n=name: growth_of(n, 1.0, 1.0, FRAME)):  # type: ignore[misc]
            axes.text(0.5, 0.5, "not written yet", transform=axes.transAxes, ha="center")
            continue
        dampings = [i / 10.0 if implicit else 1.0 - i / 40.0 for i in range(21 if implicit else 39)]
        grown = [[growth_of(name, kappa, d, FRAME) for kappa in kappas] for d in dampings]
        rows += [
            (name, damping, kappa, value, "")
            for damping, line in zip(dampings, grown, strict=True)
            for kappa, value in zip(kappas, line, strict=True)
        ]
        colored = growth_map(axes, kappas, dampings, grown)
        if implicit:
            largest = max(value for line in grown for value in line)
            axes.set_title(f"{name}: at most x {largest:.4f}", fontsize=11)
            continue
        line = [0.05 + 0.949 * i / 99.0 for i in range(100)]
        axes.plot([theory(name, kept) for kept in line], line, color=BLACK)
        for kept, limit, true in limits(name, FRAME):
            deviations.append(abs(limit / true - 1.0))
            rows.append((f"{name}, limit", kept, limit, 1.0, true))
            axes.plot(limit, kept, "o", color="white", mec=BLACK)
    if not rows:
        growth_of("explicit Euler", 1.0, 1.0, FRAME)  # says what is not written
    if colored is not None:
        growth_bar(figure, panels, colored)
    key.set_axis_off()
    if deviations:
        key.plot([], [], color=BLACK, label="limit by theory")
        key.plot([], [], "o", color="white", mec=BLACK, label="limit measured")
        key.legend(loc="center")
        figure.suptitle(
            f"The limits measured are off those of theory by at most {max(deviations):.1g} of them"
        )
    columns = ("method", "d^h or c h / m", "k h^2 / m", "growth of a step", "limit by theory")
    return Picture(figure, columns, rows)


def fake_spring() -> Picture:
    """The faked stiff spring beside the true one, by two steps, and where it grows."""
    figure, (bare, damped, right) = pyplot.subplots(1, 3, figsize=(15, 4.8), layout="constrained")
    k, frames = 400.0, 90
    times = [i * FRAME for i in range(frames + 1)]
    rows: list[Sequence[object]] = []
    for axes, c in ((bare, 0.0), (damped, 4.0)):
        exact = [true_place(k, c, time) for time in times]
        axes.plot(times, exact, color=BLACK, lw=1, label="true spring")
        own, back = math.exp(-c / 2.0 * FRAME), period(exact) * FRAME
        words = [f"c = {c:g} N s/m. True: x {own:.4f} a frame, period {back:.3f} s"]
        fake = FakeStiffSpring(Vector3(), k, c)
        for name in ("semi-implicit Euler", "explicit Euler"):
            step = INTEGRATORS[name]
            if not is_written(lambda s=step, g=fake: swing(s, g, FRAME, 1, 1e3)):  # type: ignore[misc]
                continue
            seen = swing(step, fake, FRAME, frames, 1e3).places
            label = f"faked, {name}"
            axes.plot(times[: len(seen)], seen, ".-", ms=3, lw=0.8, color=COLORS[name], label=label)
            rows += [("swing", name, c, *row) for row in zip(times, exact, seen, strict=False)]
            words.append(
                f"{name}: x {growth(step, fake, FRAME):.4f} a frame, "
                f"period {period(seen) * FRAME:.3f} s"
            )
        axes.set_title("\n".join(words), fontsize=9)
        axes.set(xlabel="time, s", ylabel="x, m (400 N/m, 1 kg, 60 Hz)", ylim=(-4.0, 4.0))
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8, loc="upper left")
    angles = [0.1 + 0.02 * i for i in range(596)]
    words = []
    for share, color, label in ((0.0, RED, "no damping"), (0.05, BLUE, "1/20 of critical damping")):
        grown = [faked_growth(angle, share, FRAME) for angle in angles]
        right.plot(angles, grown, color=color, lw=1.2, label=label)
        seen = zip(angles, grown, strict=True)
        rows += [("growth", "semi-implicit Euler", share, *pair, "") for pair in seen]
        most, angle = max(zip(grown, angles, strict=True))
        words.append(f"{label}: at most x {most:.3f}, where $\\chi$ h = {angle:.2f}")
    right.axhline(1.0, color=BLACK, lw=0.8)
    for i in (1, 3):
        right.axvline(i * math.pi, color=GREY, lw=1, ls=":")
    right.set(
        xlabel=r"$\chi$ h (dotted: $\pi$ and 3 $\pi$)",
        ylabel="swings by semi-implicit Euler, x a frame",
    )
    right.set_title("\n".join(words), fontsize=9)
    right.grid(alpha=0.3)
    right.legend(fontsize=8)
    columns = (
        "part",
        "step",
        "c or share of critical",
        "time, s, or chi h",
        "true m, or growth",
        "faked m",
    )
    return Picture(figure, columns, rows)


def energy_over_time() -> Picture:
    """The energy of an undamped spring over ten seconds, by every method."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(12, 5.2), layout="constrained")
    k, frames = 100.0, 600
    rows: list[Sequence[object]] = []
    words, notes = [], []
    for name, method in methods(k).items():
        if not is_written(lambda m=method: swing(m, Pull(k), FRAME, 1, 1e4)):  # type: ignore[misc]
            continue
        run = swing(method, Pull(k), FRAME, frames, 1e4)
        times = [i * FRAME for i in range(len(run.places))]
        energies = [
            (k * x * x + v * v) / k for x, v in zip(run.places, run.velocities, strict=True)
        ]
        left.semilogy(times, energies, color=COLORS[name], label=name)
        rows += [(name, *row) for row in zip(times, energies, strict=True)]
        if run.message:
            notes.append(f"{name} stopped by {run.message}")
        off = [max(abs(energy - 1.0), 1e-17) for energy in energies[1:]]
        if off and max(off) < 0.5:
            label = f"{name}: at most {max(off):.1g}"
            # Leapfrog is off by nearly as much, the other way: a wide line shows behind its own.
            wide, order = (4.0, 1.9) if name == "velocity Verlet" else (1.0, 2.0)
            right.semilogy(times[1:], off, color=COLORS[name], lw=wide, label=label, zorder=order)
        elif energies[-1] > 0.0:
            rate = energies[-1] ** (1.0 / (len(energies) - 1))
            words.append(
                f"{name}: energy x {rate:.4f} a step, at that rate x {rate**600:.3g} in 10 s"
            )
    if not rows:
        swing(INTEGRATORS["explicit Euler"], Pull(k), FRAME, 1, 1e4)  # says what is not written
    left.set_title("\n".join(words), fontsize=9)
    left.set(xlabel="time, s", ylabel="energy, that at the start = 1 (100 N/m, 1 kg, 60 Hz)")
    right.set(xlabel="time, s", ylabel="how far the energy is off, as a share of it")
    right.set_title("The steps that nearly keep their energy", fontsize=9)
    for axes in (left, right):
        axes.grid(alpha=0.3)
        if axes.lines:
            axes.legend(fontsize=8, loc="best")
    if notes:
        figure.supxlabel("\n".join(notes), fontsize=8)
    return Picture(figure, ("method", "time, s", "energy / energy at the start"), rows)


def error_against_work() -> Picture:
    """The error of every method over a second, against its evaluations of the force."""
    figure, panels = pyplot.subplots(1, 4, figsize=(16, 5.6), layout="constrained", sharey=True)
    rows: list[Sequence[object]] = []
    words = []
    for axes, k in zip(panels, (1.0, 1e2, 1e4, 1e6), strict=True):
        chi = math.sqrt(k)
        ways = methods(k) | {"your own step": my_step}
        for height, (name, method) in enumerate(ways.items()):
            if not is_written(lambda m=method, k=k: swing(m, Pull(k), 1e-6, 1, 1e9)):  # type: ignore[misc]
                continue
            color, cost = (
                COLORS.get(name, BLACK),
                {"velocity Verlet": 2, "Runge-Kutta 4": 4}.get(name, 1),
            )
            fine = []
            for steps in (2**power // cost for power in range(3, 14)):
                pull = Pull(k)
                run = swing(method, pull, 1.0 / steps, steps, 10.0 * chi)
                work = pull.count or len(run.places) - 1  # a solver's solution counts as one
                error = math.inf if run.message else largest_error(run.places, chi, steps)
                rows.append((k, name, steps, work, error))
                if (
                    not error < 1e6
                ):  # where no watch is written yet, it may be farther away than that
                    axes.plot(steps * cost, 10.0 * 3.0**height, "x", color=color, ms=4)
                else:
                    fine.append((work, error))
            axes.plot(*zip(*fine, strict=True), "o-", ms=3, lw=1, color=color, label=name)
            fine = [pair for pair in fine if 1e-11 < pair[1] < 0.02]
            if k == 100.0 and len(fine) > 1:
                order = -slope(*zip(*fine[-4:], strict=True))
                words.append(f"{name} {order:.3f}")
        if is_written(lambda k=k: true_place(k, 0.0, 1.0)):  # type: ignore[misc]
            exact = [true_place(k, 0.0, i / 64.0) for i in range(65)]
            error = max(largest_error(exact, chi, 64), 1e-17)
            rows.append((k, "closed form", 1, 1, error))
            axes.plot(1, error, "*", color=BLACK, ms=9, label="closed form (no error: at 1e-17)")
        swings = chi / 2.0 / math.pi
        axes.set(xscale="log", yscale="log", title=f"{k:,.0f} N/m: {swings:.3g} swings")
        axes.set(xlabel="evaluations of the force, or solutions")
        axes.grid(alpha=0.3)
    if all(name == "closed form" for _, name, *_ in rows):
        swing(INTEGRATORS["explicit Euler"], Pull(1.0), FRAME, 1, 1e4)  # says what is not written
    panels[0].set_ylabel("largest error within 1 s, m; crosses: exploded")
    if panels[0].lines:
        figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=9)
    if words:
        title = f"The orders, measured at 100 N/m: {', '.join(words)}"
        figure.suptitle("\n".join(textwrap.wrap(title, 120)), fontsize=11)
    return Picture(figure, ("k, N/m", "method", "steps", "evaluations", "largest error, m"), rows)


def cloth_frame_rates() -> Picture:
    """How long a cloth of springs lasts at each frame rate, by the book's step and by another."""
    figure, axes = pyplot.subplots(figsize=(9, 5.2), layout="constrained")
    rows: list[Sequence[object]] = []
    book = (30, 60, 120, 240, 480, 960)
    first = (30, 45, 60, 70, 75, 80, 82, 85, 90, 120)
    note = ""
    for name, rates in (("explicit Euler", book), ("semi-implicit Euler", first)):
        for damping, style in ((0.2, "o-"), (0.0, "s--")):
            if not is_written(lambda n=name, c=damping: cloth_lasts(n, c, 60, 1)):  # type: ignore[misc]
                continue
            found = [cloth_lasts(name, damping, rate, CLOTH_SECONDS * rate) for rate in rates]
            lasts = [steps / rate for (steps, _), rate in zip(found, rates, strict=True)]
            whole = [rate for rate, (_, message) in zip(rates, found, strict=True) if not message]
            label = f"{name}, c = {damping:g} N s/m"
            words = f"{label}: " + (f"from {whole[0]} Hz" if whole else "at none of these")
            axes.semilogx(rates, lasts, style, color=COLORS[name], ms=4, mfc="white", label=words)
            rows += [(name, damping, *pair) for pair in zip(rates, lasts, strict=True)]
            if stop := found[1][1]:
                note = note or f"{label}, {rates[1]} Hz: {stop}"
    if not rows:
        cloth_lasts("explicit Euler", 0.2, 60, 1)  # says what is not written
    axes.set(xlabel="frame rate, Hz", ylabel="how long the cloth lasts, s", ylim=(0.0, 2.8))
    axes.axhline(CLOTH_SECONDS, color=GREY, lw=1, ls=":")
    axes.set_xticks(book, minor=False)
    axes.set_xticks([], minor=True)
    axes.xaxis.set_major_formatter("{x:g}")
    axes.grid(alpha=0.3)
    if rows:
        axes.legend(fontsize=8, ncols=2, loc="upper center")
        axes.set_title(f"Frame rates at which a cloth of 180 springs lasts for {CLOTH_SECONDS} s")
    figure.supxlabel("\n".join(textwrap.wrap(note, 110)), fontsize=8)
    return Picture(figure, ("step", "damping, N s/m", "frame rate, Hz", "lasts, s"), rows)


def penalty_bounces() -> Picture:
    """Bodies that fall on a ground of springs: the sponge, and bounces higher than the fall."""
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
    rows: list[Sequence[object]] = []
    falls = [0.5 + i / 40.0 for i in range(21)]
    fall = max(falls, key=lambda fall: max(bounces(10_800.0, fall, 90)) / fall)
    for stiffness, color in ((200.0, BLUE), (10_800.0, RED)):
        heights = bounces(stiffness, fall, 180)
        times = [i * FRAME for i in range(len(heights))]
        kappa = stiffness * FRAME**2
        label = f"{stiffness:,.0f} N/m, k h$^2$ / m = {kappa:.3g}: up to {max(heights):.2f} m"
        left.plot(times, heights, ".-", ms=3, lw=1, color=color, label=label)
        rows += [("height", kappa, *pair) for pair in zip(times, heights, strict=True)]
    left.axhline(0.0, color=BLACK, lw=0.8)
    left.set(xlabel="time, s", ylabel="height, m; below 0 it is in the ground")
    left.set_title(f"1 kg falls {fall:g} m on a ground without damping, 60 Hz", fontsize=10)
    left.margins(y=0.2)
    left.legend(fontsize=8, loc="upper left")
    kappas = [0.03 * 10.0 ** (i / 24.0) for i in range(51)]
    highest = []
    for kappa in kappas:
        rises = [max(bounces(kappa / FRAME**2, fall, 90)) / fall for fall in falls]
        highest.append(max(rises))
        rows.append(("rise / fall", kappa, "", highest[-1]))
    right.loglog(kappas, highest, color=RED)
    right.axhline(1.0, color=BLACK, lw=0.8)
    right.set(xlabel="k h$^2$ / m", ylabel="highest rise / fall, of 21 falls of 0.5 to 1 m")
    thrown = [kappa for kappa, high in zip(kappas, highest, strict=True) if high > 1.05]
    if thrown:
        right.set_title(
            f"From {thrown[0]:.2g} on some rise 5 % higher than they fell from,\n"
            f"one x {max(highest):.1f} as high",
            fontsize=10,
        )
    for axes in (left, right):
        axes.grid(alpha=0.3)
    return Picture(figure, ("part", "k h^2 / m", "time, s", "height, m, or ratio"), rows)


PLOTS = (
    force_against_length,
    three_regimes,
    stability_map,
    fake_spring,
    energy_over_time,
    error_against_work,
    cloth_frame_rates,
    penalty_bounces,
)


def _force(generator: ForceGenerator, place: float, axis: int) -> float:
    """Return the force on a particle at a place on the X or the Y axis, along it."""
    particle = Particle(Vector3(*(place if i == axis else 0.0 for i in range(3))))
    generator.update_force(particle, FRAME)
    return numbers(particle.force_accumulator)[axis]
