"""Say in words how a wrong number, or a list of numbers, differs from the wanted one."""

from __future__ import annotations

import math
from collections.abc import Sequence

FACTORS = {
    2.0: "2 times",
    3.0: "3 times",
    4.0: "4 times",
    1.0 / 2.0: "half of",
    1.0 / 3.0: "a third of",
    1.0 / 4.0: "a quarter of",
    60.0: "60 times",
    1.0 / 60.0: "a sixtieth of",
    9.81: "9.81 times",
    1.0 / 9.81: "1 / 9.81 of",
    math.pi: "pi times",
    math.degrees(1.0): "180 / pi times",
    math.radians(1.0): "pi / 180 of",
}
ORDINALS = ["first", "second", "third", "fourth"]
NEAR = 1e-9  # a relative difference that is only rounding; no two relations are so close


def relation(got: float, wanted: float) -> str:
    """Return a sentence about the only simple relation of two numbers, if there is just one."""
    if not (math.isfinite(got) and math.isfinite(wanted) and got and wanted):
        return ""
    found = [] if not _near(got, -wanted) else ["It has the opposite sign."]
    for factor, words in FACTORS.items():
        if _near(got, factor * wanted):
            found.append(f"It is {words} the wanted value.")
        if _near(got, -factor * wanted):
            found.append(f"It is {words} the wanted value, with the opposite sign.")
    if _near(got, wanted * wanted):
        found.append("It is the square of the wanted value.")
    if _near(got, 1.0 / wanted):
        found.append("It is 1 divided by the wanted value.")
    if wanted > 0.0 and _near(got, math.sqrt(wanted)):
        found.append("It is the square root of the wanted value.")
    return found[0] if len(found) == 1 else ""


def _near(one: float, other: float) -> bool:
    return abs(one - other) <= NEAR * abs(other)


def difference(got: Sequence[float], wanted: Sequence[float], tolerance: float) -> str:
    """Say which of several numbers are wrong, and how they differ, if that is simple."""
    if len(wanted) == 1:
        return relation(got[0], wanted[0])
    names = ORDINALS if len(wanted) <= len(ORDINALS) else [f"[{i}]" for i in range(len(wanted))]
    pairs = [*zip(names, got, wanted, strict=False)]
    wrong = [(name, g, w) for name, g, w in pairs if not abs(g - w) <= tolerance]
    relations = {relation(g, w) for _, g, w in wrong}
    how = relations.pop() if len(relations) == 1 else ""
    if len(wrong) == len(pairs):
        return how.replace("It has", "Each has").replace("It is", "Each is")
    if len(wrong) > 2:
        return ""
    which = f"Only the {' and the '.join(name for name, _, _ in wrong)} number"
    if len(wrong) == 1:
        return f"{which} is wrong. {how}".rstrip()
    return f"{which}s are wrong. {how.replace('It', 'Each')}".rstrip()
