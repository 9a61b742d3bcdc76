"""The lab: scenes that a student's own engine plays, in a browser, a window or a picture."""
