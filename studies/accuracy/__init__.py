"""Measure how long our engine and pymunk take to simulate a scene to a given accuracy.

The scenes range from a projectile to a rope bridge. Each of them has an exact solution, and the
error of a simulation is its distance from that solution.
"""
