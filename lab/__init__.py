"""Interactive scenes that run on a student's own engine, in a browser, a window or a picture."""
