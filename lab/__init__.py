"""Run interactive scenes with a student's own engine, in a browser, in a window or as a picture."""
