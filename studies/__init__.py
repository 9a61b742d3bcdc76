"""Plots and measurements of an engine."""
