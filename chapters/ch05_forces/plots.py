"""Plots."""
PLOTS = ()
