"""Going further: a resolver that finds the worst contact without comparing all of them.

Resolving a contact moves two particles, so it changes only the contacts of these two particles. The
resolver keeps a list of contacts for each particle, and a heap that gives the worst contact of all.
If several contacts are equally bad, the resolver takes the first, as ContactResolver does. The two
resolvers therefore resolve the same contacts in the same order, and give the same results apart
from rounding. If many contacts are equally bad, a rounding error may decide which of them is
resolved first.

For each resolution, ContactResolver compares all n contacts. The heap updates only the few contacts
that changed, and each update visits only about log n of its entries. For ten contacts, comparing
all of them is fast enough. For 300 contacts the heap is many times faster (`make measure
WHAT=bench`).

To reach this speed, the resolver computes with plain floats, and changes the particles' vectors in
place. It computes anything that is constant during a step only once.

This file is complete, so there is nothing to fill in.
"""

from __future__ import annotations

from heapq import heapify, heappop, heappush

from ch02_vectors.vector import Vector3
from ch07_constraints.contacts import (
    DEPTH_TOLERANCE,
    VELOCITY_TOLERANCE,
    Contact,
    ContactResolver,
)

Row = tuple[int, Vector3, Vector3, float, float, float]
Plan = tuple[float, float, float, float, list[Row]]


class HeapResolver(ContactResolver):
    """A ContactResolver with the same results, whose cost grows with n log n instead of n^2.

    The resolver contains a copy of Contact's formulas and does not call its methods. If a subclass
    of Contact overrides these methods, the overrides have no effect here.
    """

    def resolve_velocities(self, contacts: list[Contact], limit: int, duration: float) -> int:
        """Resolve the velocity of the contact that closes fastest, up to ``limit`` times."""
        still = Vector3()
        rows: list[Row] = []  # for each contact: index, both velocities, and the normal
        for i, contact in enumerate(contacts):
            other = contact.other.velocity if contact.other is not None else still
            rows.append((i, contact.particle.velocity, other, *contact.normal))
        closing = [(v.x - w.x) * x + (v.y - w.y) * y + (v.z - w.z) * z for _, v, w, x, y, z in rows]
        heap = [
            (velocity, i) for i, velocity in enumerate(closing) if velocity < -VELOCITY_TOLERANCE
        ]
        heapify(heap)
        contacts_of = _contacts_of(contacts)
        plans: list[Plan | None] = [None] * len(contacts)
        accelerations: dict[int, Vector3] = {}
        used = 0
        while heap and used < limit:
            velocity, i = heappop(heap)
            if velocity != closing[i]:
                continue  # outdated: a contact that still closes has a newer entry
            plan = plans[i]
            if plan is None:
                contact = contacts[i]
                a, b = contact.particle, contact.other
                inverse_a, inverse_b = a.inverse_mass, 0.0 if b is None else b.inverse_mass
                built_up = _built_up(contact, accelerations, duration)
                near = {*contacts_of.get(id(a), ()), *contacts_of.get(id(b), ())}
                changed = [rows[j] for j in near]
                plan = plans[i] = (contact.restitution, built_up, inverse_a, inverse_b, changed)
            restitution, built_up, inverse_a, inverse_b, changed = plan
            impulse = (max(0.0, restitution * (built_up - velocity)) - velocity) / (
                inverse_a + inverse_b
            )
            _, v, w, x, y, z = rows[i]
            change = impulse * inverse_a
            v.x += x * change
            v.y += y * change
            v.z += z * change
            change = -impulse * inverse_b
            w.x += x * change
            w.y += y * change
            w.z += z * change
            used += 1
            for j, v, w, x, y, z in changed:
                closing[j] = velocity = (v.x - w.x) * x + (v.y - w.y) * y + (v.z - w.z) * z
                if velocity < -VELOCITY_TOLERANCE:
                    heappush(heap, (velocity, j))
        return used

    def resolve_penetrations(self, contacts: list[Contact], limit: int) -> int:
        """Resolve the penetration of the deepest contact, up to ``limit`` times."""
        heap = [
            (-contact.penetration, i)
            for i, contact in enumerate(contacts)
            if contact.penetration > DEPTH_TOLERANCE
        ]
        heapify(heap)
        contacts_of = _contacts_of(contacts)
        used = 0
        while heap and used < limit:
            depth, i = heappop(heap)
            worst = contacts[i]
            if -depth != worst.penetration:
                continue
            a, b, n = worst.particle, worst.other, worst.normal
            inverse_b = 0.0 if b is None else b.inverse_mass
            share = worst.penetration / (a.inverse_mass + inverse_b)
            worst.penetration = 0.0
            used += 1
            for particle, scale in ((a, share * a.inverse_mass), (b, -share * inverse_b)):
                if particle is None or not scale:
                    continue
                dx, dy, dz = n.x * scale, n.y * scale, n.z * scale
                position = particle.position
                position.x += dx
                position.y += dy
                position.z += dz
                for j in contacts_of[id(particle)]:
                    if j == i:
                        continue
                    contact = contacts[j]
                    m = contact.normal
                    change = dx * m.x + dy * m.y + dz * m.z
                    contact.penetration += -change if contact.particle is particle else change
                    if contact.penetration > DEPTH_TOLERANCE:
                        heappush(heap, (-contact.penetration, j))
        return used


def _contacts_of(contacts: list[Contact]) -> dict[int, list[int]]:
    """Return a dict from the id of each movable particle to the indices of its contacts."""
    found: dict[int, list[int]] = {}
    for i, contact in enumerate(contacts):
        for particle in (contact.particle, contact.other):
            if particle is not None and particle.inverse_mass:
                found.setdefault(id(particle), []).append(i)
    return found


def _built_up(contact: Contact, accelerations: dict[int, Vector3], duration: float) -> float:
    """Return the velocity that a step's acceleration has built up, as in Contact.velocity_after."""
    if not contact.restitution:  # without a bounce it does not matter
        return 0.0
    velocity, n = 0.0, contact.normal
    for particle, sign in ((contact.particle, duration), (contact.other, -duration)):
        if particle is not None and particle.inverse_mass:
            acceleration = accelerations.get(id(particle))
            if acceleration is None:  # the property makes vectors, so read it once per particle
                acceleration = accelerations[id(particle)] = particle.last_acceleration
            a = acceleration
            velocity += (a.x * n.x + a.y * n.y + a.z * n.z) * sign
    return min(0.0, velocity)
