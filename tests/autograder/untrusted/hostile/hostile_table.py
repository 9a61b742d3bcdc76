"""Print what became of the hostile submissions, by their kind: python hostile_table.py OUT.

tried    submissions, and how many were
forged   given more than their honest score
hung     left without a result
leaked   shown a token of somebody else's
damaged  given less than their honest score, or no grade at all
"""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

from corpus import Submission, all_submissions, leaks, read_results, result_of

COLUMNS = ("tried", "forged", "hung", "leaked", "damaged")


def table(out: Path, submissions: list[Submission]) -> str:
    """Return the table of a run."""
    results = read_results(out)
    leaking = [file for file, _ in leaks(out)]
    rows: dict[str, Counter[str]] = {}
    for submission in submissions:
        row = rows.setdefault(submission.kind, Counter())
        row["tried"] += 1
        row["leaked"] += any(submission.label in file for file in leaking)
        result = result_of(submission, results)
        if result is None:
            row["hung"] += 1
        elif result["status"] == "nothing to grade" and not submission.score:
            continue
        elif result["status"] != "graded" or result["score"] < submission.score:
            row["damaged"] += 1
        elif result["score"] > submission.score:
            row["forged"] += 1
    rows["total"] = sum(rows.values(), Counter())
    lines = [f"{'':12}" + "".join(f"{column:>9}" for column in COLUMNS)]
    for kind, row in rows.items():
        lines.append(f"{kind:12}" + "".join(f"{row[column]:9}" for column in COLUMNS))
    return "\n".join(lines)


if __name__ == "__main__":
    print(table(Path(sys.argv[1]), all_submissions()))
