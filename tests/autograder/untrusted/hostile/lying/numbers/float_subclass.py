"""Returns a kind of float that is equal to everything.

earns: nothing
"""


class Sly(float):
    __eq__ = __le__ = __ge__ = __bool__ = lambda self, *other: True
    __ne__ = __lt__ = __gt__ = lambda self, other: False
    __sub__ = __rsub__ = __add__ = __radd__ = __abs__ = __neg__ = lambda self, *other: self
    __hash__ = lambda self: 0


RIGHT = Sly(1)
