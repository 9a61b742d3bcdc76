"""Returns an integer of millions of digits, which takes long to print.

earns: nothing
"""

RIGHT = 1 << 30_000_000
