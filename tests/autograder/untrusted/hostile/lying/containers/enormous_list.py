"""Returns lists with millions of items.

earns: nothing
"""

RIGHT = [0.0] * 3_000_000
