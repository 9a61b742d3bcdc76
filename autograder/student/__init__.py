"""The commands that students use: check, watch, hint and reset."""
