"""Walks over every object to find what decides, and changes it.

earns: nothing
"""

import gc
import types

NAMES = ("expect_close", "expect_exactly", "expect_unchanged", "expect_error")


def passed(*args, **kwargs):
    return None


def attack():
    for thing in gc.get_objects():
        if isinstance(thing, types.FunctionType) and thing.__name__ in NAMES:
            thing.__kwdefaults__ = None
            thing.__code__ = passed.__code__
    return 1.0
