"""Measure how fast, accurate and stable the course's physics engine is, and plot its results."""
