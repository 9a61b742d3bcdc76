"""Make untrusted text safe to show on a terminal or page, in a spreadsheet and in a JSON file.

This is the only module that decides which characters may be shown.
"""

from __future__ import annotations

import re

LINE_ENDS = re.compile("\r\n?|[\x0b\x0c\x85\u2028\u2029]")


def clean(text: str) -> str:
    """Return the text with every unprintable character replaced by an escape sequence.

    Unprintable characters could repaint the screen, reverse the reading direction or fail to
    encode. Line endings become newlines, tabs are kept, and unusual spaces become ordinary spaces.
    """
    if text.isprintable():
        return text
    return "".join(map(_clean_character, LINE_ENDS.sub("\n", text)))


def clean_line(text: str) -> str:
    """Return the cleaned text on a single line."""
    return clean(text).replace("\n", " ").replace("\t", " ")


def visible(character: str) -> str:
    """Return ``character`` unchanged if it is printable. Otherwise return an escape sequence."""
    return character if character.isprintable() else character.encode("unicode_escape").decode()


def _clean_character(character: str) -> str:
    if character in "\n\t":
        return character
    return " " if character.isspace() and ord(character) > 0x7F else visible(character)
