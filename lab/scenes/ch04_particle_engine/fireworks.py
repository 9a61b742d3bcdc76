"""A fireworks game for chapter 4, in which the player keeps a display going (project 4.1)."""

from __future__ import annotations

from ch02_vectors.vector import Vector3
from ch04_particle_engine.display import Display, click, find_rocket, is_over, tick
from ch04_particle_engine.fireworks import FireworksShow, endless_types
from ch04_particle_engine.screen_rotation import screen_angle, screen_corners
from lab.drawing.pen import Pen
from lab.scene import Scene
from scenes.readings import is_written
from scenes.shots_and_sparks import WHEEL_SPARK, firework_rules, make_wheel

COLORS = ("orange", "red", "sky", "pink", "brown", "red", "sky", "green", "violet", "pink", "green")


class Fireworks(Scene):
    """A fireworks display that goes on as long as the player keeps hitting its rockets."""

    title = "Keep the fireworks alive"
    question = "How can a few rules light hundreds of sparks?"
    view = (-30.0, 30.0, -1.0, 34.0)
    seconds = 12.0
    keys = {**{str(i): f"launch a firework of type {i}" for i in range(1, 10)}}
    SPIN = 5.0  # rad/s, at which sparks rotate on the screen

    def build(self) -> None:
        rules = [*firework_rules(), WHEEL_SPARK]
        self.display = Display(FireworksShow(rules, capacity=400, seed=2))
        self.wheel = make_wheel(self.display.show, Vector3(-22, 10, 0))
        game = (lambda: is_over(self.display), lambda: find_rocket(self.display, 0.0, 0.0))
        self.plays = all(map(is_written, game))
        self.endless = endless_types(rules) if is_written(lambda: endless_types([])) else []
        self.spins = is_written(lambda: screen_corners((0.0, 0.0), 1.0, screen_angle(0.0, 1.0, 0)))
        for kind in (1, 6, 10 if 10 in self.display.show.rules else 2):
            self.display.show.launch(kind)

    def step(self, duration: float) -> None:
        if self.wheel and not self.ended():
            self.wheel.update(duration)
        if self.plays:
            tick(self.display, duration)
        else:
            self.display.show.update(duration)

    def ended(self) -> bool:
        """Return True if the game is over. It never ends if its rules are not written yet."""
        return self.plays and is_over(self.display)

    def draw(self, pen: Pen) -> None:
        show = self.display.show
        pen.ground()
        if self.wheel:
            pen.circle(self.wheel.center, self.wheel.radius, "gray", fill=False)
        for firework in show.fireworks:
            p = firework.particle.position
            size = 0.9 if show.rules[firework.type].payloads else 0.45
            corners = [(p.x - size, p.y), (p.x, p.y - size), (p.x + size, p.y)]
            if self.spins:
                angle = screen_angle(0.0, self.SPIN, firework.age)
                corners = [*screen_corners((p.x, p.y), size, angle)]
            pen.area(corners, COLORS[(firework.type - 1) % len(COLORS)], solid=True)
        if self.ended():
            pen.text((0.0, 16.0), "The display has ended. Press r to restart.", "red", 20.0)

    def chart(self) -> dict[str, float]:
        return {"fireworks burning": float(len(self.display.show.fireworks))}

    def facts(self) -> str:
        show = self.display.show
        endless = f"; types {self.endless} light each other forever" if self.endless else ""
        return f"at most {show.capacity} sparks; {show.dropped} did not fit{endless}"

    def say(self) -> str:
        shown = self.display
        return f"Score {shown.score}, misses {shown.misses}, {shown.time:.1f} s alive."

    def press(self, key: str) -> None:
        if key in "123456789" and not self.ended():
            self.display.show.launch(int(key))

    def click(self, x: float, y: float) -> None:
        if self.plays:
            click(self.display, x, y)

    def play(self, time: float) -> None:
        """Click on each rocket just before it bursts, or launch some if the game is not written."""
        if time > self.seconds - 3.0:
            return
        if not self.plays:
            if round(time * 60.0) % 60 == 59:
                self.display.show.launch(1 + round(time) % 2 * 5)
            return
        for firework in [*self.display.show.fireworks]:  # a copy: click extends the show's list
            if 0.0 < firework.age < 0.3 and firework.type in (1, 2, 6, 10):
                p = firework.particle.position
                click(self.display, p.x, p.y)
