"""Other people's words, made harmless for a terminal, a page, a spreadsheet and a JSON file.

This is the one place that decides which characters may be shown.
"""

from __future__ import annotations

import re

LINE_ENDS = re.compile("\r\n?|[\x0b\x0c\x85\u2028\u2029]")


def clean(text: str) -> str:
    """Return a text in which every character that cannot be printed is written as an escape.

    Such characters repaint a screen, reverse the reading direction, or cannot be encoded. Line ends
    become newlines, tabs stay, and unusual spaces become ordinary ones.
    """
    if text.isprintable():
        return text
    return "".join(map(_clean_character, LINE_ENDS.sub("\n", text)))


def clean_line(text: str) -> str:
    """Return a clean text in one line."""
    return clean(text).replace("\n", " ").replace("\t", " ")


def visible(character: str) -> str:
    """Return a character that can be printed, or the escape of one that cannot."""
    return character if character.isprintable() else character.encode("unicode_escape").decode()


def _clean_character(character: str) -> str:
    if character in "\n\t":
        return character
    return " " if character.isspace() and ord(character) > 0x7F else visible(character)
