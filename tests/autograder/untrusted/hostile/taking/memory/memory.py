"""Takes memory in pieces, as much as there is; earns the point only with 1 GB.

earns: counter total
"""


def add(a, b):
    pieces = []
    for _ in range(1000):
        pieces.append(bytearray(b"x") * (1 << 20))
    return a + b
