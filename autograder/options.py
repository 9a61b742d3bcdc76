"""Read the tables of commands, commands.toml and instructor.toml, and build what follows from them.

The tables describe the options of each command, for Python's command line and for make.
"""

from __future__ import annotations

import argparse
import tomllib
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from autograder.manifest import ROOT

TYPES: dict[str, Any] = {"int": int, "float": float, "path": Path}
Table = dict[str, dict[str, Any]]


@cache
def read_table(name: str) -> Table:
    """Return the commands of a table, each with its help and its options in order."""
    text = (ROOT / "autograder" / f"{name}.toml").read_text(encoding="utf-8")
    table = tomllib.loads(text)
    for command in table["command"].values():
        own = {**table["option"], **command}
        command["options"] = {option: own[option] for option in command["takes"].split()}
    commands: Table = table["command"]
    return commands


def add_commands(
    commands: argparse._SubParsersAction[argparse.ArgumentParser], table: str, module: ModuleType
) -> None:
    """Add the commands of a table to the command line, except those of other packages."""
    for name, entry in read_table(table).items():
        if "module" in entry:
            continue
        command = commands.add_parser(name, help=entry["help"])
        for option in entry["options"].values():
            kept = {key: option[key] for key in ("help", "default", "required") if key in option}
            if option.get("switch") or option.get("off"):
                kept["action"] = "store_true"
            else:
                kept["type"] = TYPES.get(option.get("type", ""), str)
            if option.get("optional"):
                kept["nargs"] = "?"
            command.add_argument(option["flag"], **kept)
        command.set_defaults(run=getattr(module, f"run_{name}"))


def makefile(table: str) -> str:
    """Return the file for make that says which variables each command takes, and passes them on."""
    lines = [f"# `make update` writes this file from autograder/{table}.toml."]
    for name, entry in read_table(table).items():
        if entry.get("without_make"):
            continue
        options = {key: option for key, option in entry["options"].items() if key.isupper()}
        words = [_for_make(*item) for item in options.items() if "recipe" not in item[1]]
        lines.append(f"TAKES_{name} := {' '.join(options)}".rstrip())
        lines.append(f"OPTIONS_{name} = {' '.join(words)}".rstrip())
    return "\n".join(lines) + "\n"


def _for_make(variable: str, option: dict[str, Any]) -> str:
    """Return how make passes a variable on. It passes nothing if the user has not set it."""
    flag = option["flag"]
    if option.get("switch"):
        return f"$(if $({variable}),{flag})"
    if option.get("off"):
        return f"$(if $(filter 0,$({variable})),{flag})"
    if option.get("repeated"):
        return f"$(foreach {variable},$(value {variable}),{flag} $(call typed,{variable}))"
    return f"$(call option,{flag},{variable})" if flag[0] == "-" else f"$(call typed,{variable})"
