"""The file of a term, course.toml: its assignments, their points, due dates and late policies."""
