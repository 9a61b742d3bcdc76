"""Read the command lines that the README pages print."""

from __future__ import annotations

import re

from autograder.manifest import ROOT

PAGES = [
    *("README.md", "docs/study_guide.md", "docs/learning_path.md", "docs/CONTRIBUTING.md"),
    *(f"{folder}/README.md" for folder in ("autograder", "sample_class", "lab", "web", "studies")),
    *("tests/README.md", "solutions/README.md"),
]
MAKEFILES = [
    "Makefile",
    "autograder/recipes.mk",
    "autograder/commands.mk",
    "autograder/instructor.mk",
]
# The variables that each command of make takes.
TAKES = {
    name: variables.split()
    for file in MAKEFILES
    for name, variables in re.findall(
        r"(?m)^TAKES_([\w-]+) :=(.*)$", (ROOT / file).read_text(encoding="utf-8")
    )
}
INLINE = r"(?<!`)`((?:[A-Z]+=\S+ )?(?:make [^\s`]+|\.venv/bin/python|python3)\s[^`]+)`"
BLOCK = re.compile(rf"(?ms)^```sh\n(.+?)^```|{INLINE}")


def command_lines(page: str) -> list[str]:
    """Return the command lines of a page in their order, without comments and repetitions.

    A line with an ellipsis stands for several commands, and is left out.
    """
    text = (ROOT / page).read_text(encoding="utf-8")
    lines = [
        " ".join(line.partition(" #")[0].split())
        for block, inline in BLOCK.findall(text)
        for line in (block or inline.replace("\n", " ")).splitlines()
    ]
    return [line for line in dict.fromkeys(lines) if line and "..." not in line]
