"""Returns NaN, which is neither larger nor smaller than a tolerance.

earns: nothing
"""

RIGHT = float("nan")
