"""Where untrusted code runs, and how the checks reach it.

    checks (pytest, trusted) -> handles -> wire -> worker (the student's code, behind walls)

``in_worker`` serves the checks' imports of chapters and gives each check a fresh worker, forked
from a ``template``. ``handles`` stand for the student's objects, ``wire`` carries plain data,
``sandbox`` puts up the walls. Only the ``worker`` and its ``server`` run on the other side.
"""
