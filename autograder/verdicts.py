"""The process that runs the checks: pytest with a recorder that reports each verdict as it falls.

The runner starts it as ``python -m autograder.verdicts CONFIG`` and reads one JSON object a line:
the list of checks first, then what starts and what its verdict is. Verdicts come from pytest's own
reports, never from text.
"""

from __future__ import annotations

import faulthandler
import importlib
import json
import os
import sys
from collections.abc import Callable, Generator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from autograder.explain import explain_exception, explain_import

Report = Callable[..., None]
# Built-in plugins that no check uses; leaving them out saves a sixth of the time to the answer.
UNUSED_PLUGINS = (
    "terminal cacheprovider doctest faulthandler junitxml legacypath logging pastebin setuponly "
    "setupplan stepwise unittest debugging warnings unraisableexception threadexception"
)


class Recorder:
    """A pytest plugin that picks the checks to run, limits their time and reports verdicts."""

    def __init__(self, config: dict[str, Any], report: Report) -> None:
        self.config = config
        self.report = report
        self.engine_folders = [Path(folder).resolve() for folder in config["engine"]]
        self.stack_file = Path(config["stack_file"]).open("w")  # noqa: SIM115 - lives as long as we

    def pytest_sessionstart(self) -> None:
        """Import the student's modules before any check does, so that a bad one stops no other."""
        for module, message in self.config["broken"].items():
            sys.modules[module] = _BrokenModule(module, message)
        for module in self.config["modules"]:
            if module not in sys.modules:
                self._import(module)

    def _import(self, module: str) -> None:
        self.report(event="import", module=module)
        self._start_clock()
        # A source edited twice within a second would be taken for its own stale bytecode.
        sys.dont_write_bytecode = True
        try:
            imported = importlib.import_module(module)
            imported.__dict__.setdefault("__getattr__", _missing_from(imported))
        except pytest.fail.Exception as error:  # it uses another module that is broken
            sys.modules[module] = _BrokenModule(module, str(error))
        except BaseException as error:  # SystemExit among them
            message = explain_import(error, module, self.engine_folders)
            sys.modules[module] = _BrokenModule(module, message)
        finally:
            sys.dont_write_bytecode = False
            faulthandler.cancel_dump_traceback_later()

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """Leave the reason where the runner looks for it when the checks cannot be collected."""
        if report.failed:
            print(report.longreprtext, file=sys.stderr)

    def pytest_collection_modifyitems(
        self, config: pytest.Config, items: list[pytest.Item]
    ) -> None:
        """Sort the checks by the manifest's order, tell the runner, and leave out what is done."""
        order = {exercise: place for place, exercise in enumerate(self.config["exercises"])}
        items[:] = [item for item in items if _marker(item).args[0] in order]
        items.sort(key=lambda item: order[_marker(item).args[0]])
        checks = [
            {
                "name": item.name,
                "exercise": _marker(item).args[0],
                "weight": _marker(item).kwargs.get("weight", 1),
            }
            for item in items
        ]
        self.report(event="checks", checks=checks)
        left_out = [item for item in items if item.name in self.config["done"]]
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if item not in left_out]

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_call(self, item: pytest.Item) -> Generator[None, Any, Any]:
        """Hold the check itself to the time limit."""
        self.report(event="start", name=item.name)
        self._start_clock()  # until its report is made: a student's exception may hang in its str
        return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(
        self, item: pytest.Item, call: pytest.CallInfo[None]
    ) -> Generator[None, pytest.TestReport, pytest.TestReport]:
        """Report what became of the check; trouble outside its body is the grader's fault."""
        # Ours is the only reader, so pytest need not lay its traceback out: that takes four times
        # as long as all the rest.
        setattr(item, "repr_failure", str)  # noqa: B010
        report = yield
        if report.when == "call" and report.passed:
            self.report(event="verdict", name=item.name, status="passed", message="")
        elif call.excinfo is not None:
            status = "failed" if report.when == "call" else "error"
            error = call.excinfo.value
            if isinstance(error, pytest.fail.Exception):
                message = str(error)
            else:
                message = explain_exception(error, self.engine_folders, self.config["complete"])
            if printed := report.capstdout.strip():
                message += f"\nprinted   {printed[:2000]}"
            self.report(event="verdict", name=item.name, status=status, message=message)
        faulthandler.cancel_dump_traceback_later()
        return report

    def pytest_sessionfinish(self, exitstatus: int) -> None:
        code = pytest.ExitCode
        if exitstatus in (code.OK, code.TESTS_FAILED, code.NO_TESTS_COLLECTED):
            self.report(event="end")

    def _start_clock(self) -> None:
        """Write the stack and end the process when the time is up, whatever the code is doing."""
        faulthandler.dump_traceback_later(
            self.config["time_limit"], exit=True, file=self.stack_file
        )


class _BrokenModule(ModuleType):
    """Stands for a module that cannot be imported: whatever is used of it fails the check."""

    def __init__(self, name: str, message: str) -> None:
        super().__init__(name)
        self._message = message

    def __getattr__(self, name: str) -> Any:
        return _broken_name(name, self._message)


def _missing_from(module: ModuleType) -> Callable[[str], Any]:
    """Return what answers for the names that a student's module does not define."""
    file = module.__name__.replace(".", "/") + ".py"
    empty = all(name.startswith("__") for name in vars(module))
    says = f"{file} is empty and" if empty else file
    return lambda name: _broken_name(name, f"{says} does not define {name}")


def _broken_name(name: str, message: str) -> Any:
    """Return what stands for a name that is not there: a class, or a function, that fails."""
    if name.startswith("__"):
        raise AttributeError(name)

    class BrokenMeta(type):
        def __call__(cls, *args: Any, **kwargs: Any) -> Any:  # noqa: ARG002
            pytest.fail(message, pytrace=False)

    return BrokenMeta(name, (), {})


def _marker(item: pytest.Item) -> pytest.Mark:
    marker = item.get_closest_marker("exercise")
    if marker is None or not marker.args:
        raise pytest.UsageError(f"{item.nodeid} has no exercise marker with an id")
    return marker


def main() -> int:
    """Run the checks that the configuration on the command line names."""
    config = json.loads(sys.argv[1])
    wire = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what the student prints is no verdict

    def report(**event: Any) -> None:
        wire.write(json.dumps(event) + "\n")
        wire.flush()

    arguments = [config["tests"], "--capture=sys", f"--rootdir={config['root']}"]
    arguments += [f"--seed={config['seed']}", *(f"--engine={path}" for path in config["engine"])]
    for plugin in UNUSED_PLUGINS.split():
        arguments += ["-p", f"no:{plugin}"]
    return int(pytest.main(arguments, plugins=[Recorder(config, report)]))


if __name__ == "__main__":
    # Threads or exit handlers that the student's code left behind must not hold the process.
    code = main()
    sys.stderr.flush()
    os._exit(code)
