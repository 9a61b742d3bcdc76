"""What make bench measures: a module a subject, with a function lines."""
