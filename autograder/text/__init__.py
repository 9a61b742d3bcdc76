"""Fit text to the screen, and make text from students safe to show."""
