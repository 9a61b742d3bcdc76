"""Analyze the results of a class to find hard exercises and common mistakes."""
