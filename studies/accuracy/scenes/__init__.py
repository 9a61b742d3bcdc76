"""The scenes in which our engine is compared with pymunk, each with its exact solution."""
