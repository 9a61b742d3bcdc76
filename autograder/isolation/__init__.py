"""Run a student's code in a sandbox, in a different process from the checks that grade it.

The checks are pytest tests in a trusted process, the check process. They use the student's objects
through handles:

    check process (pytest, trusted) -> handles -> wire -> worker (student's code, in sandbox)

For each check, ``in_worker`` starts a new worker, forked from a ``launcher``. The ``sandbox``
restricts what it can do.

Nothing that a worker sends is trusted, because the student's code runs in the same process and
could have forged it.
"""
