"""Each claim of the book has the verdict that claims.md prints, and the page is up to date."""

from __future__ import annotations

import pytest

from autograder.manifest import Chapter, load_chapters
from lessons.lesson import lesson_of
from reference.claims import contacts, motion, springs, turns
from reference.claims.ledger import PAGE, Claim, claims_in, summary

TEXT = PAGE.read_text(encoding="utf-8")
CLAIMS = claims_in(motion, springs, contacts, turns)
CHAPTERS = {str(chapter.number): chapter for chapter in load_chapters()}
WITH_CHAPTER = [
    pytest.param(CHAPTERS[each.entry(TEXT)["chapter"]], each, id=each.measured.__name__)
    for each in CLAIMS
]


@pytest.mark.parametrize(("chapter", "claim"), WITH_CHAPTER)
def test_a_claim_has_its_verdict_and_its_numbers(chapter: Chapter, claim: Claim) -> None:
    entry = claim.entry(TEXT)
    assert f"](../../docs/claims.md#chapter-{chapter.number})" in lesson_of(chapter.name)
    assert TEXT[: entry.start()].rpartition("\n## ")[2].startswith(f"Chapter {chapter.number}\n")
    assert entry["verdict"] == claim.verdict
    assert claim.updated(TEXT) == TEXT, "run make measure WHAT=claims, and read what has changed"


def test_the_page_has_these_claims_and_no_others() -> None:
    assert TEXT.count("\n### ") == len({claim.entry(TEXT)["says"] for claim in CLAIMS})
    assert summary(CLAIMS) in " ".join(TEXT.split())
