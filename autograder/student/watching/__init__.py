"""The command watch, which checks the code of a student after every save."""
