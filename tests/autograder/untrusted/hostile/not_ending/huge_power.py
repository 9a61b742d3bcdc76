"""One call into C that no signal interrupts: a power of many digits.

earns: counter total
"""


def add(a, b):
    return 3 ** (10**9) and a + b
