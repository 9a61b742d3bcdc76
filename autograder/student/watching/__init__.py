"""The `watch` command, which checks a student's code after every save."""
