"""Raises messages that would change a terminal: colors, titles, bells, right to left.

earns: counter total
"""


def add(a, b):
    codes = (0, 7, 8, 13, 27, 0x85, 0x9B, 0x202E, 0x2028, 0x2066, 0xFEFF)
    raise ValueError(
        "".join(map(chr, codes)) + chr(27) + "]0;owned" + chr(7) + chr(27) + "[2J[red]mark-up[/red]"
    )
