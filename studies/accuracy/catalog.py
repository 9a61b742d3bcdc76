"""Every scene, by the part of its name that a command may give."""

from __future__ import annotations

from studies.accuracy.bridge import BRIDGES
from studies.accuracy.flights import FLIGHTS
from studies.accuracy.impacts import IMPACTS
from studies.accuracy.links import LINKED
from studies.accuracy.nets import NETS
from studies.accuracy.scene import Scene
from studies.accuracy.springs import SPRINGS


def scenes_with(part: str) -> list[Scene]:
    """Return the scenes with this in their name, all for an empty text.

    Raises ValueError, with the names that there are, where no scene has it.
    """
    every = [make() for make in (*FLIGHTS, *SPRINGS, *IMPACTS, *LINKED, *BRIDGES, *NETS)]
    if found := [scene for scene in every if part in scene.name]:
        return found
    names = "; ".join(scene.name for scene in every)
    raise ValueError(f"scene must be a part of a scene's name, got {part!r}: {names}")
