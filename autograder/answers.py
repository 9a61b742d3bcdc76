"""Written answers: answers.md holds a heading an exercise, its question quoted, then the answer."""

from __future__ import annotations

import re

PLACE = "_Write your answer here._"


def blank_answers(text: str) -> str:
    """Keep the headings and the quoted questions, and leave a place for each answer."""
    parts = []
    for section in _sections(text):
        heading, *rest = section.splitlines()
        question = "\n".join(line for line in rest if line.startswith(">"))
        parts.append("\n\n".join([heading, question, PLACE] if question else [heading]))
    return "\n\n".join(parts) + "\n"


def answered(text: str) -> set[str]:
    """Return the ids of the exercises that have an answer: the first word of their headings."""
    return {
        section.lstrip("# ").split()[0]
        for section in _sections(text)
        if section.startswith("## ") and PLACE not in section
    }


def _sections(text: str) -> list[str]:
    return [section for section in re.split(r"(?m)^(?=#)", text) if section.strip()]
