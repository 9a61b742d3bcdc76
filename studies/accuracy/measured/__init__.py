"""The scenes in which our engine is compared with pymunk, each with its exact solution.

They range from a projectile to a net that catches a ball.
"""
