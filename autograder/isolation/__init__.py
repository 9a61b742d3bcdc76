"""Isolate untrusted code, and let the checks reach it.

    checks (pytest, trusted) -> handles -> wire -> worker (the student's code, in the sandbox)

``in_worker`` serves the checks' imports of chapters and gives each check a fresh worker, forked
from a ``template``. ``handles`` represent the student's objects, ``wire`` carries plain data, and
``sandbox`` confines the worker. Only the ``worker`` and its ``server`` run on the untrusted side.
"""
