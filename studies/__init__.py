"""Study an engine: plot its results, and measure its speed, its accuracy and its stability."""
