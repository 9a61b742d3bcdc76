"""The commands for working on exercises: check, watch, hint and reset."""
