"""Run simulations with any engine, and return plain numbers for plots and measurements."""
