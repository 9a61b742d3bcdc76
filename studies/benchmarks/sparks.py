"""Compare two ways to list the coordinates of sparks: in time steps and with a closed form."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.closed_form import burst_positions, state_after
from ch04_particle_engine.fireworks import GRAVITY, FireworkRule, FireworksShow
from scenes.clock import FRAME
from scenes.timing import Measurement, Target, timer, versus
from studies.benchmarks.particles import steps

SPARKS = 1000
SECONDS = 2.0
START = (0.0, 1e6, 0.0)  # so high that no spark lands while it is timed
DAMPING = 0.5
ROUNDS = 31

# The sparks burn for longer than they are timed, so that only the steps are measured.
RULE = FireworkRule(1, 1e6, 1e6, (-5.0, -5.0, -5.0), (5.0, 5.0, 5.0), DAMPING)


def lines() -> list[Measurement]:
    """Set up the benchmarks that compare time steps with a closed form for computing sparks."""
    show = burst()
    speeds, one = speeds_of(show), show.fireworks[0].particle
    frames = round(SECONDS / FRAME)

    def against_formula(what: str, frames: int, axes: str, target: int | None) -> Measurement:
        stepping = timer(lambda: step(show, frames, axes))
        closed = timer(lambda: positions(speeds, SECONDS, axes))
        bound = Target("at least", target) if target else None
        return Measurement(f"{what} / closed form", versus(stepping, closed), ROUNDS, bound)

    one_frame, read = f"one frame of {SPARKS:,} sparks in", "stepping and reading"
    after = f"{SPARKS:,} sparks after {SECONDS:g} s, in x, y and z: {frames} steps"
    return [
        against_formula(f"{one_frame} x and y: {read}", 1, "xy", 4),
        against_formula(f"{one_frame} x, y and z: {read}", 1, "xyz", None),
        against_formula(after, frames, "xyz", 250),
        Measurement(
            f"one particle after {SECONDS:g} s: {frames} steps / state_after",
            versus(
                timer(lambda: steps(one, [FRAME] * frames), 20),
                timer(lambda: state_after(one, SECONDS), 20),
            ),
            ROUNDS,
        ),
    ]


def burst() -> FireworksShow:
    """Create a fireworks show whose sparks have just been lit."""
    show = FireworksShow([RULE], SPARKS, seed=1)
    show.light([(1, SPARKS, Particle(Vector3(*START)))])
    return show


def speeds_of(show: FireworksShow) -> list[list[float]]:
    """List the velocities of all sparks as three lists, one each for x, y and z."""
    velocities = [firework.particle.velocity for firework in show.fireworks]
    return [[v.x for v in velocities], [v.y for v in velocities], [v.z for v in velocities]]


def step(show: FireworksShow, frames: int, axes: str) -> list[list[float]]:
    """Advance a fireworks show, and return a list of coordinates for each axis, "xy" or "xyz"."""
    for _ in range(frames):
        show.update(FRAME)
    places = [firework.particle.position for firework in show.fireworks]
    read = [[p.x for p in places], [p.y for p in places]]
    return [*read, [p.z for p in places]] if axes == "xyz" else read


def positions(speeds: list[list[float]], time: float, axes: str) -> list[list[float]]:
    """Return the same lists at ``time`` with a closed form, from the velocities at the start."""
    return [
        burst_positions(START[axis], speeds[axis], GRAVITY[axis], DAMPING, time)
        for axis in range(len(axes))
    ]
