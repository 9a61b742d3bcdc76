"""Measure how long our engine and pymunk take to simulate a scene to a given accuracy."""
