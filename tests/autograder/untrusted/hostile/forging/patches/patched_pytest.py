"""Makes pytest report that everything passed.

earns: nothing
"""

import sys

sys.path.append("@SITE@")
try:
    from _pytest import python, reports, runner

    python.Function.runtest = lambda self: None
    original = reports.TestReport.from_item_and_call.__func__

    def passed(cls, item, call):
        call.excinfo = None
        return original(cls, item, call)

    reports.TestReport.from_item_and_call = classmethod(passed)
    runner.TestReport = reports.TestReport
except BaseException:
    pass
