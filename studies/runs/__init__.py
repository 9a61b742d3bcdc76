"""Simulations that run on any engine and return plain numbers, for plots and measurements."""
