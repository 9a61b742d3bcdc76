"""Compare two ways to compute a firework's sparks: in time steps and with a closed form.

Both ways return the coordinates of the sparks as lists, ready for drawing.
"""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.closed_form import burst_positions, state_after
from ch04_particle_engine.fireworks import GRAVITY, FireworkRule, FireworksShow
from scenes.timing import Measurement, Target, timer, versus
from studies.benchmarks.particles import steps

FRAME = 1.0 / 60.0
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
    closed = timer(lambda: positions(speeds, SECONDS, "xyz"))
    return [
        Measurement(
            f"one frame of {SPARKS:,} sparks in x and y: stepping and reading / closed form",
            versus(
                timer(lambda: step(show, 1, "xy")), timer(lambda: positions(speeds, SECONDS, "xy"))
            ),
            ROUNDS,
            Target("at least", 4),
        ),
        Measurement(
            f"one frame of {SPARKS:,} sparks in x, y and z: stepping and reading / closed form",
            versus(timer(lambda: step(show, 1, "xyz")), closed),
            ROUNDS,
        ),
        Measurement(
            f"{SPARKS:,} sparks after {SECONDS:g} s, in x, y and z: {frames} steps / closed form",
            versus(timer(lambda: step(show, frames, "xyz")), closed),
            ROUNDS,
            Target("at least", 250),
        ),
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
    """Create a fireworks show whose sparks have just been lit.

    All ``SPARKS`` sparks begin at ``START``, so high up that none of them lands during a
    measurement.
    """
    show = FireworksShow([RULE], SPARKS, seed=1)
    show.light([(1, SPARKS, Particle(Vector3(*START)))])
    return show


def speeds_of(show: FireworksShow) -> list[list[float]]:
    """List the velocities of all sparks as three lists, one each for x, y and z.

    The function ``positions`` expects velocities in this form.
    """
    velocities = [firework.particle.velocity for firework in show.fireworks]
    return [[v.x for v in velocities], [v.y for v in velocities], [v.z for v in velocities]]


def step(show: FireworksShow, frames: int, axes: str) -> list[list[float]]:
    """Advance a fireworks show by ``frames`` frames, and return the coordinates of its sparks.

    ``axes`` is "xy" or "xyz". The result has one list of coordinates for each of these axes.
    """
    for _ in range(frames):
        show.update(FRAME)
    places = [firework.particle.position for firework in show.fireworks]
    read = [[p.x for p in places], [p.y for p in places]]
    return [*read, [p.z for p in places]] if axes == "xyz" else read


def positions(speeds: list[list[float]], time: float, axes: str) -> list[list[float]]:
    """Compute the coordinates of a firework's sparks at ``time`` with a closed form.

    ``speeds`` has one list of initial velocities per axis. ``axes`` is "xy" or "xyz", and the
    result has one list of coordinates for each of these axes.
    """
    return [
        burst_positions(START[axis], speeds[axis], GRAVITY[axis], DAMPING, time)
        for axis in range(len(axes))
    ]
