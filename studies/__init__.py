"""Studies of the physics engine: how fast, accurate and stable it is, and plots of its results."""
