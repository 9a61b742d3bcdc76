"""An interactive scene for chapter 8 that replays the test scenes of the accuracy study."""

from __future__ import annotations

import time as clock

from autograder.commands import require
from lab.drawing.pen import Pen
from lab.scene import Pair, Scene
from scenes.parameters import Choice

require("everything")  # SciPy computes the truths
from scenes.clock import RATE  # noqa: E402
from studies.accuracy.catalog import scenes_with  # noqa: E402
from studies.accuracy.scene import Place  # noqa: E402

# Bodies at rest do not move, and most of their models take longer than a reader will wait.
STILL = ("rope bridge at rest", "rope bridge asleep", "stack", "pile", "thousand")
CHARTED = {
    scene.name: scene for scene in scenes_with("") if not any(part in scene.name for part in STILL)
}
METHODS = list(dict.fromkeys(model.name for scene in CHARTED.values() for model in scene.models))


class Charts(Scene):
    """Replays a test of the accuracy study, whose frames a method has computed in advance."""

    title = "Speed against accuracy"
    question = "Which method is the fastest that is accurate enough?"
    view = (-1.6, 1.6, -1.3, 1.3)
    seconds = 3.0
    exact_from = "the closed form, or SciPy with a tolerance of 1e-11"
    error_unit = "of the scale"
    compare = ("method", "steps", "tolerance", "long_steps")
    charted = Choice("elastic pendulum", "scene", [*CHARTED])
    method = Choice("semi-implicit Euler", "method", METHODS)
    steps = Choice(4, "steps per frame", [1, 2, 4, 8])
    tolerance = Choice(1e-4, "tolerance of a method in own steps", [1e-2, 1e-4, 1e-6, 1e-8], "m")
    long_steps = Choice(4, "steps per 12 frames of a method in long steps", [2, 3, 4, 6])

    def build(self) -> None:
        self.scene = CHARTED[self.charted]
        models = {model.name: model for model in self.scene.models}
        self.model = models.get(self.method, self.scene.models[0])  # not every method was run
        started = clock.perf_counter()
        try:
            outcome = self.model.run(self.fineness()[0])
        except (ArithmeticError, ValueError) as error:
            raise ArithmeticError(f"The scene exploded. Choose more steps. {error}") from error
        self.cost = 1e6 * (clock.perf_counter() - started) / self.scene.frames
        self.places, self.work = outcome.places, outcome.work
        self.truths = [self.scene.truth(frame / RATE) for frame in range(1, self.scene.frames + 1)]
        self.frame = 0
        xs, ys = zip(*(point for truth in self.truths for point in points(truth)), strict=True)
        self.middle = (0.5 * (min(xs) + max(xs)), 0.5 * (min(ys) + max(ys)))
        self.size = max(max(xs) - min(xs), max(ys) - min(ys), 1e-9)  # m

    def fineness(self) -> tuple[int, str]:
        """Return the number with which the method runs, and describe it in words."""
        if self.model.takes_tolerance:
            return round(1.0 / self.tolerance), f"a tolerance of {self.tolerance:g} m"
        if len(self.model.steps) == 1:
            return self.model.steps[0], "no choice of steps"
        steps = self.steps if self.model.per == 1 else self.long_steps
        return steps, f"{steps} steps per {'frame' if self.model.per == 1 else '12 frames'}"

    def step(self, duration: float) -> None:
        self.frame = min(self.frame + 1, len(self.places) - 1)

    def seen(self, place: Place) -> list[tuple[float, float]]:
        """Convert positions to picture coordinates, so that the whole path fits in."""
        x0, y0 = self.middle
        return [(2.0 * (x - x0) / self.size, 2.0 * (y - y0) / self.size) for x, y in points(place)]

    def draw(self, pen: Pen) -> None:
        last = [self.seen(place)[-1] for place in self.truths]
        pen.line(last, "gray", 1.0, dashed=True)
        for point in self.seen(self.truths[self.frame]):
            pen.circle(point, 0.06, "gray", fill=False)
        own = self.seen(self.places[self.frame])
        if len(own) > 1:
            pen.line(own, "blue", 1.5)
        for point in own:
            pen.circle(point, 0.04, "blue")
        chosen = self.model.name == self.method
        note = "" if chosen else f" (there is no {self.method} in this scene)"
        pen.text((0.0, 1.2), self.model.name + note, "black", 14.0)

    def beside_exact(self) -> Pair:
        found, exact = self.places[self.frame], self.truths[self.frame]
        scale = self.scene.scale
        return [float(x) / scale for x in found], [float(x) / scale for x in exact]

    def facts(self) -> str:
        work = f"{self.work:,} {self.scene.counted} for {self.scene.frames} frames"
        return f"{self.fineness()[1]}; {work}; the scale is {self.scene.scale:g} m"

    def say(self) -> str:
        return f"The error of {self.model.name} is {self.error() or 0.0:.2g} of the scale."


def points(place: Place) -> list[tuple[float, float]]:
    """Split a flat tuple of coordinates into points (x, y). A single one is a height at x = 0."""
    numbers = [float(number) for number in place]
    if len(numbers) == 1:
        return [(0.0, numbers[0])]
    return list(zip(numbers[::2], numbers[1::2], strict=True))
