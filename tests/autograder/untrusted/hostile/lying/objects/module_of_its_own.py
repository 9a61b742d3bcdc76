"""Puts an object that answers everything in the place of its module.

earns: nothing
"""

import sys


class Anything:
    __file__ = __file__
    __name__ = __name__
    __path__ = []

    def __getattr__(self, name):
        return self

    def __call__(self, *args, **kwargs):
        return self

    def __eq__(self, other):
        return True


sys.modules[__name__] = Anything()
