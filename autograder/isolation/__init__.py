"""Run a student's code in isolation, while trusted checks use the objects it creates.

    checks (pytest, trusted) -> handles -> wire -> worker (the student's code, in the sandbox)

- ``in_worker`` provides the chapters that checks import, and forks a new worker process from a
  ``template`` for each check.
- ``handles`` stand in for the student's objects in the checks' process.
- ``wire`` sends plain data between the two processes.
- ``sandbox`` restricts what the worker can do.

Nothing that comes from the ``worker`` and its ``server`` is trusted, because the student's code
runs in the same process.
"""
