"""A base class for scenes in which the reader chooses the integrator and the step rate."""

from __future__ import annotations

from collections.abc import Sequence

from ch05_forces.forces import ForceRegistry
from ch05_forces.particle import Particle
from lab.scene import Scene
from scenes.integrators import INTEGRATORS
from scenes.parameters import Choice

RATES = (15.0, 30.0, 60.0, 120.0, 240.0, 480.0)


class Stepped(Scene):
    """A scene of particles and a registry of forces, which a subclass must create in ``build``."""

    integrator = Choice("semi-implicit Euler", "integrator", [*INTEGRATORS], live=True)
    rate = Choice(60.0, "steps per second", RATES, "Hz", live=True)

    particles: Sequence[Particle]
    registry: ForceRegistry

    def step(self, duration: float) -> None:
        INTEGRATORS[self.integrator](self.particles, self.registry.update_forces, duration)
