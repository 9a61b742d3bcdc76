"""Takes all memory while it is imported.

earns: nothing
"""

PIECES = [bytearray(b"x") * (1 << 20) for _ in range(1000)]
