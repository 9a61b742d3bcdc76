"""An interpreter with the student's engine imported, for trying things out."""

from __future__ import annotations

import code
import importlib
import re
import sys
from contextlib import suppress
from pathlib import Path
from types import ModuleType
from typing import Any

from autograder.diagnosis.faults import fault_of
from autograder.manifest import Chapter
from autograder.student.show import remember_paths, show

OF_A_CHAPTER = re.compile(r"ch\d\d_")  # the beginning of a module's name


def interact(chapters: list[Chapter], folders: list[Path]) -> None:
    """Start an interpreter in which all names of the chapters are defined."""
    sys.path += map(str, folders)
    sys.dont_write_bytecode = True  # stale bytecode could hide a quick change
    names: dict[str, Any] = {"__name__": "__main__", "__builtins__": __builtins__}

    def reload() -> None:
        """Import your engine again. Objects that you made before keep the old code."""
        for found in import_engine(chapters, folders).values():
            names.update(found)
        print("Your engine is imported again. Objects made before keep the old code.")

    names |= {"show": show, "reload": reload}
    print(f"Python {sys.version.split()[0]} with your engine:")
    for chapter, found in import_engine(chapters, folders).items():
        print(f"  chapter {chapter}: {', '.join(found) or 'nothing yet'}")
        names |= found
    print("After you save a file: reload(). A picture: show(v, w) or show(particle). End: exit()")
    if sys.platform != "win32":  # where there is no readline
        with suppress(ImportError):  # some Pythons are built without it
            import readline
            import rlcompleter

            readline.set_completer(rlcompleter.Completer(names).complete)
            readline.parse_and_bind("tab: complete")
    code.interact(banner="", local=names, exitmsg="")


def import_engine(chapters: list[Chapter], folders: list[Path]) -> dict[int, dict[str, Any]]:
    """Import the modules of chapters afresh, and return the names that each chapter defines."""
    for name in [name for name in sys.modules if OF_A_CHAPTER.match(name)]:
        del sys.modules[name]
    importlib.invalidate_caches()
    engine: dict[int, dict[str, Any]] = {}
    for chapter in chapters:
        found = engine[chapter.number] = {}
        for file in chapter.edited_files:
            try:
                module = importlib.import_module(f"{chapter.name}.{file.removesuffix('.py')}")
                found |= public(module)
            except (Exception, SystemExit) as error:
                print(f"{chapter.name}/{file} cannot be imported: {reason(error, folders)}")
        if "Particle" in found:
            remember_paths(found["Particle"])
    return engine


def reason(error: BaseException, folders: list[Path]) -> str:
    """Say why a student's module could not be imported, with the line of the mistake."""
    fault = fault_of(error, [folder.resolve() for folder in folders])
    if fault.syntax:
        return f"{fault.first_line} (line {fault.syntax[1]}: {fault.syntax[2]})"
    return f"{fault.first_line} ({fault.frames[-1]})" if fault.frames else fault.first_line


def public(module: ModuleType) -> dict[str, Any]:
    """Return the functions, classes and constants that a module defines for its users."""
    return {
        name: value
        for name, value in vars(module).items()
        if not name.startswith("_")
        and (name.isupper() or getattr(value, "__module__", "") == module.__name__)
    }
