"""Ada's bounces."""

import math
from statistics import fmean, variance

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch05_forces.particle import Particle
from ch07_constraints.contacts import Contact, a_restitution

Drop = tuple[str, float, float]


def restitution_of_drop(initial_height, bounce_height):
    h = positive("initial_height", initial_height)
    b = not_negative("bounce_height", bounce_height)
    if b > h:
        raise ValueError(f"it bounced to {b} m from only {h} m")
    return math.sqrt(b / h)


def table_of_drops(drops):
    by_material = {}
    for material, *heights in drops:
        by_material.setdefault(material, []).append(restitution_of_drop(*heights))
    return [
        (material, len(c), fmean(c), math.sqrt(variance(c) / len(c)) if len(c) > 1 else None)
        for material, c in by_material.items()
    ]


def top_ball_speed(
    height,
    lower_mass,
    upper_mass,
    ground_restitution,
    pair_restitution,
    gravity=10.0,
):
    not_negative("height", height)
    not_negative("gravity", gravity)
    positive("lower_mass", lower_mass)
    positive("upper_mass", upper_mass)
    speed = math.sqrt(2 * gravity * height)

    # let them do it
    lower = Particle(velocity=Vector3(0, -speed, 0), mass=lower_mass)
    upper = Particle(velocity=Vector3(0, -speed, 0), mass=upper_mass)
    up = Vector3(0, 1, 0)
    impacts = (
        Contact(lower, None, up, a_restitution("ground_restitution", ground_restitution)),
        Contact(upper, lower, up, a_restitution("pair_restitution", pair_restitution)),
    )
    for impact in impacts:
        impact.resolve_velocity()
    return upper.velocity.y


def force_for_frame(force, contact_time, frame):
    weak = finite_vector("force", force)
    h = positive("frame", frame)
    t = not_negative("contact_time", contact_time)
    if t > h:
        raise ValueError(f"{t} s of contact are longer than the frame of {h} s")
    weak *= t / h
    return weak
