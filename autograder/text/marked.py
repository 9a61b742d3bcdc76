"""Generated text of a page, between two comments."""

from __future__ import annotations


def between(page: str, begin: str, end: str) -> str:
    """Return the text between two comments, or raise ValueError if the page lacks one of them."""
    inside, found, _ = page.partition(begin)[2].partition(end)
    if not found:
        raise ValueError(f"the page lacks {begin!r} or {end!r}")
    return inside.strip("\n")


def with_text(page: str, begin: str, end: str, text: str) -> str:
    """Return a page with other text between two comments, as ``between`` finds it."""
    between(page, begin, end)
    before, _, rest = page.partition(begin)
    return f"{before}{begin}\n{text}\n{end}{rest.partition(end)[2]}"
