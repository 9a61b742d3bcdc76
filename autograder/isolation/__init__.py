"""Run a student's code in a sandbox, in a different process from the checks that grade it.

The checks are pytest tests in a trusted process. They use the student's objects through handles:

    checks (pytest, trusted) -> handles -> wire -> worker (the student's code, in the sandbox)

For each check, ``in_worker`` starts a new worker, forked from a ``launcher``. The ``sandbox``
restricts what it can do.

Nothing that a worker sends is trusted, because the student's code runs in the same process and
could have forged it.
"""
