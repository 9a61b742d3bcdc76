"""Chapter 7 exercises."""

import math
import statistics

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch02_vectors.vector import Vector3
from ch07_constraints.contacts import a_restitution

Drop = tuple[str, float, float]


def restitution_of_drop(initial_height, bounce_height):
    positive("initial_height", initial_height)
    not_negative("bounce_height", bounce_height)
    if bounce_height > initial_height:
        raise ValueError(f"bounce_height must be {initial_height!r} or less, got {bounce_height!r}")
    return bounce_height / initial_height


def table_of_drops(drops):
    groups = {}
    for material, initial, bounce in drops:
        groups.setdefault(material, []).append(restitution_of_drop(initial, bounce))
    rows = []
    for material, values in groups.items():
        n = len(values)
        error = statistics.stdev(values) / math.sqrt(n) if n > 1 else None
        rows.append((material, n, statistics.fmean(values), error))
    return rows


def top_ball_speed(
    height, lower_mass, upper_mass, ground_restitution, pair_restitution, gravity=10.0
):
    not_negative("height", height)
    not_negative("gravity", gravity)
    positive("lower_mass", lower_mass)
    positive("upper_mass", upper_mass)
    a_restitution("ground_restitution", ground_restitution)
    a_restitution("pair_restitution", pair_restitution)
    v = math.sqrt(2 * gravity * height)
    lower = ground_restitution * v
    momentum = lower_mass * lower - upper_mass * v
    closing = lower + v
    return (momentum + lower_mass * pair_restitution * closing) / (lower_mass + upper_mass)


def force_for_frame(force, contact_time, frame):
    force = finite_vector("force", force)
    not_negative("contact_time", contact_time)
    positive("frame", frame)
    if contact_time > frame:
        raise ValueError(f"contact_time must be {frame!r} or less, got {contact_time!r}")
    s = contact_time / frame
    return Vector3(force.x * s, force.y * s, force.z * s)
