"""Ada's cables and rods."""

from ch02_vectors.arguments import finite_vector, not_negative, positive
from ch07_constraints.contacts import Contact, a_particle, a_restitution, direction_of


class BetweenTwo:
    """What links of two particles have in common."""

    def ends(self):
        return self.a, self.b, self.b.position - self.a.position


class ToAnAnchor:
    """The same for a particle and an anchor."""

    def ends(self):
        return self.particle, None, self.anchor - self.particle.position


def pulling(link, length, restitution=0.0):
    one, other, offset = link.ends()
    return Contact(one, other, direction_of(offset), restitution, offset.magnitude() - length)


def pushing(link, length, restitution=0.0):
    contact = pulling(link, length, restitution)
    contact.normal.invert()
    contact.penetration *= -1
    return contact


class Cable(BetweenTwo):
    def __init__(self, a, b, max_length, restitution=0.0):
        self.a, self.b = two_particles(a, b)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self):
        contact = pulling(self, self.max_length, self.restitution)
        return [contact] if contact.penetration >= 0 else []


class AnchoredCable(ToAnAnchor):
    def __init__(self, particle, anchor, max_length, restitution=0.0):
        self.particle = a_particle("particle", particle)
        self.anchor = finite_vector("anchor", anchor)
        self.max_length = positive("max_length", max_length)
        self.restitution = a_restitution("restitution", restitution)

    contacts = Cable.contacts


class Rod(BetweenTwo):
    def __init__(self, a, b, length):
        self.a, self.b = two_particles(a, b)
        self.length = positive("length", length)

    def contacts(self):
        contact = pulling(self, self.length)
        if contact.penetration < 0:
            contact = pushing(self, self.length)
        return [contact] if contact.penetration else []


class AnchoredRod(ToAnAnchor):
    def __init__(self, particle, anchor, length):
        self.particle = a_particle("particle", particle)
        self.anchor = finite_vector("anchor", anchor)
        self.length = positive("length", length)

    contacts = Rod.contacts


class Limits(BetweenTwo):
    def __init__(self, a, b, min_length, max_length, restitution=0.0):
        self.a, self.b = two_particles(a, b)
        self.min_length = not_negative("min_length", min_length)
        self.max_length = positive("max_length", max_length)
        if self.min_length > self.max_length:
            raise ValueError(f"min_length {min_length} is above max_length {max_length}")
        self.restitution = a_restitution("restitution", restitution)

    def contacts(self):
        both = [pulling(self, self.max_length, self.restitution)]
        if self.min_length > 0:  # nothing is nearer than 0
            both.append(pushing(self, self.min_length, self.restitution))
        return [contact for contact in both if contact.penetration >= 0]


class TwoSidedRod(Rod):
    """Tells both sides every time, so that the resolver sees how fast the ends go."""

    def contacts(self):
        return [pulling(self, self.length), pushing(self, self.length)]


def two_particles(a, b):
    a_particle("a", a)
    a_particle("b", b)
    if a is b:
        raise ValueError(f"a and b are the same particle: {a!r}")
    return a, b
