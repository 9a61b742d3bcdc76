"""Make text from students safe to show on a terminal, on a web page, in a spreadsheet or in JSON.

A student's file or name can contain control characters that do harm as soon as they are displayed.
All rules about the characters that may be shown are in this module.
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
    """Make untrusted text safe to show, as ``clean`` does, and join its lines into a single one."""
    return clean(text).replace("\n", " ").replace("\t", " ")


def visible(character: str) -> str:
    r"""Return a printable character unchanged, and any other as an escape such as \x1b."""
    return character if character.isprintable() else character.encode("unicode_escape").decode()


def _clean_character(character: str) -> str:
    if character in "\n\t":
        return character
    return " " if character.isspace() and ord(character) > 0x7F else visible(character)
