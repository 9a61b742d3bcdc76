"""Changes the helpers that the checks have imported already.

earns: nothing
"""

import sys


def nothing(*args, **kwargs):
    return None


def attack():
    for name, module in list(sys.modules.items()):
        if name.rpartition(".")[2] in ("expect", "test_sums"):
            for thing in list(vars(module).values()):
                if getattr(thing, "__name__", "").startswith("expect_"):
                    thing.__kwdefaults__ = None
                    thing.__code__ = nothing.__code__
    return 1.0
