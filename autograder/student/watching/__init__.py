"""The command `watch`, which checks a student's code after every save."""
