"""The commands with which students work on their exercises: check, watch, hint and reset."""
