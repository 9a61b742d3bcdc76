"""Run a student's code in isolation, while checks that we trust use the objects it creates.

    checks (pytest, trusted) -> handles -> wire -> worker (the student's code, in the sandbox)

- ``in_worker`` provides the chapters that checks import. For each check it forks a new worker
  process from a ``template``.
- ``handles`` stand for the student's objects in the process of the checks.
- ``wire`` sends plain data between the two processes.
- ``sandbox`` restricts what the worker can do.

We do not trust anything that comes from the ``worker`` and its ``server``, because the student's
code runs in the same process.
"""
