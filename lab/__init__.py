"""Run interactive scenes on a student's engine: in a browser, in a window, or as a recording."""
