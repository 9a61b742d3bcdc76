"""Grade the submissions of a class, on one machine or on a cluster.

The way from a submission to the page that a student reads:

1. ``instructor.run_grade`` unpacks the submissions, and calls ``cohort.grade``.
2. ``cohort`` finds the people, chooses the ``conditions``, and starts a ``class_run``.
3. ``class_run`` has ``grading`` grade each submission (here, or through ``cluster``).
4. ``grading`` copies the student's files, as ``submissions.stage`` does, and runs the checks.
5. ``checks.runner`` starts a check process (``isolation.forked_checks``), and hears its events.
6. There, ``checks.pytest_plugin`` calls the student's code in a worker (see ``isolation``).
7. ``grading`` turns the verdicts into a ``StudentReport``, with the points from ``scores``.
8. ``class_run`` adds marks and lateness, and ``reports.results`` writes the report with its page.
9. ``cohort`` writes what is about the whole class, and the files for the platforms.
"""
