"""Studies of an engine: its plots, and measurements of speed, accuracy and stability."""
