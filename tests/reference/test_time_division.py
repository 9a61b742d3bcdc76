"""Time division against a separate event simulation, and conservation laws."""

from __future__ import annotations

import math
from typing import Any

import numpy
import pytest

from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.detectors import ParticlePairs
from ch07_constraints.time_division import time_division_step


class Watch:
    """A detector that records each impact it finds: its time in the frame and its contact."""

    def __init__(self, detector: Any, frame: float) -> None:
        self.detector, self.frame = detector, frame
        self.found: list[tuple[float, Any]] = []

    def contacts(self) -> Any:
        return self.detector.contacts()

    def next_impact(self, duration: float) -> Any:
        impact = self.detector.next_impact(duration)
        if impact:
            self.found.append((self.frame - duration + impact[0], impact[1]))
        return impact


def events(
    places: numpy.ndarray,
    speeds: numpy.ndarray,
    masses: numpy.ndarray,
    radius: float,
    c: float,
    until: float,
) -> list[tuple[float, int, int]]:
    """Move discs from event to event by the roots of quadratics, and return the events."""
    now, found = 0.0, []
    while True:
        first = (until, -1, -1)
        for i in range(len(masses)):
            for j in range(i + 1, len(masses)):
                d, v = places[i] - places[j], speeds[i] - speeds[j]
                if d @ v >= 0.0:
                    continue
                roots = numpy.roots([v @ v, 2.0 * (d @ v), d @ d - 4.0 * radius**2])
                if not numpy.iscomplexobj(roots) and now + min(roots) < first[0]:
                    first = (now + min(roots), i, j)
        time, i, j = first
        places += speeds * (time - now)
        now = time
        if i < 0:
            return found
        found.append(first)
        n = (places[i] - places[j]) / numpy.linalg.norm(places[i] - places[j])
        reduced = masses[i] * masses[j] / (masses[i] + masses[j])
        impulse = -(1.0 + c) * reduced * ((speeds[i] - speeds[j]) @ n)
        speeds[i] += impulse / masses[i] * n
        speeds[j] -= impulse / masses[j] * n


@pytest.mark.parametrize("c", [1.0, 0.6])
@pytest.mark.parametrize("seed", range(4))
def test_billiard_balls_meet_in_the_order_of_another_simulation(seed: int, c: float) -> None:
    """12 balls move toward a common middle, in one frame of 3 s or in frames of 1/60 s."""
    for frames in (1, 180):
        draw = numpy.random.default_rng(seed)
        cells = draw.permutation(36)[:12]
        places = numpy.stack([cells % 6 - 2.5, cells // 6 - 2.5], 1).astype(float)
        speeds = -places * draw.uniform(0.3, 1.5, (12, 1)) + draw.normal(0.0, 0.3, (12, 2))
        masses = draw.uniform(0.5, 3.0, 12)
        balls = [
            Particle(Vector3(x, y), Vector3(u, v), mass=m)
            for (x, y), (u, v), m in zip(places, speeds, masses, strict=True)
        ]
        momentum = masses @ speeds
        energy = 0.5 * masses @ (speeds**2).sum(1)
        wanted = events(places, speeds, masses, 0.3, c, 3.0)
        number, got, frame = {id(ball): i for i, ball in enumerate(balls)}, [], 3.0 / frames
        for i in range(frames):
            watch = Watch(ParticlePairs(balls, 0.3, c), frame)
            time_division_step(balls, watch, frame)
            got += [
                (i * frame + t, number[id(x.particle)], number[id(x.other)]) for t, x in watch.found
            ]
        assert len(wanted) >= 8
        assert [event[1:] for event in got] == [event[1:] for event in wanted]
        times = [time for time, _, _ in wanted]
        assert [time for time, _, _ in got] == pytest.approx(times, abs=1e-8)
        # Each impact multiplies an error by about the path over the radius. About ten of them turn
        # 1e-16 m into at most 1e-9 m.
        for ball, place, speed in zip(balls, places, speeds, strict=True):
            assert (ball.position.x, ball.position.y) == pytest.approx(tuple(place), abs=1e-8)
            assert (ball.velocity.x, ball.velocity.y) == pytest.approx(tuple(speed), abs=1e-8)
        # Conserved quantities have only rounding errors, even if errors of positions grow.
        now = [math.fsum(b.momentum().x for b in balls), math.fsum(b.momentum().y for b in balls)]
        assert now == pytest.approx(list(momentum), abs=1e-12)
        kept = math.fsum(ball.kinetic_energy() for ball in balls)
        assert kept == pytest.approx(energy, rel=1e-13) if c == 1.0 else kept < 0.99 * energy
