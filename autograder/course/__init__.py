"""Read course.toml, which lists the assignments, points, due dates and late policies of a term."""
