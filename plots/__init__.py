"""Plots for each chapter, drawn by `make plot` with the functions of a student's engine."""
