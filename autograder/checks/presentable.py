"""Make the message of a failed check safe to display."""

from __future__ import annotations

import re

from autograder.message import Message, with_texts
from autograder.text.clean import clean

LONGEST_MESSAGE = 8000  # characters; a message contains returned values, and these may be huge
LONGEST_PART = 800  # characters; if the whole message is too long, each part is cut to this length
ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")  # where an object is in memory differs in every run


def presentable(message: Message) -> Message:
    """Escape special characters, remove memory addresses, and shorten long texts."""
    message = with_texts(message, lambda text: ADDRESS.sub("", clean(text)))
    return message if len(str(message)) <= LONGEST_MESSAGE else with_texts(message, _cut)


def _cut(text: str) -> str:
    if len(text) <= LONGEST_PART:
        return text
    return f"{text[: LONGEST_PART - 50]} ... ({len(text)} characters in all)"
