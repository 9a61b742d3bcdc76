"""Run interactive physics scenes on a student's engine: in a browser, a window or a recording."""
