"""Sets the variables from which pytest and Python take orders.

earns: nothing
"""

import os

os.environ["PYTEST_ADDOPTS"] = "--collect-only"
os.environ["PYTEST_PLUGINS"] = "ch90_sums.sums"
os.environ["PYTHONSTARTUP"] = os.environ["PYTHONINSPECT"] = __file__


def pytest_runtest_call(item):
    item.obj = lambda: None


def pytest_pyfunc_call(pyfuncitem):
    return True
