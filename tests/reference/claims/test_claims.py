"""Each claim of the book has the verdict that claims.md prints, and the page is up to date."""

from __future__ import annotations

import pytest

from autograder.manifest import ROOT, Chapter, load_chapters
from lessons.lesson import lesson_of
from reference.claims import contacts, motion, springs, turns
from reference.claims.ledger import Claim, claims_in, summary

PAGE = (ROOT / "docs/claims.md").read_text(encoding="utf-8")
CLAIMS = list(claims_in(motion, springs, contacts, turns))
CHAPTERS = {str(chapter.number): chapter for chapter in load_chapters()}
WITH_CHAPTER = [
    pytest.param(CHAPTERS[claim.section[0]], claim, id=claim.measured.__name__) for claim in CLAIMS
]


@pytest.mark.parametrize(("chapter", "claim"), WITH_CHAPTER)
def test_a_claim_has_its_verdict_and_its_entry(chapter: Chapter, claim: Claim) -> None:
    assert f"](../../docs/claims.md#chapter-{chapter.number})" in lesson_of(chapter.name)
    assert claim.entry() in PAGE, (
        "run make measure WHAT=claims, and read what has changed in claims.md"
    )


def test_the_page_has_these_claims_and_no_others() -> None:
    assert [line[4:] for line in PAGE.splitlines() if line.startswith("### ")] == [
        claim.says for claim in CLAIMS
    ]
    assert " ".join(summary(CLAIMS).split()) in " ".join(PAGE.split())
