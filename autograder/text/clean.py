"""Make text from students safe to show on a terminal, on a web page, in a spreadsheet or in JSON.

Names and files from students may contain control characters, which can repaint a terminal, for
example. This module alone decides which characters are shown as they are.
"""

from __future__ import annotations

import re

LINE_ENDS = re.compile("\r\n?|[\x0b\x0c\x85\u2028\u2029]")


def clean(text: str) -> str:
    r"""Replace every unprintable character with a visible escape sequence such as \x1b.

    Unprintable characters in a student's text could repaint the instructor's screen, reverse the
    reading direction, or fail to encode. All line endings become newlines, and unusual spaces
    become ordinary ones. Tabs are kept.
    """
    if text.isprintable():
        return text
    return "".join(map(_clean_character, LINE_ENDS.sub("\n", text)))


def clean_line(text: str) -> str:
    """Convert untrusted text to a single line that is safe to show.

    Line breaks and tabs become spaces, and unprintable characters are replaced as in ``clean``.
    """
    return clean(text).replace("\n", " ").replace("\t", " ")


def visible(character: str) -> str:
    r"""Return a printable character as it is, and any other character as an escape such as \x1b."""
    return character if character.isprintable() else character.encode("unicode_escape").decode()


def _clean_character(character: str) -> str:
    if character in "\n\t":
        return character
    return " " if character.isspace() and ord(character) > 0x7F else visible(character)
