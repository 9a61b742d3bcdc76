"""Interactive scenes, which run a student's own engine in a browser, a window or a picture."""
