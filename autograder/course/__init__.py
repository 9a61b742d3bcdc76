"""Read course.toml, in which an instructor describes the assignments of a term.

Each assignment has points, a due date and perhaps a policy for late work.
"""
