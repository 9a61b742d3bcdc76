"""Compute the numbers of chapter 4's lesson with the reference."""

from __future__ import annotations

import math

from ch02_vectors.vector import Vector3
from ch03_laws_of_motion.particle import Particle
from ch04_particle_engine.ballistics import aim
from ch04_particle_engine.catherine_wheel import CatherineWheel
from ch04_particle_engine.closed_form import drag_factors, state_after
from ch04_particle_engine.firework_types import FIREWORK_TYPES
from ch04_particle_engine.fireworks import FireworksShow
from ch04_particle_engine.scaling import muzzle_energy, slowed_gravity
from ch04_particle_engine.targets import TargetBlock, hit_fraction
from lessons.lesson import Facts

facts = Facts()

facts.section("A bullet that can be seen", "1.5 5 10 25 60 100 500 0.005 9.81")
gravity = slowed_gravity(10, 20)
facts.says("8 625", 500 / 60, muzzle_energy(0.005, 500))  # more than 8 m
facts.says("20 400 0.025", 500 / 25, 20.0**2, gravity)
facts.says("0.2 0.0981", gravity * (100 / 25) ** 2 / 2, slowed_gravity(9.81, 10))
facts.says("14", 25 * math.sqrt(2 * 1.5 / 9.81))

facts.section("Shots are data", "20 30 90")
shot = aim(20, math.pi / 2, math.radians(30))
facts.says("0.866 0.5 17.32 10", shot.x / 20, shot.y / 20, shot.x, shot.y)
facts.says("400", shot.squared_magnitude())

facts.section("A grenade", "0.6 15")
ahead, behind = (Particle(velocity=Vector3(4 + u), mass=0.6 / 12) for u in (15, -15))
facts.says("2.4", Particle(velocity=Vector3(4), mass=0.6).momentum().x)
facts.says("0.05 19 11", ahead.mass, ahead.velocity.x, behind.velocity.x)
facts.says("0.95 0.55", ahead.momentum().x, behind.momentum().x)
facts.says("0.4", (ahead.momentum() + behind.momentum()).x)

facts.section("Does the shot hit the block?", "0.5 100 29.5 30.5")
wall = TargetBlock(Vector3(0, 1, 30), (4, 2, 0.5), mass=100)
near, far = Vector3(0, 1, 29.5), Vector3(0, 1, 30.5)
hit, back = hit_fraction(near, far, wall), hit_fraction(far, near, wall)
facts.says("1.67 0.25 0.75", 100 / 60, hit, 1 - back)
facts.says("29.75 30.25", near.z + hit, far.z - back)

facts.section("Fireworks: rules that light each other", "5 7 10")
facts.says("25 3,125", 5.0**2, 5.0**5)

facts.section("A wheel that throws sparks", "0.5 8 13 14 50 60")
wheel = CatherineWheel(FireworksShow(FIREWORK_TYPES, 100, 1), 3, Vector3(), 0.5, 8, 50)
thrown = []
for _ in range(14):
    wheel.update(1 / 60)
    thrown.append(wheel.thrown)
facts.says("10 11 10.83 11.67", *thrown[12:], 50 * 13 / 60, 50 * 14 / 60)

facts.section("When you need no step at all", "10 45 60 600 0.4")
kept, gone, fallen = drag_factors(0.5, 1)
spark = Particle(velocity=Vector3(0, 10), acceleration=Vector3(0, -10), damping=0.5)
facts.says("0.693 0.5 0.721 0.402", math.log(2), kept, gone, fallen)
facts.says("7.21 4.02 3.19", 10 * gone, 10 * fallen, state_after(spark, 1)[0].y)
