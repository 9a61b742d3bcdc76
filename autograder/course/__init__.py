"""Read course.toml, the file in which an instructor describes the assignments of a term.

Each assignment lists its exercises and their points, and may have a due date and a penalty for late
work.
"""
