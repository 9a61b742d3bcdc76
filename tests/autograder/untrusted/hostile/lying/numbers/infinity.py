"""Returns infinity.

earns: nothing
"""

RIGHT = float("inf")
