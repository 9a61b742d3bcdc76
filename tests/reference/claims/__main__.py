"""Measure all claims of the book, and write docs/claims.md: python tests/reference/claims."""

from __future__ import annotations

import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parents[2]
ROOT = TESTS.parent
sys.path[1:1] = [str(TESTS), str(ROOT), str(ROOT / "solutions"), str(ROOT / "chapters")]


def main() -> None:
    """Write the measured numbers into the page, and say where it is."""
    from reference.claims import contacts, motion, springs, turns
    from reference.claims.ledger import PAGE, claims_in, measured_page

    claims = claims_in(motion, springs, contacts, turns)
    page = measured_page(claims, PAGE.read_text(encoding="utf-8"))
    PAGE.write_text(page, encoding="utf-8")
    print(f"measured {len(claims)} claims of the book: docs/claims.md")


if __name__ == "__main__":
    main()
