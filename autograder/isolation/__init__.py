"""Run untrusted code in isolation, while trusted checks use the objects that it creates.

    checks (pytest, trusted) -> handles -> wire -> worker (the student's code, in the sandbox)

- ``in_worker`` provides the chapters that checks import. It gives each check a new worker process,
  which is forked from a ``template``.
- ``handles`` stand for the student's objects in the process of the checks.
- ``wire`` sends plain data between the two processes.
- ``sandbox`` restricts what the worker can do.

Only the ``worker`` and its ``server`` run on the untrusted side.
"""
