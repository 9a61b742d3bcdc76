"""Decide which characters of students' texts are shown as they are, wherever text is shown."""

from __future__ import annotations

import re

LINE_ENDS = re.compile("\r\n?|[\x0b\x0c\x85\u2028\u2029]")


def clean(text: str) -> str:
    r"""Replace every unprintable character with a visible escape sequence such as \x1b.

    Unprintable characters could repaint the instructor's screen, reverse the reading direction, or
    fail to encode. All line endings become newlines, and unusual spaces ordinary ones. Tabs stay.
    """
    if text.isprintable():
        return text
    return "".join(
        one if one in "\n\t" else " " if one.isspace() and ord(one) > 0x7F else visible(one)
        for one in LINE_ENDS.sub("\n", text)
    )


def clean_line(text: str) -> str:
    """Convert text to one clean line, in which line breaks and tabs become spaces."""
    return clean(text).replace("\n", " ").replace("\t", " ")


def visible(character: str) -> str:
    r"""Return a printable character as it is, and any other character as an escape such as \x1b."""
    return character if character.isprintable() else character.encode("unicode_escape").decode()
