"""Generated text of a page, between two comments."""

from __future__ import annotations


def between(page: str, begin: str, end: str) -> str:
    """Return the text between two comments.

    Raises:
        ValueError: The page lacks one of the comments.
    """
    return _split(page, begin, end)[1]


def with_text(page: str, begin: str, end: str, text: str) -> str:
    """Return a page with other text between two comments.

    Raises:
        ValueError: The page lacks one of the comments.
    """
    before, _, after = _split(page, begin, end)
    return f"{before}{begin}\n{text}\n{end}{after}"


def _split(page: str, begin: str, end: str) -> tuple[str, str, str]:
    before, found_begin, rest = page.partition(begin)
    inside, found_end, after = rest.partition(end)
    if not (found_begin and found_end):
        raise ValueError(f"the page lacks {begin!r} or {end!r}")
    return before, inside.strip("\n"), after
