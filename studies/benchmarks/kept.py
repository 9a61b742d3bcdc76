"""Save the results of `make measure WHAT=bench` to a file, and load them again."""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from datetime import date
from pathlib import Path

from scenes.timing import Line, significant

FILE = Path(__file__).with_name("figures.json")


def keep(lines: Sequence[Line], versions: str, file: Path = FILE) -> None:
    """Save the results of the benchmarks, with the date, the machine and the versions."""
    found = {
        "measured": date.today().isoformat(),
        "python": platform.python_version(),
        "machine": f"{platform.system()} {platform.machine()}",
        "libraries": versions,
        "lines": {
            line.what: {
                "ratio": significant(line.median),
                "quartiles": [significant(line.low), significant(line.high)],
                "target": str(line.target or ""),
                "verdict": line.verdict,
            }
            for line in lines
        },
    }
    file.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


def kept(file: Path = FILE) -> dict[str, float]:
    """Load the medians by what they measure, or an empty dict if no results are stored yet."""
    if not file.exists():
        return {}
    lines = json.loads(file.read_text(encoding="utf-8"))["lines"]
    return {what: line["ratio"] for what, line in lines.items()}
