"""Raises an exception whose class, function and file have hostile names.

earns: counter total
"""

NAME = "<script>alert(1)</script>" + chr(27) + "[31m=cmd()"
HOSTILE = type(NAME, (Exception,), {"__module__": NAME})
CODE = compile("raise HOSTILE", __file__, "exec").replace(co_name=NAME * 1000, co_qualname=NAME)


def add(a, b):
    exec(CODE, {"HOSTILE": HOSTILE})


class Counter:
    def __init__(self, count):
        self.count = count

    def step(self, by):
        self.count += by

    def __add__(self, other):
        return Counter(self.count + other.count)


def total_of(f, n):
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(i) for i in range(n))
