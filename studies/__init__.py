"""Plots and measurements of the engine."""
