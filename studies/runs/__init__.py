"""Simulations that work with any engine and return plain numbers, for plots and measurements."""
