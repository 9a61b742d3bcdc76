"""Run and record interactive physics scenes on a student's engine, in a browser or a window."""
