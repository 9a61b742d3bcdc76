"""Read course.toml, where an instructor writes down the assignments of a term.

Each assignment has its points, its due date and perhaps a policy for late work.
"""
