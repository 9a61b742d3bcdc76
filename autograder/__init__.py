"""Checks, grades and hands out the chapters of the companion."""
