"""Run a student's code in a sandbox, in a different process from the checks that grade it.

The checks are pytest tests in a trusted process. They use the student's objects through handles:

    checks (pytest, trusted) -> handles -> wire -> worker (the student's code, in the sandbox)

- ``in_worker`` provides the chapters that the checks import. For each check it starts a new worker,
  forked from a ``launcher``.
- ``handles`` stand in for the student's objects in the checks' process.
- ``wire`` sends plain data between the two processes.
- ``sandbox`` restricts what the worker can do.

Nothing that a worker sends is trusted, because the student's code runs in the same process and
could have forged it.
"""
