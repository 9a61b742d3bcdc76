"""The list of all scenes in which our engine is compared with pymunk."""

from __future__ import annotations

from functools import cache

from studies.accuracy.measured.bounces import IMPACTS
from studies.accuracy.measured.bridge import BRIDGES
from studies.accuracy.measured.chains import CHAINS
from studies.accuracy.measured.flights import FLIGHTS
from studies.accuracy.measured.many import MANY_BODIES
from studies.accuracy.measured.nets import NETS
from studies.accuracy.measured.springs import SPRINGS
from studies.accuracy.scene import Scene

GROUPS = {
    "Flights and floating": FLIGHTS,
    "Springs": SPRINGS,
    "Impacts": IMPACTS,
    "Pendulums and ropes": CHAINS,
    "Rope bridges and nets": [*BRIDGES, *NETS],
    "Many bodies": MANY_BODIES,
}


@cache
def group_of() -> dict[str, str]:
    """Return the title of the group of each scene, by the scene's name."""
    return {make().name: title for title, group in GROUPS.items() for make in group}


def scenes_with(part: str) -> list[Scene]:
    """Create the scenes with ``part`` in their names. A ValueError lists all names."""
    every = [make() for group in GROUPS.values() for make in group]
    if found := [scene for scene in every if part in scene.name]:
        return found
    names = "; ".join(scene.name for scene in every)
    raise ValueError(f"scene must be part of one of these names, got {part!r}: {names}")
