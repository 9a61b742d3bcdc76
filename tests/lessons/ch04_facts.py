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
from ch04_particle_engine.scaling import muzzle_energy, slowed_gravity, slowed_mass
from ch04_particle_engine.targets import TargetBlock, hit_fraction


def bullets() -> dict[str, float]:
    gravity = slowed_gravity(10, 20)
    assert muzzle_energy(slowed_mass(0.005, 20), 25) == muzzle_energy(0.005, 500)
    return {
        "8": 500 / 60,  # "more than 8 m"
        "625": muzzle_energy(0.005, 500),
        "20": 500 / 25,
        "400": 20.0**2,
        "0.025": gravity,
        "0.2": gravity * (100 / 25) ** 2 / 2,
        "0.0981": slowed_gravity(9.81, 10),
        "14": 25 * math.sqrt(2 * 1.5 / 9.81),
    }


def aims() -> dict[str, float]:
    v = aim(20, math.pi / 2, math.radians(30))
    return {
        "0.5": v.y / 20,
        "0.866": v.x / 20,
        "17.32": v.x,
        "10": v.y,
        "400": v.squared_magnitude(),
    }


def burst() -> dict[str, float]:
    ahead, behind = (Particle(velocity=Vector3(4 + u), mass=0.6 / 12) for u in (15, -15))
    return {
        "2.4": Particle(velocity=Vector3(4), mass=0.6).momentum().x,
        "0.05": ahead.mass,
        "19": ahead.velocity.x,
        "11": behind.velocity.x,
        "0.95": ahead.momentum().x,
        "0.55": behind.momentum().x,
        "0.4": (ahead.momentum() + behind.momentum()).x,
    }


def hits() -> dict[str, float]:
    wall = TargetBlock(Vector3(0, 1, 30), (4, 2, 0.5), mass=100)
    hit = hit_fraction(Vector3(0, 1, 29.5), Vector3(0, 1, 30.5), wall)
    back = hit_fraction(Vector3(0, 1, 30.5), Vector3(0, 1, 29.5), wall)
    assert hit is not None
    assert back is not None
    return {"1.67": 100 / 60, "0.25": hit, "0.75": 1 - back, "29.75": 30 - 0.25, "30.25": 30.25}


def slots() -> dict[str, float]:
    for policy in ("keep_old", "drop_oldest"):
        show = FireworksShow(FIREWORK_TYPES, 10, 1, policy)
        show.light([(3, 7, None)])
        oldest = show.fireworks[:2]
        show.light([(3, 5, None)])
        assert len(show.fireworks) == 10
        assert show.dropped == 2
        assert (oldest[0] in show.fireworks) == (policy == "keep_old")
    return {"25": 5.0**2, "3,125": 5.0**5}


def wheel() -> dict[str, float]:
    show = FireworksShow(FIREWORK_TYPES, 100, 1)
    wheel = CatherineWheel(show, 3, Vector3(), 0.5, 8, 50)
    speed = wheel.nozzle().velocity.magnitude()
    assert speed == 4
    thrown = []
    for _ in range(14):
        wheel.update(1 / 60)
        thrown.append(wheel.thrown)
    return {"10": thrown[12], "11": thrown[13], "10.83": 50 * 13 / 60, "11.67": 50 * 14 / 60}


def formula() -> dict[str, float]:
    kept, gone, fallen = drag_factors(0.5, 1)
    spark = Particle(velocity=Vector3(0, 10), acceleration=Vector3(0, -10), damping=0.5)
    return {
        "0.693": math.log(2),
        "0.5": kept,
        "0.721": gone,
        "0.402": fallen,
        "7.21": 10 * gone,
        "4.02": 10 * fallen,
        "3.19": state_after(spark, 1)[0].y,
    }


SECTIONS = {
    "A bullet that can be seen": ("1.5 5 10 25 60 100 500 0.005 9.81", bullets),
    "Shots are data": ("20 30 90", aims),
    "A grenade": ("0.6 15", burst),
    "Does the shot hit the block?": ("0.5 100 29.5 30.5", hits),
    "Fireworks: rules that light each other": ("5 7 10", slots),
    "A wheel that throws sparks": ("0.5 8 13 14 50 60", wheel),
    "When you need no step at all": ("10 45 60 600 0.4", formula),
}
