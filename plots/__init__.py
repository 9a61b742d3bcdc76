"""Plots for each chapter, drawn by `make plot` with the functions of a student's engine.

Their titles report measured results that reveal bugs. What is not written yet is left out.
"""
