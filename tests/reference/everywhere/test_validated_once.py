"""Every layer of a frame checks its duration once, and no number is checked twice."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable
from typing import Any

import pytest

from ch02_vectors import arguments
from ch05_forces.particle import Particle
from ch08_mass_aggregate.bridge import Bridge
from ch08_mass_aggregate.sleeping import SleepingWorld
from ch08_mass_aggregate.world import ParticleWorld

FRAME = 1.0 / 60.0
CHECKS = ("finite", "not_negative", "positive", "positive_or_infinite", "whole", "finite_vector")


@pytest.fixture
def checked(monkeypatch: pytest.MonkeyPatch) -> Counter[tuple[str, str]]:
    """Count the checks by the name of the argument and of the function that checks it."""
    counts: Counter[tuple[str, str]] = Counter()

    def counting(check: Callable[..., Any]) -> Callable[..., Any]:
        def counted(name: str, value: Any) -> Any:
            counts[name, sys._getframe(1).f_code.co_qualname] += 1
            return check(name, value)

        return counted

    replaced = {id(getattr(arguments, name)): getattr(arguments, name) for name in CHECKS}
    for module in [m for name, m in sys.modules.items() if name.startswith("ch0")]:
        for name, value in list(vars(module).items()):
            if id(value) in replaced:
                monkeypatch.setattr(module, name, counting(value))
    return counts


def test_a_frame_of_the_bridge_checks_its_duration_once_a_layer(
    checked: Counter[tuple[str, str]],
) -> None:
    """With the ball on the deck there are contacts, so that every layer is called.

    A user may call any of the five layers. Each layer changes something before it calls the next,
    or cannot know that the next will reject the duration. Contacts and particles check it
    themselves.
    """
    bridge = Bridge()
    for _ in range(60):
        bridge.step(FRAME)
    assert bridge.world.contact_generators[len(bridge.links)].contacts()
    checked.clear()
    bridge.step(FRAME)
    assert bridge.world.resolver.iterations_used > 10
    assert checked == {
        ("duration", "Bridge.step"): 1,
        ("pace", "Bridge.step"): 1,
        ("duration", "ParticleWorld.run_physics"): 1,
        ("duration", "semi_implicit_euler"): 1,
        ("duration", "ForceRegistry.update_forces"): 1,
        ("duration", "ContactResolver.resolve_contacts"): 1,
    }


@pytest.mark.parametrize("kind", [ParticleWorld, SleepingWorld])
def test_a_frame_without_contacts_checks_its_duration_four_times(
    checked: Counter[tuple[str, str]], kind: type[ParticleWorld]
) -> None:
    world = kind([Particle()])
    checked.clear()
    world.step(FRAME)
    assert checked == {
        ("duration", "ParticleWorld.step"): 1,
        ("duration", f"{kind.__name__}.run_physics"): 1,
        ("duration", "semi_implicit_euler"): 1,
        ("duration", "ForceRegistry.update_forces"): 1,
    }
