"""Read course.toml, the file in which an instructor describes the assignments of a term."""
