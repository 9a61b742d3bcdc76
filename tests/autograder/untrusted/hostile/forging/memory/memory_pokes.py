"""Overwrites the tolerance of the checks in memory.

earns: nothing
"""

import ctypes
import sys


def attack():
    for module in list(sys.modules.values()):
        number = vars(module).get("ROUNDING")
        if type(number) is float:
            ctypes.c_double.from_address(id(number) + 16).value = 1e300
    return 1.0
