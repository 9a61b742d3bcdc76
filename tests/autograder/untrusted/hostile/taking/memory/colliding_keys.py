"""Returns a dict of keys that collide, so that it takes the checks long to build.

earns: nothing
"""


def flood():
    """A dict of keys that all collide takes long to build, and longer to build again."""
    return {k * (2**61 - 1): 1 for k in range(20_000)}


def add(a, b):
    return flood()
