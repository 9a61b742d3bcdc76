"""Draw how fast oscillations grow around the stability limits of integrators and of pymunk."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from matplotlib import pyplot

from plots.drawing import BLACK, growth_bar, growth_map
from scenes.integrators import INTEGRATORS, SOLVERS
from studies.limits.search import first, growth_at, theory_at
from studies.models.pymunk_solvers import ON_SPRING

METHODS = (*INTEGRATORS, *SOLVERS, *ON_SPRING)  # in the order of the panels
KAPPAS = [0.01 * 10.0 ** (i / 16.0) for i in range(56)]
DOTS = (0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0, 1.5, 2.0)  # dampings at which limits are measured


def draw_maps(png: Path) -> None:
    """Draw the growth per time step against stiffness and damping, with the limits, per method."""
    figure, panels = pyplot.subplots(3, 3, figsize=(14, 12), layout="constrained")
    off = []
    for axes, name in zip(panels.flat, METHODS, strict=True):
        is_ours = name in INTEGRATORS
        full, undamped, words = (1.0, 1.0, "d$^h$") if is_ours else (2.0, 0.0, "c h / m")
        dampings = [full * i / 40.0 for i in range(4 if is_ours else 0, 41)]
        grown = [[growth_at(name, d, kappa) for kappa in KAPPAS] for d in dampings]
        colored = growth_map(axes, KAPPAS, dampings, grown, in_spring=not is_ours)
        if name in SOLVERS:
            most = max(map(max, grown))
            axes.set_title(f"{name}\nalways stable: at most x {most:.4f}", fontsize=10)
            continue
        fine = [dampings[0] + (full - dampings[0]) * i / 999.0 for i in range(1000)]
        curve = [(true, d) for d in fine if (true := theory_at(name, d))]
        axes.plot(*zip(*curve, strict=True), color=BLACK, label="theory")
        found = {d: first(partial(growth_at, name, d)) for d in dampings if d in DOTS}
        off += [found[d] / true - 1.0 for d in found if (true := theory_at(name, d))]
        axes.plot([*found.values()], [*found], "o", color="white", mec=BLACK, label="bisection")
        axes.legend(fontsize=8, loc="lower left" if is_ours else "upper left")
        limits = f"limit {found[undamped]:.3g} undamped, {found[0.5]:.3g} at {words} = 0.5"
        axes.set_title(f"{name}\n{limits}", fontsize=10)
    growth_bar(figure, panels, colored)
    worst = 100.0 * max(map(abs, off))
    figure.suptitle(
        f"Limits of k h$^2$ / m: bisection differs from theory by at most {worst:.1g} %"
    )
    figure.savefig(png, dpi=110)
    pyplot.close(figure)
