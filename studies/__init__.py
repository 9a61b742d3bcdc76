"""Study an engine: plot its results, and measure how fast, accurate and stable it is."""
