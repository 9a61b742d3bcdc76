"""A base class for scenes that simulate a ParticleWorld, with its particles and contacts.

The reader can change the step rate and the iteration limit while the scene runs.
"""

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
    """A scene that simulates a particle world.

    The ``build`` method of a subclass must call ``run``.
    """

    rate = Choice(60, "steps per second", [30, 60, 120, 240], "Hz", live=True)
    iterations = Choice(100, "most iterations per phase", [1, 3, 10, 30, 100, 300], live=True)

    def run(self, step: Callable[[float], object], world: ParticleWorld) -> None:
        """Set the world to simulate, and the function that advances it by one step.

        This method also starts to record the contacts of ``world``, so that the scene can draw
        them.
        """
        self.make_step = step
        self.contacts = ContactView(world.resolver)
        world.resolver = self.contacts

    def step(self, duration: float) -> None:
        """Advance the world by one time step of ``duration`` s."""
        self.contacts.forget()
        self.contacts.iterations = self.iterations
        self.make_step(duration)

    def used(self) -> dict[str, float]:
        """Return the resolver's number of iterations in the last step, as a value to plot."""
        return {"iterations used": float(self.contacts.iterations_used)}


def draw_cables(pen: Pen, generators: Iterable[object]) -> None:
    """Draw the taut cables of a particle world in black, and the slack ones in gray."""
    anchors: list[tuple[float, float]] = []
    taut: list[tuple[tuple[float, float], tuple[float, float]]] = []
    slack: list[tuple[tuple[float, float], tuple[float, float]]] = []
    for link in generators:
        if isinstance(link, Cable | AnchoredCable):
            a, b = ends_of(link)
            tight = (b - a).magnitude() >= link.max_length
            (taut if tight else slack).append((flat(a), flat(b)))
        if isinstance(link, AnchoredCable):
            anchors.append(flat(link.anchor))
    pen.segments(slack, "gray")
    pen.segments(taut, "black", 1.5)
    pen.dots(anchors, "black", 5.0)
