"""Studies of an engine: plots of it, and measurements of its speed, accuracy and stability."""
