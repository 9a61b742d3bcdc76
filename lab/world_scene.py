"""A base class for scenes that simulate a ParticleWorld, with its particles and contacts."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from ch07_constraints.links import AnchoredCable, Cable
from ch08_mass_aggregate.world import ParticleWorld
from lab.drawing.camera import flat
from lab.drawing.contact_view import ContactView
from lab.drawing.pen import Pen
from lab.scene import Scene
from scenes.links import ends_of
from scenes.parameters import Choice


class WorldScene(Scene):
    """A scene that simulates a particle world. Its ``build`` method must call ``run``."""

    rate = Choice(60, "steps per second", [30, 60, 120, 240], "Hz", live=True)
    iterations = Choice(100, "most iterations per phase", [1, 3, 10, 30, 100, 300], live=True)

    def run(self, step: Callable[[float], object], world: ParticleWorld) -> None:
        """Set the function that makes a step, and record the contacts of ``world`` for drawing."""
        self.make_step = step
        self.contacts = ContactView(world.resolver)
        world.resolver = self.contacts

    def step(self, duration: float) -> None:
        self.contacts.forget()
        self.contacts.iterations = self.iterations
        self.make_step(duration)

    def used(self) -> dict[str, float]:
        """Return the resolver's number of iterations in the last step, as a value to plot."""
        return {"iterations used": float(self.contacts.iterations_used)}


def draw_cables(pen: Pen, generators: Iterable[object]) -> None:
    """Draw the taut cables of a particle world in black, and the slack ones in gray."""
    cables = [link for link in generators if isinstance(link, Cable | AnchoredCable)]
    ends = [(*ends_of(cable), cable.max_length) for cable in cables]
    for is_taut, color, width in ((False, "gray", 1.0), (True, "black", 1.5)):
        seen = [(a, b) for a, b, most in ends if ((b - a).magnitude() >= most) == is_taut]
        pen.segments([(flat(a), flat(b)) for a, b in seen], color, width)
    anchors = [cable.anchor for cable in cables if isinstance(cable, AnchoredCable)]
    pen.dots(map(flat, anchors), "black", 5.0)
