"""Links."""

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch07_constraints.contacts import Contact, a_particle, a_restitution, direction_of


class Cable:
    def __init__(self, a, b, max_length, restitution=0.0):
        self.a, self.b = two_particles(a, b)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self):
        d = self.b.position - self.a.position
        length = d.magnitude()
        if length < self.max_length:
            return []
        depth = length - self.max_length
        return [Contact(self.a, self.b, d.normalized(), self.restitution, depth)]


class AnchoredCable:
    def __init__(self, particle, anchor, max_length, restitution=0.0):
        self.particle = a_particle("particle", particle)
        self.anchor = finite_vector("anchor", anchor)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self):
        d = self.anchor - self.particle.position
        length = d.magnitude()
        if length < self.max_length:
            return []
        depth = length - self.max_length
        return [Contact(self.particle, None, d.normalized(), self.restitution, depth)]


class Rod:
    def __init__(self, a, b, length):
        self.a, self.b = two_particles(a, b)
        self.length = positive("length", length)

    def contacts(self):
        d = self.b.position - self.a.position
        length = d.magnitude()
        if length <= self.length:
            return []
        return [Contact(self.a, self.b, direction_of(d), 0.0, length - self.length)]


class AnchoredRod:
    def __init__(self, particle, anchor, length):
        self.particle = a_particle("particle", particle)
        self.anchor = finite_vector("anchor", anchor)
        self.length = positive("length", length)

    def contacts(self):
        d = self.anchor - self.particle.position
        length = d.magnitude()
        if length <= self.length:
            return []
        return [Contact(self.particle, None, direction_of(d), 0.0, length - self.length)]


class Limits:
    def __init__(self, a, b, min_length, max_length, restitution=0.0):
        self.a, self.b = two_particles(a, b)
        self.min_length = not_negative("min_length", min_length)
        self.max_length = positive("max_length", max_length)
        if self.min_length > self.max_length:
            wanted = f"min_length must be max_length, {max_length!r}, or less"
            raise ValueError(f"{wanted}, got {min_length!r}")
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self):
        d = self.b.position - self.a.position
        length = d.magnitude()
        normal = direction_of(d)
        if length >= self.max_length:
            depth = length - self.max_length
            return [Contact(self.a, self.b, normal, self.restitution, depth)]
        if length <= self.min_length:
            depth = self.min_length - length
            return [Contact(self.a, self.b, -normal, self.restitution, depth)]
        return []


class TwoSidedRod(Rod):
    def contacts(self):
        raise NotImplementedError("Exercise G7.1: Two-sided rods, as in the text of the book")


def two_particles(a, b):
    a_particle("a", a)
    if a_particle("b", b) is a:
        raise ValueError(f"b must be another particle than a, got {b!r} twice")
    return a, b
