"""Load and check the Python file in which a user of `make choose` describes a scene."""

from __future__ import annotations

import importlib.util
import math
import sys
import traceback
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from ch02_vectors.vector import Vector3
from ch05_forces.forces import ForceGenerator
from ch05_forces.particle import Particle
from ch08_mass_aggregate.world import ParticleWorld
from scenes.clock import RATE

Values = tuple[float, ...]  # what is measured at the end of a frame
CALLS, ALL_CALLS = 600, 20_000  # at most, of each force and of all forces
SAME = 1e-9  # the largest relative difference of two equal forces
NAME = "scene_file"  # name of the module that is made from a file


class SceneError(ValueError):
    """Raised if the user's file does not describe a valid scene. The message says why."""


@dataclass(frozen=True)
class OwnScene:
    """A scene that a user of `make choose` has described in a Python file.

    The two functions are the user's own and may contain errors. ``built`` and ``measured`` call
    them and check the results.
    """

    path: Path
    frames: int  # of 1/60 s
    build: Callable[[], Any]
    measure: Callable[[Any], Any]  # what to compare

    def built(self) -> ParticleWorld:
        """Build the scene, or raise SceneError if build() fails or its result has no particles."""
        world = self._asked("build", self.build)
        if not isinstance(world, ParticleWorld):
            raise SceneError(f"build() must return a ParticleWorld, got {world!r}")
        if not world.particles:
            raise SceneError("the world that build() returns has no particles")
        return world

    def measured(self, world: ParticleWorld) -> Values:
        """Return the measured numbers, which may be infinite or NaN.

        Raise SceneError if measure() fails, or returns anything but numbers and vectors.
        """
        found = self._asked("measure", lambda: self.measure(world))
        try:
            return tuple(_numbers(found))
        except TypeError:
            wanted = "a number, a Vector3, or a list of these"
            raise SceneError(f"measure() must return {wanted}, got {found!r}") from None

    def check(self) -> Values:
        """Build the scene twice, and return the values measured at the start.

        Raise SceneError if the two copies differ or share a particle, or nothing finite is
        measured.
        """
        first, second = self.built(), self.built()
        if {*map(id, first.particles)} & {*map(id, second.particles)}:
            raise SceneError(
                "build() must make new particles on every call, because each run starts over; it "
                "returned the same particle twice"
            )
        values, again = self.measured(first), self.measured(second)
        if not values:
            raise SceneError("measure() returned no numbers")
        if not all(map(math.isfinite, values)):
            raise SceneError(f"measure() must be finite at the start, got {values}")
        if values != again:
            raise SceneError(
                f"build() must make the same scene on every call, but measure() gave {values} for "
                f"the first and {again} for the second; seed any random numbers"
            )
        return values

    def _asked(self, what: str, call: Callable[[], Any]) -> Any:
        try:
            return call()
        except (Exception, SystemExit) as error:
            raise SceneError(f"{what}() {why(error, self.path)}") from error


def check_forces(scene: OwnScene) -> None:
    """Raise SceneError if a force gives different results although no particle moves.

    A method may evaluate the forces several times per step, so a force that adds up the durations
    of its calls has a wrong clock. A subclass of ParticleWorld may call its forces in its own way,
    so it is not checked. A force that raises an exception passes, because the runs will report it.
    """
    world = scene.built()
    pairs = world.registry.pairs()
    if type(world) is not ParticleWorld or not pairs:
        return
    calls = min(scene.frames, CALLS, max(2, ALL_CALLS // len(pairs)))
    for particle, force in pairs:
        try:
            repeats = _repeats(particle, force, calls)
        except Exception:
            return
        if not repeats:
            raise SceneError(
                f"{type(force).__name__} gave different forces, although no particle had moved. A "
                "force must not keep its own clock or any other memory, because some methods "
                "evaluate the forces several times per step. Let it read the time from a clock "
                "that is a particle, as in studies/choose/example_driven.py. Draw any random "
                "numbers in build()"
            )


def _repeats(particle: Particle, force: ForceGenerator, calls: int) -> bool:
    """Return True if a generator gives its particle the same force in every call."""
    first: tuple[float, ...] = ()
    for _ in range(calls):
        particle.clear_forces()
        force.update_force(particle, 1.0 / RATE)
        now = tuple(particle.force_accumulator)
        first = first or now
        least = SAME * max(map(abs, first))
        if any(abs(x - y) > least for x, y in zip(first, now, strict=True)):
            return False
    return True


def load(path: Path) -> OwnScene:
    """Load the user's scene, or raise SceneError if the file is missing, broken or incomplete."""
    module = _run(path)
    build, measure = (getattr(module, name, None) for name in ("build", "measure"))
    for name, found in (("build", build), ("measure", measure)):
        if found is not None and not callable(found):
            raise SceneError(f"{name} must be a function, got {found!r}")
    if build is None:
        raise SceneError(
            "build is missing. Define it as a function that returns a ParticleWorld, as in "
            "studies/choose/example.py"
        )
    if not hasattr(module, "DURATION"):
        raise SceneError("DURATION is missing. Set it to the time in s that the scene should run")
    duration = module.DURATION
    is_number = isinstance(duration, (int, float)) and not isinstance(duration, bool)
    if not is_number or not 0.5 / RATE < duration < math.inf:
        wanted = f"a number of seconds, at least one frame of 1/{RATE:g} s"
        raise SceneError(f"DURATION must be {wanted}, got {duration!r}")
    return OwnScene(path, round(duration * RATE), build, measure or positions)


def why(error: BaseException, path: Path) -> str:
    """Describe an exception, as in "stopped on line 12 with ValueError: math domain error"."""
    frames = traceback.extract_tb(error.__traceback__)
    lines = [frame.lineno for frame in frames if Path(frame.filename) == path.absolute()]
    if isinstance(error, SyntaxError) and Path(error.filename or "") == path.absolute():
        lines.append(error.lineno)
    where = f" on line {lines[-1]}" if lines else ""
    told = error.msg if isinstance(error, SyntaxError) else error
    return f"stopped{where} with {type(error).__name__}: {told}"


def positions(world: ParticleWorld) -> list[Vector3]:
    """Return the positions of all movable particles, the measure if the user defines none."""
    return [particle.position for particle in world.particles if particle.inverse_mass]


def _run(path: Path) -> ModuleType:
    if not path.is_file():
        raise SceneError("there is no such file")
    spec = importlib.util.spec_from_file_location(NAME, path.absolute())
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[NAME] = module  # because a dataclass in the file looks itself up there
    try:
        spec.loader.exec_module(module)
    except (Exception, SystemExit) as error:
        raise SceneError(f"the file {why(error, path)}") from error
    return module


def _numbers(found: Any) -> Iterable[float]:
    """Yield all numbers in a number, a vector or a list of these, or raise TypeError."""
    if isinstance(found, (int, float)):
        yield float(found)
    elif isinstance(found, str):
        raise TypeError
    else:
        for part in found:
            yield from _numbers(part)
